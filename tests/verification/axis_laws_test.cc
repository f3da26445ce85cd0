#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

using namespace auxfem;
using namespace auxfem::testing_support;

// Laws about the axes of hinges in space.

namespace
{
  /** A rod that is thrown on a hinge about z at the end of a clamped one. */
  SceneText hinged_flail(const unsigned int dimension, const std::string &law)
  {
    const bool in_space = dimension == 3;
    return SceneText()
      .dimension(dimension)
      .frame(in_space ? "0 0 0; 1 0 0; 1.8 0.6 0" : "0 0; 1 0; 1.8 0.6",
             "0 1; 1 2")
      .circle("rod", 0.02, {"70e9", 2700})
      .support("wall", "0", "clamp")
      .add("Joints/knee",
           "Joints = 1 | Struts = 1 | Type = rotational " + law +
             (in_space ? " | Axis = 0 0 1" : ""))
      .add("Initial velocities/throw",
           "Joints = 2 | Velocity x = -1.5 | Velocity y = 2")
      .mesh(3)
      .set("Newton/Tolerance", 1e-10);
  }

  const std::string axis_friction =
                      "friction-slider | Spring stiffness = 500 | "
                      "Slip moment = 0.6",
                    axis_cubic =
                      "cubic | Spring stiffness = 20 | Cubic stiffness = 30";
} // namespace

TEST(LawsAboutAxes, InThePlaneTheyAreThoseOfThePlane)
{
  ComparisonTable table("Rod on a hinge about z, in space and in the plane");
  for (const std::string &law : {axis_friction, axis_cubic})
    for (const char *scheme : {"newmark", "energy-momentum"})
      {
        const auto run_in = [&](const unsigned int dimension) {
          SceneRun run(hinged_flail(dimension, law).time(0.2, 5e-4, scheme));
          run.run();
          return std::array<double, 3>{{run.motion(2, 0),
                                        run.motion(2, 1),
                                        run.state.energies.dissipated()}};
        };
        const std::array<double, 3> plane = run_in(2), space = run_in(3);
        const std::string of = law.substr(0, law.find(' ')) + ", " + scheme;
        EXPECT_GT(std::hypot(plane[0], plane[1]), 0.1);
        table.row(of + ", x (m)", space[0], plane[0], 1e-5);
        table.row(of + ", y (m)", space[1], plane[1], 1e-5);
        table.row(of + ", lost (J)", space[2], plane[2], 1e-4);
      }
}

TEST(LawsAboutAxes, ATumblingKneeKeepsItsEnergy)
{
  SceneRun run(SceneText()
                 .dimension(3)
                 .frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2", "0 1; 1 2")
                 .circle("rod", 0.02, {"70e9", 2700})
                 .add("Joints/knee",
                      "Joints = 1 | Struts = 1 | Type = rotational " +
                        axis_cubic + " | Axis = 0.3 -0.2 1")
                 .add("Initial velocities/throw",
                      "Joints = 2 | Velocity x = 2 | Velocity y = -3 | "
                      "Velocity z = 4")
                 .mesh(2)
                 .set("Newton/Tolerance", 1e-12)
                 .time(0.5, 1e-3, "energy-momentum"));
  double   change = 0, stored = 0;
  run.run([&] {
    change = std::max(change, std::abs(run.balance()) / run.initial_balance);
    stored = std::max(stored, run.state.energies.strain());
  });
  EXPECT_GT(stored, 0.01 * run.initial_balance);
  ComparisonTable table("Two rods on a hinge with a cubic law that tumble");
  table.row("largest change of energy", change, 0, 1e-9);
}
