#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/equations/make_effects.h>
#include <auxfem/joints/effects/rotational_springs.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <connectors/law_on_trial.h>
#include <mesh/cell_from_text.h>
#include <struts/effects/mean_step.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Mean forces over a step (Evaluation::Kind::discrete_gradient): their work is
// the change of energy, and they have no resultants.

namespace
{
  // Sums of some hundred products of numbers around one.
  constexpr double mean_forces_round_off = 1e-12;

  const std::string triangle = frame_scene("0 0; 3 1; 1 2", "0 1; 1 2");

  /** Amount of the entry @p name of @p energies. */
  double amount(const Energies &energies, const std::string &name)
  {
    const auto &entries = energies.ledger().entries();
    for (unsigned int i = 0; i < entries.size(); ++i)
      if (entries[i].name == name)
        return energies[i];
    throw std::logic_error("no entry " + name);
  }

  struct Connector
  {
    std::string law, position;
  };

  std::vector<Connector> all_connectors()
  {
    const std::vector<std::string> laws = {
      "Law = spring | Spring stiffness = 2",
      "Law = dashpot | Damping coefficient = 3",
      "Law = kelvin-voigt | Spring stiffness = 2 | "
      "Damping coefficient = 3",
      "Law = maxwell | Spring stiffness = 2 | "
      "Damping coefficient = 3",
      "Law = maxwell | Spring stiffness = 2 | "
      "Damping coefficient = 0.1",
      "Law = standard-linear-solid | Long-time stiffness = 0.4 | "
      "Spring stiffness = 2 | Damping coefficient = 30",
      "Law = generalized-maxwell | Long-time stiffness = 0.4 | "
      "Stiffnesses = 1, 0.3 | Relaxation times = 0.05, 4"};
    const std::vector<std::string> positions = {
      "Between = 0 1",
      "Between = 0 1 | Geometry = direction | Direction = 1 1",
      "Between = ground: 1 | Ground offset = 0 -2"};
    std::vector<Connector> result;
    for (const std::string &law : laws)
      for (const std::string &position : positions)
        result.push_back({law, position});
    return result;
  }

  std::unique_ptr<ConnectorForces> forces_of(const EquationsOnRanks &setup,
                                             const bool large_rotation)
  {
    return make_connector_forces(setup.scene.connectors[0],
                                 setup.model.connector_pairs[0],
                                 setup.lattice,
                                 setup.dofs(),
                                 large_rotation);
  }
} // namespace

TEST(MeanForces, WorkOfConnectorsIsStoredOrLost)
{
  for (const Connector &connector : all_connectors())
    for (const bool large_rotation : {true, false})
      for (unsigned int seed = 1; seed <= 5; ++seed)
        {
          SCOPED_TRACE(connector.law + " | " + connector.position);
          MeanStep   step(frame_scene("0 0; 3 1; 1 2", "0 1; 1 2")
                          .add("Connectors/one",
                               connector.law + " | " + connector.position),
                        seed,
                        large_rotation);
          const auto forces = forces_of(step.setup, large_rotation);
          step.make_room_for(*forces);
          const Energies       before = step.at_start(*forces);
          const EvaluatedAlone evaluated(*forces, step.evaluation());
          const Energies       after = evaluated.accept();
          EXPECT_NEAR(step.work(evaluated.residual.data()),
                      after.stored() - before.stored() + after.dissipated(),
                      mean_forces_round_off);
          EXPECT_GE(after.dissipated(), 0);
          const bool to_the_ground =
            connector.position.find("ground") != std::string::npos;
          const bool turns_no_direction =
            connector.position.find("direction") == std::string::npos &&
            large_rotation;
          const auto sums = step.resultants(evaluated.residual.data());
          if (!to_the_ground)
            {
              EXPECT_NEAR(sums[0], 0, mean_forces_round_off);
              EXPECT_NEAR(sums[1], 0, mean_forces_round_off);
              if (turns_no_direction)
                {
                  EXPECT_NEAR(sums[2], 0, mean_forces_round_off);
                }
            }
          // The error of the differences.
          EXPECT_NEAR(step.error_of_tangent(*forces), 0, 1e-8);
        }
}

TEST(MeanForces, WorkOfRotationalSpringsIsStored)
{
  for (const bool large_rotation : {true, false})
    for (const bool to_the_ground : {true, false})
      {
        MeanStep                      step(triangle, 3, large_rotation);
        const auto                   &dofs = step.setup.dofs();
        const std::unique_ptr<Effect> made = make_rotational_springs(
          dofs,
          {{{{to_the_ground ? -1 : dofs.joint_unknown(0, rotation_z),
              dofs.joint_unknown(1, rotation_z)}},
            3.}});
        Effect &springs = *made;
        step.make_room_for(springs);
        const Energies       before = step.at_start(springs);
        const EvaluatedAlone evaluated(springs, step.evaluation());
        EXPECT_NEAR(step.work(evaluated.residual.data()),
                    evaluated.accept().strain() - before.strain(),
                    mean_forces_round_off);
        if (!to_the_ground)
          step.expect_no_resultants(evaluated.residual.data());
      }
}

