#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A strut without shear flexibility to speak of, EI = 2e-6 m^4 E. */
  std::string section(const std::string &name,
                      const std::string &strut,
                      const std::string &modulus)
  {
    return "  subsection " + name + "\n    set Struts = " + strut +
      "\n"
      "    set Shape = given\n"
      "    set Area = 0.01\n"
      "    set Shear area = 0.01\n"
      "    set Second moment of area = 2e-6\n"
      "    set Poisson's ratio = 0\n"
      "    set Young's modulus = " +
      modulus + "\n  end\n";
  }

  /**
   * A stiff strut of 1 m under 1 kN along its axis, and a weak one of 1 m that
   * a moment winds up to a full circle, M = 2 pi EI/L: 1.3e-7 N m.
   */
  std::string scene(const std::string &joints,
                    const std::string &struts,
                    const std::string &clamped,
                    const std::string &wound)
  {
    return "set Dimension = 2\n"
           "subsection Lattice\n"
           "  set Cell = frame\n"
           "  set Joints = " +
      joints + "\n  set Struts = " + struts +
      "\nend\n"
      "subsection Sections\n" +
      section("stiff", "0", "1e6") + section("weak", "1", "1e-2") +
      "end\n"
      "subsection Supports\n"
      "  subsection wall\n"
      "    set Joints = " +
      clamped +
      "\n    set Type = clamp\n"
      "  end\n"
      "end\n"
      "subsection Loads\n"
      "  subsection pull\n"
      "    set Joints = 1\n"
      "    set Force x = 1e3\n"
      "  end\n"
      "  subsection wind\n"
      "    set Joints = " +
      wound +
      "\n    set Moment z = 4 * pi * t * 1e-8\n"
      "  end\n"
      "end\n"
      "subsection Discretization\n"
      "  set Order = 3\n"
      "  set Global refinements = 2\n"
      "end\n"
      "subsection Time\n"
      "  set Scheme = static\n"
      "  set End time = 1\n"
      "  set Time step = 0.05\n"
      "end\n";
  }
} // namespace

// A moment M bends a cantilever to an arc of the angle M L/(EI).

TEST(WeakParts, AreSolvedBesideAStrongPart)
{
  SceneRun run(scene("0 0; 1 0; 0 5; 1 5", "0 1; 2 3", "0, 2", "3"));
  run.run();
  ComparisonTable table("Weak cantilever beside a strong one, and alone");
  table.row("angle of the tip (rad)", run.motion(3, rotation_z), 2 * pi, 1e-6);
  // A closed circle.
  table.row("tip x (m)", run.motion(3, 0), -1, 1e-6);
  table.row("tip y (m)", run.motion(3, 1), 0, 1e-6);
}

TEST(WeakParts, AreSolvedAtTheEndOfAStrongPart)
{
  SceneRun run(scene("0 0; 1 0; 2 0", "0 1; 1 2", "0", "2"));
  run.run();
  ComparisonTable table("Weak cantilever at the end of a strong one");
  // Bending of the strong one is a part of 1e-8.
  table.row("angle between its ends (rad)",
            run.motion(2, rotation_z) - run.motion(1, rotation_z),
            2 * pi,
            1e-6);
}
