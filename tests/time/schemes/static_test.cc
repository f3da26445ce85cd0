#include <auxfem/time/schemes/static.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  struct ViscousStates
  {
    ViscousStates()
      : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
      , from(setup.dofs().layout().n_local(), layout())
      , to(from)
      , increment(setup.dofs().layout().n_local())
    {
      fill_by_position(setup.model, 0.3, from.displacement);
      fill_by_position(setup.model, 1.7, *from.velocity);
      fill_by_position(setup.model, 0.2, increment);
    }

    static StateLayout layout()
    {
      StateLayout layout;
      layout.velocity = true;
      return layout;
    }

    EquationsOnRanks setup;
    State            from, to;
    Vector           increment;
  };
} // namespace

TEST(QuasiStatic, VelocityInTheFirstStepIsThatOfTheStep)
{
  const QuasiStatic scheme;
  ViscousStates     states;
  const double      dt = 0.25;
  scheme.predict(states.from, dt, states.to);
  scheme.correct(states.from, states.increment, dt, states.to);
  scheme.correct(states.from, states.increment, dt, states.to);
  for (unsigned int i = 0; i < states.increment.size(); ++i)
    {
      EXPECT_NEAR(states.to.displacement[i],
                  states.from.displacement[i] + 2 * states.increment[i],
                  1e-15);
      // A few roundings of numbers below 2.
      EXPECT_NEAR((*states.to.velocity)[i],
                  (states.to.displacement[i] - states.from.displacement[i]) /
                    dt,
                  1e-14);
    }
}

TEST(QuasiStatic, VelocityIsExactForAParabola)
{
  // u = 2 + 3 t - t^2 times a pattern, known at t = 0.3, 0.4 and 0.65 s.
  const QuasiStatic scheme;
  ViscousStates     states;
  const Vector      pattern = states.increment;
  const auto        times   = [&pattern](const double factor) {
    Vector values(pattern);
    for (double &value : values)
      value *= factor;
    return values;
  };
  const auto u             = [](const double t) { return 2 + 3 * t - t * t; };
  states.from.time         = 0.4;
  states.from.displacement = times(u(0.4));
  states.from.before.emplace();
  states.from.before->time_of_loads = 0.3;
  states.from.before->dt            = 0.1;
  states.from.before->displacement  = times(u(0.3));
  scheme.predict(states.from, 0.25, states.to);
  scheme.correct(states.from, times(u(0.65) - u(0.4)), 0.25, states.to);
  for (unsigned int i = 0; i < pattern.size(); ++i)
    {
      EXPECT_NEAR(states.to.displacement[i], u(0.65) * pattern[i], 1e-14);
      EXPECT_NEAR((*states.to.velocity)[i], (3 - 1.3) * pattern[i], 1e-13);
    }
  EXPECT_EQ(states.to.before->time_of_loads, 0.4);
  EXPECT_EQ(states.to.before->dt, 0.25);
  EXPECT_EQ(states.to.before->displacement, states.from.displacement);
}

TEST(QuasiStatic, FactorsMatchTheCorrection)
{
  const TangentFactors factors =
    QuasiStatic().factors(ViscousStates().from, 0.25);
  EXPECT_EQ(factors.stiffness, 1.);
  EXPECT_EQ(factors.damping, 4.);
  EXPECT_EQ(factors.mass, 0.);
  EXPECT_FALSE(QuasiStatic().is_dynamic());
  EXPECT_FALSE(QuasiStatic().uses_algorithmic_acceleration());
}

TEST(Equilibrium, MovesOnlyDisplacements)
{
  const Equilibrium scheme;
  ViscousStates     states;
  // There is no step, so its length has no effect.
  for (const double dt : {0., 0.25})
    {
      scheme.predict(states.from, dt, states.to);
      scheme.correct(states.from, states.increment, dt, states.to);
      for (unsigned int i = 0; i < states.increment.size(); ++i)
        EXPECT_EQ(states.to.displacement[i],
                  states.from.displacement[i] + states.increment[i]);
      const double size = largest_size(*states.to.velocity);
      EXPECT_EQ(size, 0.);
      EXPECT_EQ(scheme.factors(states.from, dt).stiffness, 1.);
      EXPECT_EQ(scheme.factors(states.from, dt).damping, 0.);
      EXPECT_EQ(scheme.factors(states.from, dt).mass, 0.);
    }
  EXPECT_FALSE(scheme.is_dynamic());
}
