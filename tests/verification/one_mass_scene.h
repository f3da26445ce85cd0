#ifndef auxfem_tests_verification_one_mass_scene_h
#define auxfem_tests_verification_one_mass_scene_h

#include <verification/frame_text.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * Text of a scene with one degree of freedom: joint 0 moves along x only
     * and hangs on one connector to the ground. Its extension is minus the
     * displacement of the joint. The strut a frame must have is held at both
     * ends and takes no part.
     * @param link entries of the connector, e.g. its law
     * @param time entries of the subsection Time
     * @param more further subsections
     */
    inline std::string one_mass_scene(const std::string &link,
                                      const std::string &time,
                                      const std::string &more = "")
    {
      return R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 0 -1; 1 -1
  set Struts = 1 2
end
subsection Sections
  subsection idle
    set Shape           = circle
    set Radius          = 1e-3
    set Young's modulus = 1
    set Density         = 1
  end
end
subsection Supports
  subsection idle
    set Joints = 1, 2
    set Type   = clamp
  end
  subsection guide
    set Joints = 0
    set Type   = roller x
  end
end
subsection Connectors
  subsection link
    set Between   = ground: 0
    set Geometry  = direction
    set Direction = 1 0
)" + link +
        R"(
  end
end
subsection Discretization
  set Order = 1
end
subsection Effects
  set Large rotation = off
end
subsection Newton
  set Tolerance = 1e-13
end
subsection Time
)" + time +
        R"(
end
)" + more;
    }

    /** Subsections that give joint 0 a mass (kg) and a velocity (m/s) at t = 0.
     */
    inline std::string mass_and_velocity(const double mass,
                                         const double velocity)
    {
      return "subsection Masses\n subsection body\n  set Joints = 0\n  set Mass = " +
        text(mass) +
        "\n end\nend\nsubsection Initial velocities\n subsection push\n"
        "  set Joints = 0\n  set Velocity x = " +
        text(velocity) + "\n end\nend\n";
    }
  } // namespace testing_support
} // namespace auxfem

#endif
