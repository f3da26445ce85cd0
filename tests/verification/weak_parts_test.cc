#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A stiff strut of 1 m under 1 kN along its axis, and a weak one of 1 m that
   * a moment winds up to a full circle, M = 2 pi EI/L: 1.3e-7 N m. They have no
   * shear flexibility to speak of, EI = 2e-6 m^4 E.
   */
  SceneText scene(const std::string &joints,
                  const std::string &struts,
                  const std::string &clamped,
                  const std::string &wound)
  {
    return SceneText()
      .dimension(2)
      .frame(joints, struts)
      .given("stiff", {0.01, 0.01, 2e-6}, {1e6, "", 0})
      .set("Sections/stiff/Struts", 0)
      .given("weak", {0.01, 0.01, 2e-6}, {1e-2, "", 0})
      .set("Sections/weak/Struts", 1)
      .support("wall", clamped, "clamp")
      .add("Loads/pull", "Joints = 1 | Force x = 1e3")
      .add("Loads/wind",
           "Joints = " + wound + " | Moment z = 4 * pi * t * 1e-8")
      .mesh(3, 2)
      .time(1, 0.05, "static");
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
