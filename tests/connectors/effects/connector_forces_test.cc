#include <auxfem/connectors/effects/connector_forces.h>
#include <auxfem/mesh/sets.h>

#include <connectors/law_on_trial.h>
#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A bent strut of two pieces, joints (0, 0), (3, 4), (1, 6). */
  SceneText with_connector(const std::string &law, const std::string &position)
  {
    return frame_scene("0 0; 3 4; 1 6", "0 1; 1 2")
      .add("Connectors/one", law + " | " + position);
  }

  const std::string spring = "Law = spring | Spring stiffness = 2";
  const std::string kelvin_voigt =
    "Law = kelvin-voigt | Spring stiffness = 2 | "
    "Damping coefficient = 3";
  const std::string maxwell     = "Law = maxwell | Spring stiffness = 2 | "
                                  "Damping coefficient = 3";
  const std::string from_0_to_1 = "Between = 0 1";
  const std::string along_1_1 =
    "Between = 0 1 | Geometry = direction | Direction = 1 1";
  const std::string to_the_ground =
    "Between = ground: 1 | Ground offset = 0 -2";
  const std::string ground_along_x =
    "Between = ground: 1 | Geometry = direction | Direction = 5 0";

  /** The connector without other effects in a step, with inertia unless the
   * state has no acceleration. */
  struct ConnectorAlone
  {
    explicit ConnectorAlone(const std::string &law,
                            const std::string &position,
                            const bool         large_rotation = true,
                            const bool         is_dynamic     = true)
      : setup(with_connector(law, position), {}, MPI_COMM_SELF)
      , forces(
          make_connector_forces(setup.scene.connectors[0],
                                select_pairs(setup.lattice,
                                             setup.scene.connectors[0].between,
                                             setup.scene.context,
                                             "Connectors/one/Between"),
                                setup.lattice,
                                setup.dofs(),
                                large_rotation))
      , layout(layout_of(*forces, is_dynamic))
      , from(setup.dofs().layout().n_local(), layout)
      , to(from)
    {}

    static StateLayout layout_of(ConnectorForces &forces, const bool is_dynamic)
    {
      StateLayout layout;
      layout.velocity     = true;
      layout.acceleration = is_dynamic;
      forces.register_in(layout);
      return layout;
    }

    void move(const unsigned int joint, const double x, const double y)
    {
      to.displacement[setup.dofs().joint_unknown(joint, 0)] = x;
      to.displacement[setup.dofs().joint_unknown(joint, 1)] = y;
    }

    void push(const unsigned int joint, const double x, const double y)
    {
      (*to.velocity)[setup.dofs().joint_unknown(joint, 0)] = x;
      (*to.velocity)[setup.dofs().joint_unknown(joint, 1)] = y;
    }

    /** Sets the displacement and velocity of joints 0 and 1 as a rigid body
     * rotating about (2, -1). */
    void turn(const double angle, const double angular_velocity)
    {
      for (const unsigned int joint : {0, 1})
        {
          const double x        = setup.lattice.joints[joint][0] - 2,
                       y        = setup.lattice.joints[joint][1] + 1;
          const double turned_x = std::cos(angle) * x - std::sin(angle) * y,
                       turned_y = std::sin(angle) * x + std::cos(angle) * y;
          move(joint, turned_x - x, turned_y - y);
          push(joint,
               -angular_velocity * turned_y,
               angular_velocity * turned_x);
        }
    }

    EvaluatedAlone evaluated()
    {
      return {*forces,
              layout.acceleration ? Evaluation::step(from, to, dt)
                                  : Evaluation::static_step(from, to, dt)};
    }

    double force_on(const unsigned int joint, const unsigned int component)
    {
      return evaluated().residual[setup.dofs().joint_unknown(joint, component)];
    }

    ConnectorReport report()
    {
      return forces->report(0, to, evaluated().results.get());
    }

    double                                 dt = 0.5;
    EquationsOnRanks                       setup;
    const std::unique_ptr<ConnectorForces> forces;
    StateLayout                            layout;
    State                                  from, to;
  };

  // A few roundings of lengths of about 10.
  constexpr double connector_round_off = 1e-14;
} // namespace

