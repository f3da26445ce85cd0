#ifndef auxfem_tests_verification_space_frame_h
#define auxfem_tests_verification_space_frame_h

#include <auxfem/elements/rotation.h>

#include <support/scene_run.h>
#include <verification/rigid_frame.h>

namespace auxfem
{
  namespace testing_support
  {
    /** A free-form frame in space. */
    inline std::string space(const std::string &joints,
                             const std::string &struts)
    {
      return "set Dimension = 3\n" + frame(joints, struts);
    }

    /** A rigid part of struts with a rotation of its own, whatever its shape.
     */
    inline std::string body(const std::string &struts,
                            const double       mass,
                            const SpaceVector &inertia)
    {
      return "subsection Rigid parts\n subsection body\n  set Struts = " +
        struts + "\n  set Mass = " + text(mass) +
        "\n  set Rotary inertia = " + text(inertia[0]) + " " +
        text(inertia[1]) + " " + text(inertia[2]) +
        "\n  set Elastic struts = clamped\n end\nend\n";
    }

    /** Motion of all joints about the mean of their positions. */
    inline std::string initial_motion(const SpaceVector &velocity,
                                      const SpaceVector &angular_velocity)
    {
      std::string result =
        "subsection Initial velocities\n subsection spin\n  set Joints = all\n";
      const char axes[] = {'x', 'y', 'z'};
      for (unsigned int c = 0; c < 3; ++c)
        result += std::string("  set Velocity ") + axes[c] + " = " +
          text(velocity[c]) + "\n  set Angular velocity " + axes[c] + " = " +
          text(angular_velocity[c]) + "\n";
      return result + " end\nend\n";
    }

    /** Three unknowns of rigid part @p part from component @p first on. */
    inline SpaceVector of_part(const SceneRun    &run,
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
