#ifndef auxfem_tests_verification_rigid_frame_h
#define auxfem_tests_verification_rigid_frame_h

#include <verification/frame_text.h>

#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** A free-form frame. */
    inline std::string frame(const std::string &joints,
                             const std::string &struts)
    {
      return "subsection Lattice\n set Cell = frame\n set Joints = " + joints +
        "\n set Struts = " + struts + "\nend\n";
    }

    /** A rigid part of struts, with its mass in kg. */
    inline std::string
    part(const std::string &name, const std::string &struts, const double mass)
    {
      return "subsection Rigid parts\n subsection " + name +
        "\n  set Struts = " + struts + "\n  set Mass = " + text(mass) +
        "\n end\nend\n";
    }

    /** Holds joints, which may turn. */
    inline std::string pin(const std::string &joints)
    {
      return "subsection Supports\n subsection pivot\n  set Joints = " +
        joints + "\n  set Type = pin\n end\nend\n";
    }

    /** Time step and end (s). */
    inline std::string time(const double dt, const double end)
    {
      return "subsection Time\n set Time step = " + text(dt) +
        "\n set End time = " + text(end) + "\nend\n";
    }
  } // namespace testing_support
} // namespace auxfem

#endif