TEST(ConnectorForces, ForceActsAlongTheCurrentLine)
{
  ConnectorAlone connector(spring, from_0_to_1);
  // Rotated upright and stretched from 5 to 7.
  connector.move(1, -3, 3);
  EXPECT_NEAR(connector.report().extension, 2., connector_round_off);
  EXPECT_NEAR(connector.report().force, 4., connector_round_off);
  // The residual is the internal force: along the motion at the second end.
  EXPECT_NEAR(connector.force_on(1, 0), 0., connector_round_off);
  EXPECT_NEAR(connector.force_on(1, 1), 4., connector_round_off);
  EXPECT_NEAR(connector.force_on(0, 0), 0., connector_round_off);
  EXPECT_NEAR(connector.force_on(0, 1), -4., connector_round_off);
  for (const int c : {0, 1})
    EXPECT_EQ(connector.force_on(2, c), 0.);
}

TEST(ConnectorForces, FixedDirectionStaysWhereItIs)
{
  ConnectorAlone connector(spring, along_1_1);
  connector.move(1, 0.5, 1.5);
  const double component = 1 / std::sqrt(2.);
  EXPECT_NEAR(connector.report().extension, 2 * component, connector_round_off);
  for (const unsigned int c : {0u, 1u})
    {
      EXPECT_NEAR(connector.force_on(1, c), 2., connector_round_off);
      EXPECT_NEAR(connector.force_on(0, c), -2., connector_round_off);
    }
}

TEST(ConnectorForces, SmallDisplacementsKeepTheLineAtRest)
{
  ConnectorAlone connector(spring, from_0_to_1, /*large_rotation=*/false);
  EXPECT_TRUE(connector.forces->is_linear());
  // The line at rest is (3, 4) / 5.
  connector.move(1, 1, -2);
  EXPECT_NEAR(connector.report().extension, -1., connector_round_off);
  EXPECT_NEAR(connector.force_on(1, 0), -2 * 0.6, connector_round_off);
  EXPECT_NEAR(connector.force_on(1, 1), -2 * 0.8, connector_round_off);
}

TEST(ConnectorForces, GroundPointLiesAtItsOffset)
{
  ConnectorAlone connector(spring, to_the_ground);
  // The joint rises by 1: the line to the ground 2 below it grows to 3.
  connector.move(1, 0, 1);
  EXPECT_NEAR(connector.report().extension, 1., connector_round_off);
  EXPECT_NEAR(connector.force_on(1, 1), 2., connector_round_off);
  EXPECT_NEAR(connector.force_on(1, 0), 0., connector_round_off);
  EXPECT_EQ(connector.force_on(0, 1), 0.);

  const ConnectorReport report = connector.report();
  EXPECT_NEAR(report.ends[0].distance({3, 4, 0}), 0., connector_round_off);
  EXPECT_NEAR(report.ends[1].distance({3, 2, 0}), 0., connector_round_off);
  EXPECT_NEAR(report.displacements[0][1], 1., connector_round_off);
  EXPECT_EQ(report.displacements[1].norm(), 0.);
}

TEST(ConnectorForces, GroundAlongADirectionResistsMotionThere)
{
  ConnectorAlone connector(kelvin_voigt, ground_along_x);
  connector.move(1, 0.5, 7);
  connector.push(1, -1, 9);
  // From joint to ground: moving along +x shortens it.
  EXPECT_NEAR(connector.report().extension, -0.5, connector_round_off);
  EXPECT_NEAR(connector.force_on(1, 0), 2 * 0.5 + 3 * -1, connector_round_off);
  EXPECT_EQ(connector.force_on(1, 1), 0.);
}

TEST(ConnectorForces, SmallExtensionsHaveAllDigits)
{
  ConnectorAlone connector(spring, from_0_to_1);
  for (const double size : {1e-3, 1e-7, 1e-11})
    {
      // Along the line (3, 4) / 5: the displacement itself.
      connector.move(1, 0.6 * size, 0.8 * size);
      EXPECT_NEAR(connector.report().extension / size, 1., connector_round_off);
      // Across it: s^2 / (sqrt(25 + s^2) + 5).
      connector.move(1, -0.8 * size, 0.6 * size);
      const double across = size * size / (std::sqrt(25 + size * size) + 5);
      // The digits of the displacement limit it: 6 u_y - 8 u_x cancels.
      EXPECT_NEAR(connector.report().extension, across, 1e-15 * size);
    }
}

TEST(ConnectorForces, RigidRotationGivesNoForceAndNoRate)
{
  for (const std::string &law : {kelvin_voigt, maxwell})
    for (const double angle : {0.4, 3., -25.})
      {
        ConnectorAlone connector(law, from_0_to_1);
        connector.turn(angle, 6.);
        for (const unsigned int joint : {0u, 1u})
          for (const unsigned int c : {0u, 1u})
            // Extension and rate are products of numbers of about 50.
            EXPECT_NEAR(connector.force_on(joint, c),
                        0.,
                        20 * connector_round_off);
      }
}

