#include <auxfem/joints/effects/revolute_hinges.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>

#include <equations/space_effect.h>
#include <mesh/cell_from_text.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText revolute(const std::string &joints,
                     const std::string &struts,
                     const std::string &axis)
  {
    return SceneText().add("Joints/hinge",
                           "Joints = " + joints + " | Struts = " + struts +
                             " | Type = revolute | "
                             "Axis = " +
                             axis);
  }

  /** Three struts at joint 1, two of them on one hinge against the third. */
  const std::string forked =
    space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2; 1.8 -0.3 0.8",
                "0 1; 1 2; 1 3",
                revolute("1", "1, 2", "1 2 -0.5"));

  /** The hinge constraints of the fork without the other effects. */
  struct ForkHinges : SpaceEffect
  {
    explicit ForkHinges(const bool large_rotation)
      : SpaceEffect(forked, large_rotation)
    {
      const auto spins = [&](const unsigned int strut, const unsigned int end) {
        std::array<int, 3> unknowns;
        for (unsigned int c = 0; c < 3; ++c)
          unknowns[c] = setup.dofs().end_rotation(strut, end, 3 + c);
        return unknowns;
      };
      std::vector<RevoluteHinge> definitions;
      for (unsigned int h = 0; h < 2; ++h)
        definitions.push_back(
          {spins(0, 1),
           spins(1 + h, 0),
           {{setup.dofs().constraints().hinge_multiplier(h, 0),
             setup.dofs().constraints().hinge_multiplier(h, 1)}},
           setup.scene.joints[0].axis});
      hinges =
        make_revolute_hinges(setup.dofs(), large_rotation, 0.7, definitions);
    }

    std::unique_ptr<Constraints> hinges;
  };
} // namespace

TEST(RevoluteHinges, EveryReleasedStrutHasTwoConstraints)
{
  const EquationsOnRanks setup(forked, {}, MPI_COMM_SELF);
  const auto            &dofs = setup.dofs();
  EXPECT_EQ(dofs.constraints().n_multipliers(), 4u);
  EXPECT_EQ(setup.equations.reporting().constraints.size(), 1u);
  EXPECT_EQ(describe(dofs, dofs.constraints().hinge_multiplier(1, 0)),
            "constraint of the revolute hinge at joint 1");
}

TEST(RevoluteHinges, TangentIsThatOfDifferences)
{
  for (const bool large_rotation : {true, false})
    {
      ForkHinges forked(large_rotation);
      forked.expect_tangent(*forked.hinges, {1., 3., 5.});
      EXPECT_EQ(forked.hinges->is_linear(), !large_rotation);
    }
}

TEST(RevoluteHinges, MomentsAreDerivativesOfTheConstraints)
{
  for (const bool large_rotation : {true, false})
    {
      ForkHinges forked(large_rotation);
      forked.expect_forces_by_constraints(*forked.hinges);
    }
}

TEST(RevoluteHinges, RatesAreThoseOfTheConstraints)
{
  for (const bool large_rotation : {true, false})
    {
      ForkHinges forked(large_rotation);
      forked.expect_time_derivatives(*forked.hinges);
    }
}

TEST(RevoluteHinges, AStrutTurnsAboutTheAxisAlone)
{
  // A cantilever along x, hinged about z half way, its outer half held along z
  // by bending and torsion only: across z the hinge transmits moments, about z
  // it needs the roller's force.
  const SceneText further =
    revolute("1", "1", "0 0 1")
      .support("wall", "0", "clamp")
      .add("Supports/rest",
           "Joints = 2 | Type = prescribed | Displacement y = 0")
      .add("Loads/tip", "Joints = 2 | Force z = 1e-6 | Force y = 5")
      .time(1, 1, "static");
  SceneRun run(space_frame("0 0 0; 1 0 0; 2 0 0", "0 1; 1 2", further),
               {"Discretization/Order=3"});
  run.run();
  const auto &dofs = run.model.numbering;
  // The strut without hinge: F L^3 / (3 EI) + F L / (kGA).
  const double EI = 1000 * pi * 1e-4 / 4, kGA = 0.9 * pi * 1e-2 * 1000 / 2.6;
  EXPECT_NEAR(run.state.displacement[dofs.joint_unknown(2, 2)],
              1e-6 * 8 / (3 * EI) + 1e-6 * 2 / kGA,
              // Relative error of the order of the squared deflection.
              1e-12);
  // Both sides of the hinge are parallel but for the turn about z.
  for (const unsigned int c : {3u, 4u})
    EXPECT_NEAR(run.state.displacement[dofs.end_rotation(0, 1, c)],
                run.state.displacement[dofs.end_rotation(1, 0, c)],
                1e-12);
}

TEST(RevoluteHinges, ABarHasNoRotationToBeHinged)
{
  const std::string message = input_error_of([] {
    const EquationsOnRanks setup(space_frame("0 0 0; 1 0 0; 2 0 0", "0 1; 1 2")
                                   .rigid_part("bar", "1", 1)
                                   .add(revolute("1", "all", "0 0 1")),
                                 {},
                                 MPI_COMM_SELF);
  });
  EXPECT_TRUE(contains(message, "Joints/hinge/Joints")) << message;
  EXPECT_TRUE(contains(message, "lies on one line")) << message;
}
