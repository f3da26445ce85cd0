#include <auxfem/time/schemes/alpha_family.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <array>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Coefficients = AlphaFamily::Coefficients;

  const std::vector<Coefficients> members = {
    AlphaFamily::newmark(0.25, 0.5),
    AlphaFamily::newmark(0.3025, 0.6),
    AlphaFamily::hht(-0.05),
    AlphaFamily::hht(-1. / 3),
    AlphaFamily::generalized_alpha(0.),
    AlphaFamily::generalized_alpha(0.8),
    AlphaFamily::generalized_alpha(1.)};

  /** States with the unknowns of a strut, without equations. */
  struct BareStates
  {
    BareStates()
      : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
      , from(setup.dofs().layout().n_local(), layout())
      , to(from)
    {
      fill_by_position(setup.model, 0.3, from.displacement);
      fill_by_position(setup.model, 1.7, *from.velocity);
      fill_by_position(setup.model, 2.3, *from.acceleration);
      fill_by_position(setup.model, -1.1, *from.algorithmic_acceleration);
      fill_by_position(setup.model, 0.9, to.residual);
    }

    static StateLayout layout()
    {
      StateLayout layout;
      layout.velocity = layout.acceleration = true;
      layout.algorithmic_acceleration       = true;
      return layout;
    }

    EquationsOnRanks setup;
    State            from, to;
  };

  // Some ten products of numbers up to 1000.
  constexpr double product_tolerance = 1e-12;
} // namespace

TEST(AlphaFamily, CoefficientsAreThoseOfTheLiterature)
{
  // Hilber, Hughes & Taylor 1977 for alpha = -0.1.
  const Coefficients hht = AlphaFamily::hht(-0.1);
  EXPECT_DOUBLE_EQ(hht.alpha_m, 0.);
  EXPECT_DOUBLE_EQ(hht.alpha_f, 0.1);
  EXPECT_DOUBLE_EQ(hht.beta, 0.3025);
  EXPECT_DOUBLE_EQ(hht.gamma, 0.6);

  // Chung & Hulbert 1993, eq. 25: midpoint rule without damping,
  // asymptotic annihilation.
  const Coefficients midpoint = AlphaFamily::generalized_alpha(1.);
  EXPECT_DOUBLE_EQ(midpoint.alpha_m, 0.5);
  EXPECT_DOUBLE_EQ(midpoint.alpha_f, 0.5);
  EXPECT_DOUBLE_EQ(midpoint.beta, 0.25);
  EXPECT_DOUBLE_EQ(midpoint.gamma, 0.5);
  const Coefficients annihilating = AlphaFamily::generalized_alpha(0.);
  EXPECT_DOUBLE_EQ(annihilating.alpha_m, -1.);
  EXPECT_DOUBLE_EQ(annihilating.alpha_f, 0.);
  EXPECT_DOUBLE_EQ(annihilating.beta, 1.);
  EXPECT_DOUBLE_EQ(annihilating.gamma, 1.5);

  const Coefficients newmark = AlphaFamily::newmark(0.3, 0.6);
  EXPECT_DOUBLE_EQ(newmark.alpha_m, 0.);
  EXPECT_DOUBLE_EQ(newmark.alpha_f, 0.);
  EXPECT_DOUBLE_EQ(newmark.beta, 0.3);
  EXPECT_DOUBLE_EQ(newmark.gamma, 0.6);
}

TEST(AlphaFamily, SecondOrderMembersFulfilItsConstraint)
{
  // Chung & Hulbert 1993, eq. 17.
  for (const double radius : {0., 0.3, 0.8, 1.})
    {
      const Coefficients c = AlphaFamily::generalized_alpha(radius);
      EXPECT_NEAR(c.gamma, 0.5 - c.alpha_m + c.alpha_f, 1e-15);
    }
  for (const double alpha : {-1. / 3, -0.1, 0.})
    {
      const Coefficients c = AlphaFamily::hht(alpha);
      EXPECT_NEAR(c.gamma, 0.5 - c.alpha_m + c.alpha_f, 1e-15);
    }
}

TEST(AlphaFamily, OnlyShiftedMembersCarryASecondAcceleration)
{
  EXPECT_FALSE(AlphaFamily("member", AlphaFamily::newmark(0.25, 0.5))
                 .uses_algorithmic_acceleration());
  EXPECT_TRUE(AlphaFamily("member", AlphaFamily::hht(-0.1))
                .uses_algorithmic_acceleration());
  EXPECT_TRUE(AlphaFamily("member", AlphaFamily::generalized_alpha(0.8))
                .uses_algorithmic_acceleration());
  EXPECT_TRUE(
    AlphaFamily("member", AlphaFamily::newmark(0.25, 0.5)).is_dynamic());
}

