#ifndef auxfem_tests_verification_tumbling_cell_h
#define auxfem_tests_verification_tumbling_cell_h

#include <support/scene_text.h>

namespace auxfem
{
  namespace testing_support
  {
    constexpr unsigned int n_long_steps = 100000;

    /** A free star cell of nylon strips, thrown by its upper half, for
     * n_long_steps. */
    inline SceneText tumbling_cell()
    {
      constexpr double dt = 20e-6;
      return SceneText()
        .add("Lattice",
             "Cell = star | Strut length = 20 mm | Opening angle = 60 deg")
        .rectangle("strip", "20 mm", "0.5 mm", {"2 GPa", 1140, 0.4})
        .add("Initial velocities/throw",
             "Joints = top | Velocity x = 18 | Velocity y = -30")
        .mesh(2)
        .time(n_long_steps * dt, dt);
    }
  } // namespace testing_support
} // namespace auxfem

#endif