TEST(ConnectorForces, RateIsTheRateOfTheExtension)
{
  ConnectorAlone dashpot("Law = dashpot | Damping coefficient = 1",
                         from_0_to_1);
  ConnectorAlone position(spring, from_0_to_1);
  const double   h            = 1e-5;
  const auto     extension_at = [&position](const double t) {
    position.move(0, 0.7 - 2 * t, 0.3 + t);
    position.move(1, -4 + 3 * t, 1 + 2 * t);
    return position.report().extension;
  };
  dashpot.move(0, 0.7, 0.3);
  dashpot.move(1, -4, 1);
  dashpot.push(0, -2, 1);
  dashpot.push(1, 3, 2);
  // The force of a dashpot of 1 N s/m is the rate; h^2 and 1e-16 / h.
  EXPECT_NEAR(dashpot.report().force,
              (extension_at(h) - extension_at(-h)) / (2 * h),
              1e-9);
}

namespace
{
  /** Compares the tangent at a fast motion far from rest with differences. */
  void check_tangent(ConnectorAlone &connector, const TangentFactors &factors)
  {
    // Nearly upside down, long and fast.
    connector.from.displacement.assign(connector.from.displacement.size(), 0.1);
    connector.move(0, 1, 2);
    connector.move(1, -5, -9);
    connector.push(0, 3, -2);
    connector.push(1, -4, 5);

    TangentAlone tangent(*connector.forces, connector.setup.dofs());
    tangent.fill(connector.evaluated(), factors);

    const unsigned int n     = connector.setup.dofs().layout().n_global();
    const double       h     = 1e-5;
    double             worst = 0, scale = 0;
    for (unsigned int j = 0; j < n; ++j)
      {
        std::vector<double> unit(n, 0.);
        unit[j]                          = 1;
        const std::vector<double> column = tangent.times(unit);
        const auto                moved  = [&](const double step) {
          const State kept = connector.to;
          connector.to.displacement[j] += factors.stiffness * step;
          (*connector.to.velocity)[j] += factors.damping * step;
          const std::vector<double> result = connector.evaluated().residual;
          connector.to                     = kept;
          return result;
        };
        const std::vector<double> right = moved(h), left = moved(-h);
        for (unsigned int i = 0; i < n; ++i)
          {
            scale = std::max(scale, std::abs(column[i]));
            worst =
              std::max(worst,
                       std::abs(column[i] - (right[i] - left[i]) / (2 * h)));
          }
      }
    EXPECT_GT(scale, 0.1);
    // h^2 = 1e-10 and 1e-16 / h = 1e-11, times numbers of about 10.
    EXPECT_LT(worst, 1e-8 * scale);
  }
} // namespace

TEST(ConnectorForces, TangentIsTheDerivativeOfTheForceAtLargeRotations)
{
  for (const std::string &law : {spring, kelvin_voigt, maxwell})
    for (const std::string &position :
         {from_0_to_1, along_1_1, to_the_ground, ground_along_x})
      for (const bool large : {true, false})
        {
          SCOPED_TRACE(law + position);
          ConnectorAlone in_dynamics(law, position, large),
            in_statics(law, position, large, /*is_dynamic=*/false);
          check_tangent(in_dynamics, {0.8, 1.7, 3.});
          // The velocity is a difference over the step.
          check_tangent(in_statics, {0.8, 0.8 / in_statics.dt, 0.});
        }
}

TEST(ConnectorForces, RotationOfTheLineIsNoRateInStatics)
{
  ConnectorAlone connector(kelvin_voigt,
                           from_0_to_1,
                           /*large_rotation=*/true,
                           /*is_dynamic=*/false);
  // Velocities from differences over the rotation would stretch the line.
  connector.turn(2.5, 0.);
  for (const int i : {0, 1})
    (*connector.to.velocity)[connector.setup.dofs().joint_unknown(1, i)] =
      connector.to.displacement[connector.setup.dofs().joint_unknown(1, i)] /
      connector.dt;
  EXPECT_NEAR(connector.report().force, 0., 20 * connector_round_off);

  // Stretched from 5 to 7 in half a second.
  connector.move(0, 0, 0);
  connector.move(1, -3, 3);
  EXPECT_NEAR(connector.report().force,
              2 * 2. + 3 * 2. / 0.5,
              20 * connector_round_off);
}

