#ifndef auxfem_tests_verification_space_frame_h
#define auxfem_tests_verification_space_frame_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/space_text.h>

namespace auxfem
{
  namespace testing_support
  {
    /** Section of a frame that bends and twists by more than a radian. */
    inline const std::string rod_of_frame =
      "Shape = rectangle | Width = 0.12 | Height = 0.05 | "
      "Young's modulus = 3e4 | Poisson's ratio = 0.3 | Density = 100";

    /** A rigid part of struts with a rotation of its own, whatever its shape.
     */
    inline SceneText body(const std::string &struts,
                          const double       mass,
                          const SpaceVector &inertia)
    {
      return SceneText()
        .rigid_part("body", struts, mass)
        .add("Rigid parts/body",
             "Rotary inertia = " + text(inertia) +
               " | Elastic struts = clamped");
    }

    /** Motion of all joints about the mean of their positions. */
    inline SceneText initial_motion(const SpaceVector &velocity,
                                    const SpaceVector &angular_velocity)
    {
      const std::string path = "Initial velocities/spin/";
      SceneText         scene;
      scene.set(path + "Joints", "all");
      set_vector(scene, path + "Velocity", velocity);
      set_vector(scene, path + "Angular velocity", angular_velocity);
      return scene;
    }

    /** Three unknowns of rigid part @p part from component @p first on. */
    inline SpaceVector part_vector(const SceneRun    &run,
                                   const Vector      &vector,
                                   const unsigned int first,
                                   const unsigned int part = 0)
    {
      SpaceVector result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] =
          vector[run.model.numbering.constraints().motion(part, first + c)];
      return result;
    }

    /** Rotation of rigid part 0. */
    inline Quaternion rotation_of_part(const SceneRun &run)
    {
      return exponential(
        run.equations.reporting().rigid_parts->rotation(0, run.state));
    }
  } // namespace testing_support
} // namespace auxfem

#endif
