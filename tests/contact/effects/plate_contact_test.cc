#include <auxfem/time/time_stepper.h>

#include <contact/effects/pressed_step.h>
#include <gtest/gtest.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Kind = Evaluation::Kind;

  constexpr double dt = contact_step;

  const std::vector<ContactCase> contact_cases = {
    {"plane", 2, "Shape = plane | Position = 0.4 -0.101 | Normal = 0 2"},
    {"disc", 2, "Shape = sphere | Position = 0.5 -0.602 | Radius = 0.5"},
    {"plane in space",
     3,
     "Shape = plane | Position = 0 -0.051 0 | Normal = 0 1 0"},
    {"sphere", 3, "Shape = sphere | Position = 0.5 -0.552 0.03 | Radius = 0.5"},
    {"cylinder",
     3,
     "Shape = cylinder | Position = 0.5 -0.352 0 | Axis = 0.3 0 1 | Radius = "
     "0.3"}};

  double largest_contact_force(const std::vector<double> &values)
  {
    double largest = 0;
    for (const double value : values)
      largest = std::max(largest, std::abs(value));
    return largest;
  }
} // namespace

TEST(PlateContact, TangentIsTheDerivativeOfTheForces)
{
  for (const ContactCase &contact_case : contact_cases)
    for (const double friction : {0., 0.6})
      for (const Kind kind : {Kind::equilibrium,
                              Kind::step,
                              Kind::static_step,
                              Kind::discrete_gradient})
        {
          SCOPED_TRACE(contact_case.name + ", friction " +
                       testing_support::text(friction) + ", kind " +
                       std::to_string(int(kind)));
          PressedStep step(above_plate(contact_case, friction),
                           kind == Kind::discrete_gradient);
          // Error of differences over 2e-6 of forces of about one.
          EXPECT_LT(error_of_tangent(step, kind), 1e-8);
        }
}

TEST(PlateContact, ForcesOnStrutsAndPlateAreOpposite)
{
  for (const ContactCase &contact_case : contact_cases)
    for (const Kind kind : {Kind::step, Kind::discrete_gradient})
      {
        SCOPED_TRACE(contact_case.name);
        PressedStep step(above_plate(contact_case, 0.6),
                         kind == Kind::discrete_gradient);
        const auto  forces =
          EvaluatedAlone(step.contact, step.evaluation(kind)).residual;
        std::array<double, 3> sums  = {{0, 0, 0}};
        const auto            names = name_unknowns(step.setup.model);
        for (unsigned int i = 0; i < names.size(); ++i)
          if (const unsigned int c = std::get<3>(names[i].name); c < 3)
            sums[c] += forces[i];
        ASSERT_GT(largest_contact_force(forces), 1e-2);
        for (const double sum : sums)
          EXPECT_NEAR(sum, 0, 1e-15 * names.size());
      }
}

TEST(PlateContact, ForcesAreTheGradientOfTheStoredEnergy)
{
  for (const ContactCase &contact_case : contact_cases)
    {
      SCOPED_TRACE(contact_case.name);
      PressedStep      step(above_plate(contact_case, 0), false);
      const Evaluation at     = step.evaluation(Kind::equilibrium);
      const auto       forces = EvaluatedAlone(step.contact, at).residual;
      const double     h      = 1e-6;
      for (unsigned int i = 0; i < step.n; ++i)
        {
          const auto energy_at = [&](const double change) {
            step.to.displacement[i] += change;
            const double energy =
              EvaluatedAlone(step.contact, at).accept().stored();
            step.to.displacement[i] -= change;
            return energy;
          };
          EXPECT_NEAR((energy_at(h) - energy_at(-h)) / (2 * h),
                      forces[i],
                      1e-8);
        }
    }
}

TEST(PlateContact, MeanForcesDoTheWorkThatIsStoredOrLost)
{
  for (const ContactCase &contact_case : contact_cases)
    for (const double friction : {0., 0.6})
      {
        SCOPED_TRACE(contact_case.name);
        PressedStep  step(above_plate(contact_case, friction), true);
        State        at_start = step.from;
        const double stored_before =
          EvaluatedAlone(step.contact,
                         Evaluation::consistent_rates(step.from, at_start))
            .accept()
            .stored();
        const EvaluatedAlone evaluated(step.contact,
                                       step.evaluation(
                                         Kind::discrete_gradient));
        const Energies       after = evaluated.accept();
        double               work  = 0;
        for (unsigned int i = 0; i < step.n; ++i)
          work += evaluated.residual[i] *
            (step.to.displacement[i] - step.from.displacement[i]);
        // Round-off of some hundred products of numbers below one.
        EXPECT_NEAR(work,
                    after.stored() - stored_before + after.dissipated(),
                    1e-15);
        EXPECT_GT(std::abs(after.stored() - stored_before), 1e-4);
        EXPECT_EQ(after.dissipated() > 1e-5, friction > 0);
      }
}