TEST(AlphaFamily, PredictionAndCorrectionFulfilTheFormulas)
{
  const double dt = 0.07;
  for (const Coefficients &c : members)
    {
      const AlphaFamily scheme("member", c);
      BareStates        states;
      scheme.predict(states.from, dt, states.to);
      Vector increment(states.to.residual);
      scheme.correct(states.from, increment, dt, states.to);
      scheme.correct(states.from, increment, dt, states.to);
      const bool shifted = scheme.uses_algorithmic_acceleration();
      for (unsigned int i = 0; i < increment.size(); ++i)
        {
          const double u      = states.from.displacement[i],
                       v      = (*states.from.velocity)[i],
                       dv     = (*states.from.acceleration)[i];
          const double dv_new = (*states.to.acceleration)[i];
          const double a =
            shifted ? (*states.from.algorithmic_acceleration)[i] : dv;
          const double a_new =
            shifted ? (*states.to.algorithmic_acceleration)[i] : dv_new;
          EXPECT_NEAR((1 - c.alpha_m) * a_new + c.alpha_m * a,
                      (1 - c.alpha_f) * dv_new + c.alpha_f * dv,
                      product_tolerance);
          EXPECT_NEAR(states.to.displacement[i],
                      u + dt * v +
                        dt * dt * ((0.5 - c.beta) * a + c.beta * a_new),
                      product_tolerance);
          EXPECT_NEAR((*states.to.velocity)[i],
                      v + dt * ((1 - c.gamma) * a + c.gamma * a_new),
                      product_tolerance);
        }
    }
}

TEST(AlphaFamily, PredictionKeepsTheAcceleration)
{
  for (const Coefficients &c : members)
    {
      BareStates states;
      AlphaFamily("member", c).predict(states.from, 0.07, states.to);
      for (unsigned int i = 0; i < states.from.displacement.size(); ++i)
        EXPECT_EQ((*states.to.acceleration)[i], (*states.from.acceleration)[i]);
    }
}

TEST(AlphaFamily, FactorsMatchTheCorrection)
{
  const double dt = 0.07;
  for (const Coefficients &c : members)
    {
      const AlphaFamily    scheme("member", c);
      BareStates           states;
      const TangentFactors factors = scheme.factors(states.from, dt);
      scheme.predict(states.from, dt, states.to);
      const State  before = states.to;
      const Vector increment(states.to.residual);
      scheme.correct(states.from, increment, dt, states.to);
      for (unsigned int i = 0; i < increment.size(); ++i)
        {
          EXPECT_NEAR(states.to.displacement[i] - before.displacement[i],
                      factors.stiffness * increment[i],
                      product_tolerance);
          EXPECT_NEAR((*states.to.velocity)[i] - (*before.velocity)[i],
                      factors.damping * increment[i],
                      product_tolerance);
          EXPECT_NEAR((*states.to.acceleration)[i] - (*before.acceleration)[i],
                      factors.mass * increment[i],
                      product_tolerance);
        }
    }
}

namespace
{
  /**
   * One step of v' = -frequency^2 u with dt = 1 from u, v, a; the scheme acts
   * on one unknown.
   */
  std::array<double, 3> oscillator_step(const AlphaFamily           &scheme,
                                        const double                 frequency,
                                        const std::array<double, 3> &start)
  {
    BareStates   states;
    const double k                             = frequency * frequency;
    states.from.displacement[0]                = start[0];
    (*states.from.velocity)[0]                 = start[1];
    (*states.from.algorithmic_acceleration)[0] = start[2];
    (*states.from.acceleration)[0]             = -k * start[0];
    scheme.predict(states.from, 1., states.to);
    const TangentFactors factors = scheme.factors(states.from, 1.);
    Vector               increment(states.to.displacement);
    increment.assign(increment.size(), 0);
    increment[0] =
      -((*states.to.acceleration)[0] + k * states.to.displacement[0]) /
      (factors.mass + k * factors.stiffness);
    scheme.correct(states.from, increment, 1., states.to);
    return {{states.to.displacement[0],
             (*states.to.velocity)[0],
             (*states.to.algorithmic_acceleration)[0]}};
  }
} // namespace

TEST(AlphaFamily, SpectralRadiusAtInfinityIsAsGiven)
{
  // All three eigenvalues tend to -r (Chung & Hulbert 1993, section 4): the
  // characteristic polynomial tends to (x + r)^3.
  for (const double r : {0.2, 0.5, 0.8, 1.})
    {
      const AlphaFamily scheme("member", AlphaFamily::generalized_alpha(r));
      const double      frequency = 3000;
      double            A[3][3];
      for (unsigned int j = 0; j < 3; ++j)
        {
          std::array<double, 3> unit{{0, 0, 0}};
          unit[j]           = 1;
          const auto column = oscillator_step(scheme, frequency, unit);
          for (unsigned int i = 0; i < 3; ++i)
            A[i][j] = column[i];
        }
      const auto minor = [&A](const int i, const int j) {
        return A[i][i] * A[j][j] - A[i][j] * A[j][i];
      };
      double determinant = 0;
      for (int j = 0; j < 3; ++j)
        determinant += A[0][j] *
          (A[1][(j + 1) % 3] * A[2][(j + 2) % 3] -
           A[1][(j + 2) % 3] * A[2][(j + 1) % 3]);
      // 1 / frequency^2 = 1e-7 times some factor; round-off times frequency^2
      // is 1e-9.
      const double tolerance = 1e-5;
      EXPECT_NEAR(A[0][0] + A[1][1] + A[2][2], -3 * r, tolerance);
      EXPECT_NEAR(minor(0, 1) + minor(0, 2) + minor(1, 2),
                  3 * r * r,
                  tolerance);
      EXPECT_NEAR(determinant, -r * r * r, tolerance);
    }
}
