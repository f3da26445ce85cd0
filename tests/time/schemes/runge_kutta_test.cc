#include <auxfem/time/schemes/runge_kutta.h>
#include <auxfem/time/schemes/step_control.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numeric>

using namespace auxfem;

namespace
{
  using Values = std::vector<double>;

  /** A times @p values. */
  Values applied(const ButcherTableau &tableau, const Values &values)
  {
    Values result(values.size(), 0.);
    for (unsigned int i = 0; i < values.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        result[i] += tableau.factors[i][j] * values[j];
    return result;
  }

  Values times(const Values &one, const Values &other)
  {
    Values result(one);
    for (unsigned int i = 0; i < one.size(); ++i)
      result[i] *= other[i];
    return result;
  }

  double sum(const Values &weights, const Values &values)
  {
    return std::inner_product(weights.begin(),
                              weights.end(),
                              values.begin(),
                              0.);
  }

  /** Both sides of the conditions of order 1 to 5, by order (Butcher). */
  std::vector<std::vector<std::pair<double, double>>>
  order_conditions(const ButcherTableau &t, const Values &b)
  {
    const Values one(t.n_stages(), 1.),
      c = t.times, c2 = times(c, c), c3 = times(c, c2), ac = applied(t, c),
      ac2 = applied(t, c2), aac = applied(t, ac);
    return {{{sum(b, one), 1}},
            {{sum(b, c), 1. / 2}},
            {{sum(b, c2), 1. / 3}, {sum(b, ac), 1. / 6}},
            {{sum(b, c3), 1. / 4},
             {sum(b, times(c, ac)), 1. / 8},
             {sum(b, ac2), 1. / 12},
             {sum(b, aac), 1. / 24}},
            {{sum(b, times(c, c3)), 1. / 5},
             {sum(b, times(c2, ac)), 1. / 10},
             {sum(b, times(c, ac2)), 1. / 15},
             {sum(b, times(c, aac)), 1. / 30},
             {sum(b, times(ac, ac)), 1. / 20},
             {sum(b, applied(t, c3)), 1. / 20},
             {sum(b, applied(t, times(c, ac))), 1. / 40},
             {sum(b, applied(t, ac2)), 1. / 60},
             {sum(b, applied(t, aac)), 1. / 120}}};
  }

  /** Whether all conditions up to @p order hold. */
  bool is_of_order(const ButcherTableau &tableau,
                   const Values         &weights,
                   const unsigned int    order)
  {
    const auto conditions = order_conditions(tableau, weights);
    for (unsigned int p = 0; p < order; ++p)
      for (const auto &[is, should_be] : conditions[p])
        if (std::abs(is - should_be) > 1e-13)
          return false;
    return true;
  }
} // namespace

class Esdirk : public testing::TestWithParam<unsigned int>
{
protected:
  const unsigned int   order   = GetParam();
  const ButcherTableau tableau = esdirk_tableau(order);
};

TEST_P(Esdirk, HasItsOrderAndItsEmbeddedSchemeOneLess)
{
  Values embedded = tableau.weights;
  for (unsigned int i = 0; i < tableau.n_stages(); ++i)
    embedded[i] -= tableau.embedded_difference[i];
  EXPECT_TRUE(is_of_order(tableau, tableau.weights, order));
  EXPECT_TRUE(is_of_order(tableau, embedded, order - 1));
  EXPECT_FALSE(is_of_order(tableau, embedded, order));
}

TEST_P(Esdirk, BeginsAtTheStartAndEndsWithTheSolution)
{
  EXPECT_EQ(tableau.times.front(), 0);
  EXPECT_EQ(tableau.factors.front().front(), 0);
  EXPECT_EQ(tableau.times.back(), 1);
  for (unsigned int i = 0; i < tableau.n_stages(); ++i)
    {
      EXPECT_NEAR(tableau.factors.back()[i], tableau.weights[i], 1e-15);
      EXPECT_GE(tableau.times[i], 0);
      EXPECT_LE(tableau.times[i], 1);
      if (i > 0)
        {
          EXPECT_NEAR(tableau.factors[i][i], tableau.diagonal, 1e-15);
        }
    }
}

TEST_P(Esdirk, DampsUnresolvedMotions)
{
  const RungeKutta scheme("esdirk", tableau);
  EXPECT_NEAR(scheme.amplification(0), 1, 1e-15);
  for (double angle = 0.01; angle < 1e6; angle *= 1.1)
    EXPECT_LE(scheme.amplification(angle), 1 + 1e-12) << angle;
  EXPECT_LT(scheme.amplification(1e6), 1e-4);
}

TEST_P(Esdirk, ErrorsAreEstimatedUpToOrderFour)
{
  EXPECT_EQ(RungeKutta("esdirk", tableau).estimates_errors(), order <= 4);
}

TEST_P(Esdirk, KnowsItsErrorInAnOscillation)
{
  // One step of length z of y' = i y: its error over the difference from the
  // embedded scheme.
  using Complex = std::complex<double>;
  for (const double z : {0.05, 0.1, 1., 2., 6., 30.})
    {
      std::vector<Complex> y(tableau.n_stages(), 1.);
      Complex              difference = 0;
      for (unsigned int i = 0; i < y.size(); ++i)
        {
          for (unsigned int j = 0; j < i; ++j)
            y[i] += tableau.factors[i][j] * Complex(0, z) * y[j];
          y[i] /= 1. - tableau.factors[i][i] * Complex(0, z);
          difference += tableau.embedded_difference[i] * Complex(0, z) * y[i];
        }
      const double error = std::abs(y.back() - std::exp(Complex(0, z)));
      EXPECT_NEAR(RungeKutta("esdirk", tableau).error_by_difference(z) *
                    std::abs(difference) / error,
                  1,
                  z < 0.1 ? 0.05 : 1e-8)
        << z;
    }
}

TEST_P(Esdirk, KnowsItsErrorInQuadraticForms)
{
  // y' = -z y over a step of length one, y_0 = 1; no step resolves it.
  const double z = 30;
  Values       y(tableau.n_stages(), 1.);
  double       growth = 0, missed = 0;
  for (unsigned int i = 0; i < y.size(); ++i)
    {
      for (unsigned int j = 0; j < i; ++j)
        y[i] -= tableau.factors[i][j] * z * y[j];
      y[i] /= 1 + tableau.factors[i][i] * z;
      growth -= tableau.weights[i] * z * y[i] * y[i];
    }
  for (unsigned int i = 0; i < y.size(); ++i)
    for (unsigned int j = 0; j < y.size(); ++j)
      missed += tableau.missed_growth(i, j) * z * z * y[i] * y[j] / 2;
  EXPECT_GT(std::abs(missed), 0.1);
  EXPECT_NEAR(growth - missed, (y.back() * y.back() - 1) / 2, 1e-12);
}

TEST_P(Esdirk, ItsStageIsEulersBackwardRule)
{
  const RungeKutta scheme("esdirk", tableau);
  StateLayout      layout;
  layout.velocity = layout.acceleration = true;
  State base(1, layout), to(1, layout);
  base.displacement        = {2};
  *base.velocity           = {3};
  *base.acceleration       = {5};
  const double dt          = 0.1;
  const auto   expect_rule = [&] {
    EXPECT_NEAR((*to.velocity)[0], 3 + dt * (*to.acceleration)[0], 1e-14);
    EXPECT_NEAR(to.displacement[0], 2 + dt * (*to.velocity)[0], 1e-14);
  };
  scheme.predict(base, dt, to);
  EXPECT_EQ((*to.acceleration)[0], 5);
  expect_rule();
  scheme.correct(base, {0.7}, dt, to);
  expect_rule();
}

INSTANTIATE_TEST_SUITE_P(Orders, Esdirk, testing::Values(3, 4, 5));

TEST(Extrapolation, IsExactForParabolas)
{
  const auto   parabola = [](const double t) { return 1 - 2 * t + 3 * t * t; };
  const Values points   = {-1, 0.5, -0.4, 0};
  for (const double time : {-0.2, 0.3, 0.9})
    {
      double guess = 0;
      for (const auto &[point, weight] : extrapolation(points, time))
        guess += weight * parabola(points[point]);
      EXPECT_NEAR(guess, parabola(time), 1e-13);
    }
}

TEST(Extrapolation, UsesOneValueWhereMoreWouldAmplifyErrors)
{
  // Two equal times and a third nearby: weights of a parabola at 1 would be
  // about 1e4.
  const auto weights = extrapolation({0, 0, 0.01}, 1);
  ASSERT_EQ(weights.size(), 1u);
  EXPECT_EQ(weights[0], std::make_pair(2u, 1.));
}

TEST(Extrapolation, IsEmptyWithoutValues)
{
  EXPECT_TRUE(extrapolation({}, 1).empty());
}