namespace
{
  /** Number of values in the records of the layout named `one: WHAT`. */
  unsigned int n_kept(const ConnectorAlone &connector, const std::string &what)
  {
    unsigned int n = 0;
    for (const Record &record : connector.layout.history.list())
      if (record.name == "one: " + what)
        n += record.items.size() * record.values_per_item;
    return n;
  }
} // namespace

TEST(ConnectorForces, RegistersOnlyTheHistoryThatTheLawNeeds)
{
  const std::string internal = "internal variables", lost = "dissipated energy";
  EXPECT_EQ(ConnectorAlone(spring, from_0_to_1).layout.history.n_values(), 0u);
  const ConnectorAlone parallel(kelvin_voigt, from_0_to_1);
  EXPECT_EQ(n_kept(parallel, internal), 0u);
  EXPECT_EQ(n_kept(parallel, lost), 1u);
  EXPECT_EQ(n_kept(ConnectorAlone(maxwell, from_0_to_1), internal), 1u);
  const ConnectorAlone three(maxwell, "Between = 0 1; 1 2; 0 2");
  EXPECT_EQ(n_kept(three, internal), 3u);
  EXPECT_EQ(three.layout.history.n_values(), 6u);
}

TEST(ConnectorForces, AcceptedStepsRecordStoredAndDissipatedEnergy)
{
  ConnectorAlone connector(kelvin_voigt, along_1_1);
  // Average rate over the step, for exact trapezoidal work.
  const double extension = 0.6 * std::sqrt(2.), rate = extension / connector.dt;
  connector.move(1, 0.6, 0.6);
  connector.push(1, 0.6 / connector.dt, 0.6 / connector.dt);
  const Energies energies = connector.evaluated().accept();
  EXPECT_NEAR(energies.stored(),
              2. / 2 * extension * extension,
              connector_round_off);
  EXPECT_NEAR(energies.dissipated(), 3 * rate * extension, connector_round_off);
  EXPECT_NEAR(connector.report().dissipated,
              3 * rate * extension,
              connector_round_off);
  EXPECT_EQ(energies.strain(), 0.);
}

TEST(ConnectorForces, ANonlinearLawMakesAllEquationsNonlinear)
{
  Scene         scene = read_scene_from_text(with_connector(spring, along_1_1),
                                     "test.prm",
                                     {"Effects/Large rotation=off"});
  const Lattice lattice = build_lattice(scene);
  const LatticeModel model(scene, lattice, MPI_COMM_SELF);
  EXPECT_TRUE(Equations(model).is_linear());

  scene.connectors[0].law =
    make_law("cubic", {{"Spring stiffness", "0"}, {"Cubic stiffness", "5"}});
  const Equations equations(model);
  EXPECT_FALSE(equations.is_linear());

  // Only the connector part of the tangent changes with the displacement: 3 k
  // u^2 along (1, 1) / sqrt 2.
  const int         row     = model.numbering.joint_unknown(1, 0);
  EvaluationResults results = equations.make_results();
  TangentMatrix     matrix(equations.pattern());
  const auto        stiffness = [&](const double extension) {
    const State from = equations.initial_state();
    State       to   = from;
    for (const unsigned int c : {0u, 1u})
      to.displacement[model.numbering.joint_unknown(1, c)] =
        extension / std::sqrt(2.);
    const Evaluation step = Evaluation::step(from, to, 1.);
    equations.residual(step, results);
    equations.tangent(step, results, {1., 0., 0.}, matrix);
    Vector unit(model.numbering.layout().n_local()), column(unit);
    unit[row] = 1;
    matrix.multiply(unit.data(), column.data());
    return column[row];
  };
  EXPECT_NEAR(stiffness(0.6) - stiffness(0.),
              3 * 5. * 0.6 * 0.6 / 2,
              10 * connector_round_off);
}

TEST(ConnectorForces, ALineOfLengthZeroIsRefused)
{
  const std::string message = input_error_of([] {
    // Two joints at one position, not connected by a strut.
    EquationsOnRanks(with_connector(spring, "Between = 1 3"),
                     {"Lattice/Joints=0 0; 3 4; 1 6; 3 4",
                      "Lattice/Struts=0 1; 2 3"});
  });
  EXPECT_TRUE(contains(message, "Connectors/one")) << message;
  EXPECT_TRUE(contains(message, "joint 1")) << message;
  EXPECT_TRUE(contains(message, "Geometry = direction")) << message;
}