TEST(PlateContact, FrictionIsThatOfCoulombWhereItSlips)
{
  // A rod normal to the plane; only its end touches.
  const double friction = 0.3, v0 = 1e-4, slip = 2;
  SceneText    text;
  text.frame("0 0; 0 1", "0 1")
    .rectangle("bar", 0.1, 0.2, {30, 5})
    .mesh(1)
    .time(1, dt, "newmark")
    .add("Plates/table", "Shape = plane | Position = 0 -0.1 | Normal = 0 1")
    .add("Contact",
         "Friction coefficient = 0.3 | Slip velocity = " +
           testing_support::text(v0));
  PressedStep         step(text, false);
  const DofNumbering &dofs = step.setup.dofs();
  for (Vector *values : {&step.to.displacement, &*step.to.velocity})
    std::fill(values->begin(), values->end(), 0.);
  step.to.displacement[dofs.joint_unknown(0, 1)] = -0.01;
  (*step.to.velocity)[dofs.joint_unknown(0, 0)]  = slip;
  const EvaluatedAlone evaluated(step.contact, step.evaluation(Kind::step));
  const auto           on_rod = [&](const unsigned int component) {
    return -evaluated.residual[dofs.joint_unknown(0, component)] -
      evaluated.residual[dofs.joint_unknown(1, component)];
  };
  const double across = on_rod(1), along = on_rod(0);
  // E A / (2 h^2) of a cap beyond the smooth part, plus the integral over the
  // penetrating part of the rod.
  const double smoothing = 1e-3, depth = 0.01;
  EXPECT_NEAR(across,
              30 *
                (0.1 * (depth - smoothing / 2) +
                 (depth * (depth - smoothing) / 2 + smoothing * smoothing / 6) /
                   1.01),
              1e-13);
  EXPECT_NEAR(along, -friction * across, friction * across * v0 * v0);
  // Without slip there is no friction.
  (*step.to.velocity)[dofs.joint_unknown(0, 0)] = 0;
  EXPECT_EQ(EvaluatedAlone(step.contact, step.evaluation(Kind::step))
              .residual[dofs.joint_unknown(0, 0)],
            0);
}

namespace
{
  /**
   * Number of elements coupled with a plate below a lattice that moves down at
   * @p speed (m/s).
   */
  std::size_t n_coupled(const double gap, const double speed)
  {
    ContactCase far = contact_cases[0];
    far.plate       = "Shape = plane | Normal = 0 1 | Position = 0 " +
      testing_support::text(-0.1 - gap);
    EquationsOnRanks setup(above_plate(far, 0), {}, MPI_COMM_SELF);
    State            state    = setup.equations.initial_state();
    const auto       n_before = setup.equations.pattern().n_blocks();
    for (const int joint : {0, 1, 2})
      (*state.velocity)[setup.dofs().joint_unknown(joint, 1)] = -speed;
    setup.equations.update_couplings(state);
    return setup.equations.pattern().n_blocks() - n_before;
  }
} // namespace

TEST(PlateContact, CouplesOnlyNearElements)
{
  // Four elements exist; balls of 0.55 of their length bound them, and those
  // closer than two thicknesses are coupled.
  EXPECT_EQ(n_coupled(0.001, 0), 3u);
  EXPECT_EQ(n_coupled(0.6, 0), 2u);
  EXPECT_EQ(n_coupled(10, 0), 0u);
}

TEST(PlateContact, CouplesElementsThatAreNearInTheNextStep)
{
  EXPECT_EQ(n_coupled(3, 1), 0u);
  EXPECT_EQ(n_coupled(3, 3 / dt), 4u);
}

namespace
{
  /** Rejection reason of a step in which the lattice moves by (x, y). */
  std::string why_not_moved_by(const std::string &plate,
                               const double       x,
                               const double       y,
                               const bool         is_near)
  {
    ContactCase contact_case = contact_cases[0];
    contact_case.plate       = plate;
    EquationsOnRanks setup(above_plate(contact_case, 0), {}, MPI_COMM_SELF);
    State            from = setup.equations.initial_state();
    if (is_near)
      setup.equations.update_couplings(from);
    State      to    = from;
    const auto names = name_unknowns(setup.model);
    for (unsigned int i = 0; i < names.size(); ++i)
      if (std::get<3>(names[i].name) < 2 &&
          !(std::get<0>(names[i].name) &&
            std::get<1>(names[i].name) == setup.lattice.joint_of_plate(0)))
        to.displacement[i] = std::get<3>(names[i].name) == 0 ? x : y;
    return setup.equations.reporting().plates->rejection_reason(
      Evaluation::step(from, to, dt));
  }
} // namespace

