#include <auxfem/mesh/sets.h>
#include <auxfem/output/probes.h>

#include <deal.II/base/numbers.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two rigid bars on a hinge, 2 kg each, then an elastic strut. */
  const SceneText bars =
    frame_scene("0 0; 1 0; 2 0; 3 0", "0 1; 1 2; 2 3")
      .add("Rigid parts/bars",
           "Struts = 0, 1 | Parts = single struts | Mass = 2");

  ProbeDefinition probe(const std::string &selection)
  {
    ProbeDefinition definition;
    definition.name      = "P";
    definition.path      = "Probes/P";
    definition.selection = selection;
    return definition;
  }

  std::string probe_refusal(const std::string &selection)
  {
    const EquationsOnRanks scene_equations(bars, {}, MPI_COMM_SELF);
    return input_error_of([&] {
      RigidPartProbe::check(probe(selection),
                            scene_equations.scene,
                            scene_equations.lattice);
    });
  }

  /** Rotates bar 0 by @p angle about joint 0. */
  void
  turn_first_bar(const DofNumbering &dofs, const double angle, State &state)
  {
    state.displacement[dofs.joint_unknown(1, 0)] = std::cos(angle) - 1;
    state.displacement[dofs.joint_unknown(1, 1)] = std::sin(angle);
  }
} // namespace

TEST(RigidPartProbe, IsIdentifiedByPrefix)
{
  EXPECT_TRUE(RigidPartProbe::is_rigid_part_probe(probe("rigid: 0 @ 1")));
  EXPECT_FALSE(RigidPartProbe::is_rigid_part_probe(probe("0, 1")));
}

TEST(RigidPartProbe, RotationIsCountedPastHalfTurns)
{
  const EquationsOnRanks scene_equations(bars, {}, MPI_COMM_SELF);
  State                  state = scene_equations.equations.initial_state();
  RigidPartProbe         first(probe("rigid: 0"),
                       scene_equations.scene,
                       scene_equations.equations);
  RigidPartRotations     rotations(scene_equations.equations);
  ASSERT_EQ(first.columns().size(), 1u);
  for (const double sign : {1., -1.})
    {
      // Forward and back, three turns to either side.
      for (int i = 0; i <= 60; ++i)
        {
          turn_first_bar(scene_equations.dofs(), sign * i * pi / 10, state);
          rotations.follow(state);
          EXPECT_NEAR(first.values(state, rotations).at(0),
                      sign * i * pi / 10,
                      1e-13);
        }
      for (int i = 60; i >= 0; --i)
        {
          turn_first_bar(scene_equations.dofs(), sign * i * pi / 10, state);
          rotations.follow(state);
        }
      EXPECT_NEAR(first.values(state, rotations).at(0), 0, 1e-13);
    }
}

TEST(RigidPartProbe, SeveralPartsGiveTheirMeanRotation)
{
  const EquationsOnRanks scene_equations(bars, {}, MPI_COMM_SELF);
  const auto            &dofs  = scene_equations.dofs();
  State                  state = scene_equations.equations.initial_state();
  RigidPartProbe         both(probe("rigid: 0, 1"),
                      scene_equations.scene,
                      scene_equations.equations);
  // Bar 0 rotates by 0.6; bar 1 by 0.2 about its moved end.
  turn_first_bar(dofs, 0.6, state);
  state.displacement[dofs.joint_unknown(2, 0)] =
    std::cos(0.6) + std::cos(0.2) - 2;
  state.displacement[dofs.joint_unknown(2, 1)] = std::sin(0.6) + std::sin(0.2);
  RigidPartRotations rotations(scene_equations.equations);
  rotations.follow(state);
  EXPECT_NEAR(both.values(state, rotations).at(0), 0.4, 1e-14);
}

TEST(RigidPartProbe, ForcesAreThoseOfTheChosenJoints)
{
  // A bar of 3 kg on a pin at 0 and a roller at 2 m, 30 N down at 0.5 m of a
  // third joint.
  SceneRun run(SceneText()
                 .frame("0 0; 2 0; 0.5 0", "0 2; 2 1")
                 .rigid_part("bar", "all", 3)
                 .support("pin", "0", "pin")
                 .support("roller", "1", "roller x")
                 .add("Loads/weight", "Joints = 2 | Force y = -30")
                 .set("Gravity/Acceleration y", -10)
                 .time(1, 1, "static"));
  run.run();
  const auto values_of = [&](const std::string &selection) {
    RigidPartProbe chosen(probe(selection), run.scene, run.equations);
    EXPECT_EQ(chosen.columns().size(), 3u);
    EXPECT_EQ(chosen.columns()[1].name, "P.fx");
    RigidPartRotations rotations(run.equations);
    rotations.follow(run.state);
    return chosen.values(run.state, rotations);
  };
  // The central weight gives 15 N each, the load 22.5 N and 7.5 N.
  EXPECT_NEAR(values_of("rigid: 0 @ 0").at(2), 37.5, 1e-12);
  EXPECT_NEAR(values_of("rigid: 0 @ 1").at(2), 22.5, 1e-12);
  EXPECT_NEAR(values_of("rigid: all @ 2").at(2), -30, 1e-12);
  // All joints together carry the weight.
  EXPECT_NEAR(values_of("rigid: all @ all").at(2), 30, 1e-12);
  EXPECT_NEAR(values_of("rigid: all @ all").at(1), 0, 1e-12);
  // The name of a definition selects its parts.
  EXPECT_NEAR(values_of("rigid: bar @ 1").at(2), 22.5, 1e-12);
}

TEST(RigidPartProbe, ErrorsAreDescribed)
{
  EXPECT_EQ(probe_refusal("rigid: 1 @ 2"), "");
  // Elastic struts besides rigid ones are ignored.
  EXPECT_EQ(probe_refusal("rigid: all"), "");
  for (const auto &[selection, words] :
       std::vector<std::pair<std::string, std::string>>{
         {"rigid: 2", "is rigid"},
         {"rigid: 0 @ 3", "belongs to the rigid parts"},
         {"rigid: 7", "7"},
         {"rigid: 0 @ 9", "9"},
         {"rigid: bras", "bras"}})
    {
      const std::string message = probe_refusal(selection);
      EXPECT_TRUE(contains(message, "Probes/P")) << message;
      EXPECT_TRUE(contains(message, words)) << message;
    }
}
