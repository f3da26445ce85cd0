#include <auxfem/struts/effects/strut_inertia.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <map>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // rho A = 1.5 kg/m, rho I = 0.35 kg m.
  constexpr double mass_per_length = 1.5, rotary_per_length = 0.35;

  /** A strut of 5 m from (0, 0) to (3, 4). */
  const std::string oblique_strut = frame_scene("0 0; 3 4", "0 1");

  /** Inertia of the struts of a scene, without other effects. */
  struct InertiaAlone
  {
    InertiaAlone(const std::string              &text,
                 const std::vector<std::string> &overrides,
                 const bool                      rotary  = true,
                 const bool                      damping = false)
      : setup(text, overrides, MPI_COMM_SELF)
      , inertia(make_strut_inertia(setup.lattice,
                                   setup.dofs(),
                                   setup.dofs().groups().front(),
                                   setup.model.sections,
                                   {/*large_rotation=*/true, rotary, damping}))
      , layout(setup.equations.layout())
      , from(setup.equations.initial_state())
      , to(from)
    {
      inertia->register_in(layout);
      make_room(layout, from);
      make_room(layout, to);
    }

    /** Evaluation at the end of a step of one second. */
    EvaluatedAlone evaluated()
    {
      return {*inertia, Evaluation::step(from, to, 1.)};
    }

    /** Moves all points as a rigid body that turns about (0, 0). */
    void turn(const double angular, Vector &motion) const
    {
      const auto names = name_unknowns(setup.model);
      for (unsigned int i = 0; i < names.size(); ++i)
        {
          const std::map<unsigned int, double> values = {
            {0, -angular * names[i].position[1]},
            {1, angular * names[i].position[0]},
            {rotation_z, angular}};
          motion[i] = values.at(std::get<3>(names[i].name));
        }
    }

    EquationsOnRanks        setup;
    std::unique_ptr<Effect> inertia;
    StateLayout             layout;
    State                   from, to;
  };

  const std::vector<std::string> orders = {"1", "2", "3", "4", "5", "6"};
} // namespace

TEST(StrutInertia, KineticEnergyOfATurningStrutIsExact)
{
  // L^3 / 3 about the end, plus rotary inertia of the sections.
  const double moment = mass_per_length * 125. / 3 + rotary_per_length * 5;
  for (const std::string &order : orders)
    {
      InertiaAlone one(oblique_strut, {"Discretization/Order=" + order});
      one.turn(2., *one.to.velocity);
      const Energies energies = one.evaluated().accept();
      // Some 50 roundings.
      EXPECT_NEAR(energies.kinetic(), 0.5 * moment * 4, 1e-14 * 100 * moment);
    }
}

TEST(StrutInertia, ForcesOfAnAcceleratedStrutSumToItsMass)
{
  for (const std::string &order : orders)
    {
      InertiaAlone one(oblique_strut,
                       {"Discretization/Order=" + order,
                        "Discretization/Global refinements=2"});
      const auto   names = name_unknowns(one.setup.model);
      for (unsigned int i = 0; i < names.size(); ++i)
        (*one.to.acceleration)[i] = std::get<3>(names[i].name) == 1 ? 2. : 0.;
      const std::vector<double> residual = one.evaluated().residual;
      double                    sums[n_motion_components] = {};
      for (unsigned int i = 0; i < names.size(); ++i)
        sums[std::get<3>(names[i].name)] += residual[i];
      EXPECT_NEAR(sums[0], 0., 1e-13);
      EXPECT_NEAR(sums[1], 2 * mass_per_length * 5, 1e-13);
      EXPECT_NEAR(sums[rotation_z], 0., 1e-13);
    }
}

TEST(StrutInertia, RotaryInertiaCanBeLeftOut)
{
  InertiaAlone one(oblique_strut, {}, /*rotary=*/false);
  one.turn(2., *one.to.velocity);
  const Energies energies = one.evaluated().accept();
  EXPECT_NEAR(energies.kinetic(), 0.5 * mass_per_length * 125. / 3 * 4, 1e-11);
}

TEST(StrutInertia, MassProportionalDampingIsAForceOnTheVelocity)
{
  const std::vector<std::string> damped = {
    "Sections/band/Mass-proportional damping=0.7"};
  InertiaAlone by_velocity(oblique_strut, damped, true, true),
    by_acceleration(oblique_strut, damped, true, true);
  fill_by_position(by_velocity.setup.model, 1., *by_velocity.to.velocity);
  fill_by_position(by_acceleration.setup.model,
                   0.7,
                   *by_acceleration.to.acceleration);
  const EvaluatedAlone moving      = by_velocity.evaluated();
  const EvaluatedAlone accelerated = by_acceleration.evaluated();
  for (unsigned int i = 0; i < moving.residual.size(); ++i)
    EXPECT_NEAR(moving.residual[i], accelerated.residual[i], 1e-14);
}

TEST(StrutInertia, MassProportionalDampingDissipatesThePowerOfTheMeanVelocity)
{
  InertiaAlone one(oblique_strut,
                   {"Sections/band/Mass-proportional damping=0.7"},
                   true,
                   true);
  Vector      &v = *one.from.velocity;
  fill_by_position(one.setup.model, 1., v);
  // In one second at this velocity, damping dissipates a v.M v, twice a times
  // the kinetic energy; the numerical work is zero.
  *one.to.velocity    = v;
  one.to.displacement = v;
  const Energies even = one.evaluated().accept();
  EXPECT_NEAR(even.dissipated(), 2 * 0.7 * even.kinetic(), 1e-13);
  EXPECT_NEAR(even.numerical(), 0, 1e-13);

  // Velocities that oscillate about rest: no dissipation.
  one.to.displacement.assign(v.size(), 0.);
  for (unsigned int i = 0; i < v.size(); ++i)
    (*one.to.velocity)[i] = -v[i];
  const Energies ringing = one.evaluated().accept();
  EXPECT_NEAR(ringing.dissipated(), 0, 1e-13);
  EXPECT_NEAR(ringing.numerical(), 0, 1e-13);
}