TEST(PlateContact, StepsIntoOrThroughAPlateAreRejected)
{
  const std::string plane = "Shape = plane | Normal = 0 1 | Position = 0 -0.11",
                    disc =
                      "Shape = sphere | Position = 0.5 -0.37 | Radius = 0.25";
  // A quarter of the thickness is allowed after a gap of 0.01.
  EXPECT_EQ(why_not_moved_by(plane, 0, -0.059, true), "");
  expect_parts(why_not_moved_by(plane, 0, -0.061, true),
               {"strut 0 would go 0.051 m into the plate \"plate\"",
                "Contact/Largest penetration"});
  // Uncoupled struts must not touch at all.
  EXPECT_EQ(why_not_moved_by(plane, 0, -0.009, false), "");
  expect_parts(why_not_moved_by(plane, 0, -0.011, false), {"0.001 m into"});
  // Without contact at both ends of the step, but not between.
  expect_parts(why_not_moved_by(disc, 0, -2, true), {"into the plate"});
  // Also between two points of an element.
  const std::string point =
    "Shape = sphere | Position = 0.1234 -0.37 | Radius = 1e-4";
  expect_parts(why_not_moved_by(point, 0, -2, true), {"into the plate"});
  expect_parts(why_not_moved_by(point, 0, -2, false), {"into the plate"});
  EXPECT_EQ(why_not_moved_by(disc, 0, 2, true), "");
  EXPECT_EQ(why_not_moved_by(disc, 3, 0, true), "");
}

namespace
{
  /** Results of an evaluation by name of unknowns, and sums over all ranks. */
  struct RankResults
  {
    RankResults(const ContactCase &contact_case,
                const Kind         kind,
                const MPI_Comm     communicator)
      : step(above_plate(contact_case, 0.6),
             kind == Kind::discrete_gradient,
             communicator)
    {
      const Evaluation  evaluation = step.evaluation(kind);
      EquationsOnRanks &on_ranks   = step.setup;
      on_ranks.residual(evaluation);
      forces      = by_name(on_ranks.model, step.to.residual);
      auto matrix = on_ranks.make_tangent();
      on_ranks.tangent(evaluation, {1., 2 / dt, 4 / (dt * dt)}, *matrix);
      Vector direction(step.n);
      fill_by_position(on_ranks.model, 1., direction);
      step.layout().update_ghosts(direction.data());
      Vector y(step.n);
      matrix->multiply(direction.data(), y.data());
      product = by_name(on_ranks.model, y);
      on_ranks.accept(evaluation);
      reports =
        step.contact.reports(on_ranks.equations.plate_results(on_ranks.results),
                             step.to);
      stored     = step.to.energies.stored();
      dissipated = step.to.energies.dissipated();
    }

    PressedStep                   step;
    std::map<UnknownName, double> forces, product;
    std::vector<PlateReport>      reports;
    double                        stored, dissipated;
  };

  void expect_equal(const std::map<UnknownName, double> &some,
                    const std::map<UnknownName, double> &all)
  {
    double scale = 0;
    for (const auto &[name, value] : all)
      scale = std::max(scale, std::abs(value));
    for (const auto &[name, value] : some)
      EXPECT_NEAR(value, all.at(name), 1e-12 * scale);
  }
} // namespace

TEST(PlateContactOnRanks, IsTheSame)
{
  for (const ContactCase &contact_case : contact_cases)
    for (const Kind kind : {Kind::step, Kind::discrete_gradient})
      {
        SCOPED_TRACE(contact_case.name);
        const RankResults all(contact_case, kind, MPI_COMM_WORLD),
          alone(contact_case, kind, MPI_COMM_SELF);
        expect_equal(all.forces, alone.forces);
        expect_equal(all.product, alone.product);
        EXPECT_NEAR(all.stored, alone.stored, 1e-14);
        EXPECT_NEAR(all.dissipated, alone.dissipated, 1e-14);
        EXPECT_GT(alone.dissipated, 0);
        EXPECT_NEAR(all.reports[0].largest_penetration,
                    alone.reports[0].largest_penetration,
                    1e-14);
        for (unsigned int c = 0; c < 3; ++c)
          EXPECT_NEAR(all.reports[0].force[c],
                      alone.reports[0].force[c],
                      1e-13);
      }
}
