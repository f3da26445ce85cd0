#ifndef auxfem_tests_study_swinging_beam_h
#define auxfem_tests_study_swinging_beam_h

#include <support/scene_text.h>

namespace auxfem
{
  namespace testing_support
  {
    /** A cantilever under a growing force, in @p n_steps steps. */
    inline SceneText swinging_beam(const double end, const unsigned int n_steps)
    {
      SceneText scene;
      scene.frame("0 0; 1 0", "0 1");
      scene.circle("rod", 0.02, {1e9, 1000, 0.3});
      scene.support("clamp", "0", "clamp");
      scene.load("push", "1", {"0", "-200 * t^3", "0"});
      return scene.time(end, end / n_steps).probe("tip", "1");
    }
  } // namespace testing_support
} // namespace auxfem

#endif