TEST(MeanForces, WorkOfRotationalLawsIsStored)
{
  for (const bool large_rotation : {true, false})
    {
      MeanStep                      step(triangle, 3, large_rotation);
      const auto                   &dofs = step.setup.dofs();
      const std::unique_ptr<Effect> made =
        make_rotational_laws(dofs,
                             "knee",
                             make_law("bilinear",
                                      {{"Spring stiffness", "3"},
                                       {"Second stiffness", "1"},
                                       {"Kink extension", "0.01"}}),
                             {{{dofs.joint_unknown(0, rotation_z),
                                dofs.joint_unknown(1, rotation_z)}}},
                             {0});
      Effect &laws = *made;
      step.make_room_for(laws);
      const Energies       before = step.at_start(laws);
      const EvaluatedAlone evaluated(laws, step.evaluation());
      EXPECT_NEAR(step.work(evaluated.residual.data()),
                  evaluated.accept().strain() - before.strain(),
                  mean_forces_round_off);
    }
}

TEST(MeanForces, LoadsDoTheWorkTheyRecord)
{
  for (const std::string direction : {"fixed", "follows the joint"})
    {
      MeanStep step(frame_scene("0 0; 3 1; 1 2", "0 1; 1 2")
                      .add("Loads/push",
                           "Joints = 1, 2 | Direction = " + direction +
                             " | Force x = 3 * t | "
                             "Force y = 2 - t | Moment z = 1.5 + t"));
      auto     loads = make_loads(step.setup.model);
      ASSERT_EQ(loads.size(), 1u) << direction;
      step.make_room_for(*loads[0]);
      const EvaluatedAlone evaluated(*loads[0], step.evaluation());
      const double         work = evaluated.accept().external();
      EXPECT_GT(std::abs(work), 0.05);
      EXPECT_NEAR(-step.work(evaluated.residual.data()),
                  work,
                  mean_forces_round_off);
    }
}

TEST(MeanForces, MeanOfAConstantMomentWorksOnTheAngle)
{
  MeanStep  step(frame_scene("0 0; 3 1; 1 2", "0 1; 1 2")
                  .add("Loads/push", "Joints = 1 | Moment z = 1.5"));
  const int i     = step.setup.dofs().joint_unknown(1, rotation_z);
  auto      loads = make_loads(step.setup.model);
  step.make_room_for(*loads[0]);
  EXPECT_NEAR(EvaluatedAlone(*loads[0], step.evaluation()).accept().external(),
              1.5 * (step.to.displacement[i] - step.from.displacement[i]),
              mean_forces_round_off);
}

TEST(MeanForces, MultipliersWorkOnTheChangeOfTheirConstraints)
{
  const SceneText plate =
    frame_scene("0 0; 2 0.3; 1.6 1.1; 0.2 1.4; 3 2", "0 1; 1 2; 0 3; 2 4; 3 4")
      .add("Rigid parts/plate",
           "Struts = 0, 1, 2 | Mass = 3 | Elastic struts = clamped");
  for (const bool large_rotation : {true, false})
    {
      MeanStep                              step(plate, 2, large_rotation);
      const auto                           &dofs = step.setup.dofs();
      const std::unique_ptr<RigidPartGroup> constraints =
        make_rigid_part_constraints(
          step.setup.model.bodies,
          {step.setup.lattice, dofs, large_rotation, {}, {}});
      const EvaluatedAlone end(*constraints, step.evaluation());
      // Constraint values at the start.
      State                now = step.from;
      const EvaluatedAlone start(*constraints,
                                 Evaluation::step(step.from, now, step.dt));
      double               work = 0;
      for (const int multiplier : dofs.constraints().multipliers())
        work += step.to.displacement[multiplier] *
          (end.residual[multiplier] - start.residual[multiplier]);
      EXPECT_GT(std::abs(work), 0.1);
      EXPECT_NEAR(step.work(end.residual.data()), work, mean_forces_round_off);
      if (!large_rotation)
        continue;
      // Two multipliers of each joint off the base fix its position; the random
      // position error is the lever of their force pair.
      double moment = 0;
      for (const unsigned int joint : {0, 1})
        {
          const int x        = dofs.constraints().multiplier(0, 1 + 2 * joint),
                    y        = dofs.constraints().multiplier(0, 2 + 2 * joint);
          const double gap_x = (start.residual[x] + end.residual[x]) / 2,
                       gap_y = (start.residual[y] + end.residual[y]) / 2;
          moment +=
            gap_x * step.to.displacement[y] - gap_y * step.to.displacement[x];
        }
      const auto sums = step.resultants(end.residual.data());
      EXPECT_NEAR(sums[0], 0, mean_forces_round_off);
      EXPECT_NEAR(sums[1], 0, mean_forces_round_off);
      EXPECT_NEAR(sums[2], moment, mean_forces_round_off);
    }
}

// All effects at once: the work of every row against the energy account.
TEST(MeanForces, EnergyBalancesWithAllEffects)
{
  for (const bool large_rotation : {true, false})
    for (unsigned int seed = 1; seed <= 3; ++seed)
      {
        MeanStep    step(star_with_everything(1, 1), seed, large_rotation);
        const State before = step.from;
        step.setup.residual(Evaluation::consistent_rates(before, step.from));
        step.setup.accept(Evaluation::consistent_rates(before, step.from));
        step.find_rates();
        const Evaluation evaluation = step.evaluation();
        step.setup.residual(evaluation);
        const double work = step.work(step.to.residual.data());
        step.setup.accept(evaluation);
        const Energies &start = step.from.energies, &end = step.to.energies;
        EXPECT_GT(amount(end, "strut_damping_dissipated"), 0);
        EXPECT_GT(amount(end, "mass_damping_dissipated"), 0);
        // The released supports put their force into the rows.
        const double loads =
          end.external() - amount(end, "shaker.support_work");
        EXPECT_NEAR(work,
                    end.total() - start.total() + end.dissipated() - loads,
                    mean_forces_round_off * end.total());
      }
}
