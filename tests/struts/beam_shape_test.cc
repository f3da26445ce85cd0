#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/beam_shape.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace auxfem;

namespace
{
  // Shape functions are at most 1 and products of at most 6 factors; sums of 7
  // of them keep an error of some 50 roundings.
  constexpr double shape_round_off = 2e-14;

  /** Calls @p check with the shape functions of every order. */
  template <class Check>
  void for_each_order(const Check &check)
  {
    for (unsigned int order = 1; order <= 6; ++order)
      {
        SCOPED_TRACE("order " + std::to_string(order));
        dispatch_order(order, [&](auto p) { check(BeamShape<p>()); });
      }
  }
} // namespace

TEST(BeamShape, EndsComeFirstThenInnerNodesFromLeftToRight)
{
  for_each_order([](const auto &shape) {
    EXPECT_EQ(shape.node[0], -1.);
    EXPECT_EQ(shape.node[1], 1.);
    for (int a = 2; a < shape.n_nodes; ++a)
      {
        EXPECT_GT(shape.node[a], a == 2 ? -1. : shape.node[a - 1]);
        EXPECT_LT(shape.node[a], 1.);
      }
  });
}

TEST(BeamShape, InnerNodesAreThoseOfGaussLobatto)
{
  // Zeros of the derivative of the Legendre polynomial of degree p.
  EXPECT_NEAR(BeamShape<2>().node[2], 0., shape_round_off);
  EXPECT_NEAR(BeamShape<3>().node[2], -std::sqrt(1. / 5.), shape_round_off);
  EXPECT_NEAR(BeamShape<4>().node[2], -std::sqrt(3. / 7.), shape_round_off);
  EXPECT_NEAR(BeamShape<5>().node[2],
              -std::sqrt(1. / 3. + 2. * std::sqrt(7.) / 21.),
              shape_round_off);
  EXPECT_NEAR(BeamShape<6>().node[2],
              -std::sqrt(5. / 11. + 2. / 11. * std::sqrt(5. / 3.)),
              shape_round_off);
}

TEST(BeamShape, FunctionsAreOneAtTheirOwnNodeAndZeroAtTheOthers)
{
  for_each_order([](const auto &shape) {
    for (int b = 0; b < shape.n_nodes; ++b)
      {
        double values[7];
        shape.values_at(shape.node[b], values);
        for (int a = 0; a < shape.n_nodes; ++a)
          EXPECT_EQ(values[a], a == b ? 1. : 0.);
      }
  });
}

TEST(BeamShape, FunctionsSumToOneAndDerivativesToZero)
{
  for_each_order([](const auto &shape) {
    for (int g = 0; g < shape.n_gauss_points; ++g)
      {
        double sum = 0, slope = 0;
        for (int a = 0; a < shape.n_nodes; ++a)
          {
            sum += shape.value[g][a];
            slope += shape.derivative[g][a];
          }
        EXPECT_NEAR(sum, 1., shape_round_off);
        // Derivatives are up to p (p + 1) / 4 = 10.5.
        EXPECT_NEAR(slope, 0., 10 * shape_round_off);
      }
  });
}

TEST(BeamShape, TablesAtGaussPointsAgreeWithValuesAtAnyPoint)
{
  for_each_order([](const auto &shape) {
    const double step = 1e-4;
    for (int g = 0; g < shape.n_gauss_points; ++g)
      {
        double at[7], right[7], left[7];
        shape.values_at(shape.point[g], at);
        shape.values_at(shape.point[g] + step, right);
        shape.values_at(shape.point[g] - step, left);
        for (int a = 0; a < shape.n_nodes; ++a)
          {
            EXPECT_NEAR(shape.value[g][a], at[a], shape_round_off);
            // Error of the difference: step^2 / 6 times third derivatives of
            // some 500 at order 6.
            EXPECT_NEAR(shape.derivative[g][a],
                        (right[a] - left[a]) / (2 * step),
                        2e-6);
          }
      }
  });
}

TEST(BeamShape, GaussPointsIntegrateTheInternalForcesExactly)
{
  // p points integrate polynomials up to degree 2 p - 1 over [-1, 1].
  for_each_order([](const auto &shape) {
    for (int degree = 0; degree < 2 * shape.n_gauss_points; ++degree)
      {
        double sum = 0;
        for (int g = 0; g < shape.n_gauss_points; ++g)
          sum += shape.weight[g] * std::pow(shape.point[g], degree);
        EXPECT_NEAR(sum,
                    degree % 2 == 0 ? 2. / (degree + 1) : 0.,
                    shape_round_off);
      }
  });
}

TEST(BeamShape, IsTheSameForCurvaturesWithShear)
{
  for_each_order([](const auto &shape) {
    for (int g = 0; g < shape.n_gauss_points; ++g)
      {
        for (int a = 0; a < shape.n_nodes; ++a)
          EXPECT_EQ(shape.rotation_derivative[g][a], shape.derivative[g][a]);
        for (int h = 0; h < shape.n_gauss_points; ++h)
          EXPECT_EQ(shape.moment[g][h], g == h ? 1. : 0.);
      }
  });
}

