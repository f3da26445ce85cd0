#ifndef auxfem_tests_analysis_small_motions_held_rod_h
#define auxfem_tests_analysis_small_motions_held_rod_h

#include <support/scene_text.h>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * An axially vibrating rod of 1 m, fixed at its left end, with the
     * stiffness @p EA (N), the mass @p mass (kg), elements of order 4 and the
     * damping @p beta (s).
     */
    inline SceneText held_rod(const double       EA,
                              const double       mass,
                              const double       beta,
                              const unsigned int elements)
    {
      SceneText scene;
      scene.frame("0 0; 1 0; 0.5 0", "0 2; 2 1")
        .section({EA, 1e6, 1e6})
        .set("Sections/section 0/Density", mass / EA)
        .set("Sections/section 0/Stiffness-proportional damping", beta)
        .support("wall", "0", "clamp")
        .support("guide", "1, 2", "roller x")
        .mesh(4, elements)
        .set("Effects/Rotary inertia", "off")
        .set("Effects/Strut damping", "on")
        .set("Effects/Connector viscosity", "on");
      return scene.time(1, 0.1, "newmark");
    }
  } // namespace testing_support
} // namespace auxfem

#endif