TEST(BeamShape, IsStifferInBendingByTheResidualShearFlexibility)
{
  // With any moment M, its derivative as shear force and EI = 1: larger
  // curvatures reduce the integral of M^2 (doc/theory/struts.md, Sections).
  for_each_order([](const auto &with_shear) {
    using Shape = std::decay_t<decltype(with_shear)>;
    if (Shape::n_gauss_points == 1)
      return;
    const Shape   shape(Shape::max_compensated_shear);
    constexpr int p          = Shape::n_gauss_points;
    double        moments[p] = {}, energy = 0, on_derivatives = 0;
    for (int g = 0; g < p; ++g)
      {
        double constant = 0, curvature[p] = {}, derivative = 0;
        for (int h = 0; h < p; ++h)
          for (int a = 0; a < shape.n_nodes; ++a)
            curvature[h] +=
              shape.rotation_derivative[h][a] * std::cos(1. + 2 * a * a);
        for (int a = 0; a < shape.n_nodes; ++a)
          {
            constant += shape.rotation_derivative[g][a];
            derivative += shape.derivative[g][a] * std::cos(1. + 2 * a * a);
          }
        EXPECT_NEAR(constant, 0, 1e-13);
        for (int h = 0; h < p; ++h)
          moments[g] += shape.moment[g][h] * curvature[h];
        energy += shape.weight[g] * std::pow(curvature[g], 2);
        on_derivatives += shape.weight[g] * moments[g] * derivative;
      }
    EXPECT_NEAR(on_derivatives, energy, 1e-12 * energy);

    double                  square = 0, shear_square = 0;
    const dealii::QGauss<1> rule(p);
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        const double xi = 2 * rule.point(q)[0] - 1, step = 1e-5;
        double       at[p], before[p], after[p], moment = 0, slope = 0;
        shape.gauss_interpolation_at(xi, at);
        shape.gauss_interpolation_at(xi - step, before);
        shape.gauss_interpolation_at(xi + step, after);
        for (int g = 0; g < p; ++g)
          {
            moment += at[g] * moments[g];
            slope += (after[g] - before[g]) / (2 * step) * moments[g];
          }
        square += 2 * rule.weight(q) * moment * moment;
        shear_square += 2 * rule.weight(q) * slope * slope;
      }
    // The error of the difference is the square of the step times the third
    // derivative.
    EXPECT_NEAR(energy,
                square - Shape::max_compensated_shear / 3 * shear_square,
                1e-8 * square);
  });
}

TEST(BeamShape, MassOfLinearAndQuadraticElementsIsTheClosedForm)
{
  const BeamShape<1> linear;
  EXPECT_NEAR(linear.mass[0][0], 2. / 3, shape_round_off);
  EXPECT_NEAR(linear.mass[0][1], 1. / 3, shape_round_off);

  const BeamShape<2> quadratic;
  const double       reference[3][3] = {{4, -1, 2}, {-1, 4, 2}, {2, 2, 16}};
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      EXPECT_NEAR(quadratic.mass[a][b], reference[a][b] / 15, shape_round_off);
}

TEST(BeamShape, MassAndIntegralsAreExact)
{
  for_each_order([](const auto &shape) {
    // Two more points than an exact rule needs.
    const dealii::QGauss<1> rule(shape.n_nodes + 2);
    double                  mass[7][7] = {}, integral[7] = {};
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        double values[7];
        shape.values_at(2 * rule.point(q)[0] - 1, values);
        for (int a = 0; a < shape.n_nodes; ++a)
          {
            integral[a] += 2 * rule.weight(q) * values[a];
            for (int b = 0; b < shape.n_nodes; ++b)
              mass[a][b] += 2 * rule.weight(q) * values[a] * values[b];
          }
      }
    for (int a = 0; a < shape.n_nodes; ++a)
      {
        EXPECT_NEAR(shape.integral[a], integral[a], shape_round_off);
        for (int b = 0; b < shape.n_nodes; ++b)
          EXPECT_NEAR(shape.mass[a][b], mass[a][b], shape_round_off);
      }
  });
}

TEST(BeamShape, GaussInterpolationReproducesPolynomialsOfDegreeBelowTheOrder)
{
  for_each_order([](const auto &shape) {
    const auto polynomial = [&shape](const double xi) {
      return std::pow(xi - 0.3, shape.n_gauss_points - 1) + 2;
    };
    for (const double xi : {-1., -0.37, 0.1, 1.})
      {
        double weights[6], sum = 0;
        shape.gauss_interpolation_at(xi, weights);
        for (int g = 0; g < shape.n_gauss_points; ++g)
          sum += weights[g] * polynomial(shape.point[g]);
        // At the ends the weights extrapolate: they are up to about 2, and the
        // polynomial is up to 1.3^5 + 2.
        EXPECT_NEAR(sum, polynomial(xi), 20 * shape_round_off);
      }
  });
}
