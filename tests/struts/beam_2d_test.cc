#include <gtest/gtest.h>

#include "beam_on_trial.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Forces are sums of some 50 products of numbers of about 1 to 30
  // (stiffness 3, derivatives up to 10.5), each rounded once.
  constexpr double beam_2d_round_off = 1e-12;

  template <bool large_rotation, bool damped, class Beam>
  void check_tangent(const Beam &beam)
  {
    using Vector   = typename Beam::Vector;
    const auto   u = beam.moved(irregular<Vector>(0.3, 1), 2.2, {{1, -2}});
    const auto   v = irregular<Vector>(2., 2);
    const double stiffness = 0.9, damping = 2.5;
    const auto   matrix =
      beam.template tangent<large_rotation, damped>(u, v, stiffness, damping);
    const double step = 1e-5, scale = largest(matrix);

    double worst = 0;
    for (int j = 0; j < Beam::n; ++j)
      {
        Vector u_right = u, u_left = u, v_right = v, v_left = v, right, left;
        u_right[j] += stiffness * step;
        u_left[j] -= stiffness * step;
        v_right[j] += damping * step;
        v_left[j] -= damping * step;
        beam.template force<large_rotation, damped>(u_right, v_right, right);
        beam.template force<large_rotation, damped>(u_left, v_left, left);
        for (int i = 0; i < Beam::n; ++i)
          worst = std::max(worst,
                           std::abs(matrix[i * Beam::n + j] -
                                    (right[i] - left[i]) / (2 * step)));
      }
    // The difference has errors of step^2 (1e-10) and 1e-16 / step (1e-11),
    // times numbers up to 100.
    EXPECT_LT(worst, 1e-8 * scale);
  }
} // namespace

TEST(Beam2D, TangentIsTheDerivativeOfTheForce)
{
  for_each_beam([](const auto &beam) {
    check_tangent<true, false>(beam);
    check_tangent<true, true>(beam);
    check_tangent<false, false>(beam);
    check_tangent<false, true>(beam);
  });
}

TEST(Beam2D, UndampedTangentIsSymmetric)
{
  for_each_beam([](const auto &beam) {
    using Beam        = std::decay_t<decltype(beam)>;
    using Vector      = typename Beam::Vector;
    const auto u      = beam.moved(irregular<Vector>(0.3, 3), 2.2, {{1, -2}});
    const auto matrix = beam.template tangent<true, false>(u, u, 1, 0);
    for (int i = 0; i < Beam::n; ++i)
      for (int j = 0; j < i; ++j)
        EXPECT_NEAR(matrix[i * Beam::n + j],
                    matrix[j * Beam::n + i],
                    beam_2d_round_off * largest(matrix));
  });
}

TEST(Beam2D, ForceIsTheDerivativeOfTheStrainEnergy)
{
  for_each_beam([](const auto &beam) {
    using Beam   = std::decay_t<decltype(beam)>;
    using Vector = typename Beam::Vector;
    const auto u = beam.moved(irregular<Vector>(0.3, 4), -1.9, {{0, 3}});
    Vector     force, unused;
    beam.template force<true, false>(u, u, force);
    const double step = 1e-5;
    for (int i = 0; i < Beam::n; ++i)
      {
        Vector right = u, left = u;
        right[i] += step;
        left[i] -= step;
        const double slope =
          (beam.template force<true, false>(right, u, unused).strain -
           beam.template force<true, false>(left, u, unused).strain) /
          (2 * step);
        // Errors of step^2 and 1e-16 / step times numbers up to 100.
        EXPECT_NEAR(force[i], slope, 1e-8 * largest(force));
      }
  });
}

TEST(Beam2D, DampingDissipatesThePowerOfItsForce)
{
  for_each_beam([](const auto &beam) {
    using Beam   = std::decay_t<decltype(beam)>;
    using Vector = typename Beam::Vector;
    for (unsigned int seed = 10; seed < 15; ++seed)
      {
        const auto u = beam.moved(irregular<Vector>(0.3, seed), 1.3, {{0, 0}});
        const auto v = irregular<Vector>(2., 100 + seed);
        Vector     damped, elastic;
        const auto energy = beam.template force<true, true>(u, v, damped);
        beam.template force<true, false>(u, v, elastic);
        double power = 0, size = 0;
        for (int i = 0; i < Beam::n; ++i)
          {
            power += (damped[i] - elastic[i]) * v[i];
            size += std::abs(damped[i] * v[i]);
          }
        EXPECT_GT(energy.dissipation, 0);
        EXPECT_NEAR(energy.dissipation, power, beam_2d_round_off * size);
      }
  });
}

TEST(Beam2D, RigidMotionGivesNoForceEvenAfterSeveralTurns)
{
  for_each_beam([](const auto &beam) {
    using Beam   = std::decay_t<decltype(beam)>;
    using Vector = typename Beam::Vector;
    for (const double angle : {1e-9, 0.3, 3.1, -12.4, 44.})
      {
        Vector rate, force;
        rate.fill(0);
        const auto   u     = beam.moved(rate, angle, {{0.7, -1.1}});
        const double omega = 5;
        for (int a = 0; a <= Beam::order; ++a)
          {
            rate[3 * a]     = 2 - omega * (beam.nodes[a][1] + u[3 * a + 1]);
            rate[3 * a + 1] = 1 + omega * (beam.nodes[a][0] + u[3 * a]);
            rate[3 * a + 2] = omega;
          }
        const auto energy = beam.template force<true, true>(u, rate, force);
        EXPECT_LT(largest(force), 10 * beam_2d_round_off) << "angle " << angle;
        EXPECT_LT(energy.strain, beam_2d_round_off * beam_2d_round_off);
        EXPECT_LT(energy.dissipation,
                  100 * beam_2d_round_off * beam_2d_round_off);
      }
  });
}

TEST(Beam2D, ForcesFollowASuperposedRotation)
{
  for_each_beam([](const auto &beam) {
    using Beam         = std::decay_t<decltype(beam)>;
    using Vector       = typename Beam::Vector;
    const auto   u     = irregular<Vector>(0.4, 5);
    const double angle = 9.1, c = std::cos(angle), s = std::sin(angle);
    Vector       force, turned;
    const auto   energy = beam.template force<true, false>(u, u, force);
    const auto   same =
      beam.template force<true, false>(beam.moved(u, angle, {{2, 1}}),
                                       u,
                                       turned);
    EXPECT_NEAR(energy.strain, same.strain, beam_2d_round_off * energy.strain);
    const double tolerance = beam_2d_round_off * largest(force);
    for (int a = 0; a <= Beam::order; ++a)
      {
        const double fx = force[3 * a], fy = force[3 * a + 1];
        EXPECT_NEAR(turned[3 * a], c * fx - s * fy, tolerance);
        EXPECT_NEAR(turned[3 * a + 1], s * fx + c * fy, tolerance);
        EXPECT_NEAR(turned[3 * a + 2], force[3 * a + 2], tolerance);
      }
  });
}

TEST(Beam2D, ForcesAreInEquilibriumInAnyState)
{
  for_each_beam([](const auto &beam) {
    using Beam   = std::decay_t<decltype(beam)>;
    using Vector = typename Beam::Vector;
    const auto u = irregular<Vector>(0.5, 6), v = irregular<Vector>(0.5, 7);
    Vector     force;
    beam.template force<true, true>(u, v, force);
    double sum[3] = {0, 0, 0};
    for (int a = 0; a <= Beam::order; ++a)
      {
        sum[0] += force[3 * a];
        sum[1] += force[3 * a + 1];
        sum[2] += force[3 * a + 2] +
          (beam.nodes[a][0] + u[3 * a]) * force[3 * a + 1] -
          (beam.nodes[a][1] + u[3 * a + 1]) * force[3 * a];
      }
    EXPECT_LT(largest(std::array<double, 3>{{sum[0], sum[1], sum[2]}}),
              beam_2d_round_off * largest(force));
  });
}

TEST(Beam2D, SmallDisplacementFormIsTheDerivativeAtRest)
{
  for_each_beam([](const auto &beam) {
    using Beam   = std::decay_t<decltype(beam)>;
    using Vector = typename Beam::Vector;
    const auto u = irregular<Vector>(1., 8), v = irregular<Vector>(1., 9);
    Vector     rest;
    rest.fill(0);
    const auto exact  = beam.template tangent<true, true>(rest, rest, 1., 2.);
    const auto linear = beam.template tangent<false, true>(u, v, 1., 2.);
    for (unsigned int i = 0; i < exact.size(); ++i)
      EXPECT_NEAR(exact[i], linear[i], beam_2d_round_off * largest(linear));

    const auto stiffness = beam.template tangent<false, true>(u, v, 1., 0.);
    const auto damping   = beam.template tangent<false, true>(u, v, 0., 1.);
    Vector     force;
    beam.template force<false, true>(u, v, force);
    for (int i = 0; i < Beam::n; ++i)
      {
        double sum = 0;
        for (int j = 0; j < Beam::n; ++j)
          sum +=
            stiffness[i * Beam::n + j] * u[j] + damping[i * Beam::n + j] * v[j];
        EXPECT_NEAR(force[i], sum, beam_2d_round_off * largest(force));
      }
  });
}

namespace
{
  /** End forces of a straight element along x of length 1.6 under a given
   * motion (s -> u_x, u_y, phi), evaluated with the exact form. */
  template <class Beam, class Motion>
  typename Beam::Vector forces_under(const Beam &beam, const Motion &motion)
  {
    typename Beam::Vector u, force;
    for (int a = 0; a <= Beam::order; ++a)
      {
        const std::array<double, 3> at_node = motion(beam.nodes[a][0]);
        std::copy(at_node.begin(), at_node.end(), u.begin() + 3 * a);
      }
    beam.template force<true, false>(u, u, force);
    return force;
  }

  template <class Check>
  void for_each_straight_beam(const Check &check)
  {
    for (unsigned int order = 1; order <= 6; ++order)
      {
        SCOPED_TRACE("order " + std::to_string(order));
        dispatch_order(order,
                       [&](auto p) { check(BeamOnTrial<p>(1.6, 0, 0)); });
      }
  }
} // namespace

TEST(Beam2D, UniformStretchGivesTheNormalForceAtTheEndsOnly)
{
  for_each_straight_beam([](const auto &beam) {
    const auto force = forces_under(beam, [](const double s) {
      return std::array<double, 3>{{0.2 * s, 0, 0}};
    });
    for (unsigned int i = 0; i < force.size(); ++i)
      EXPECT_NEAR(force[i],
                  i == 0     ? -beam.section.axial * 0.2
                    : i == 3 ? beam.section.axial * 0.2
                             : 0.,
                  beam_2d_round_off);
  });
}

TEST(Beam2D, UniformShearGivesTheShearForceAndItsMoment)
{
  for_each_straight_beam([](const auto &beam) {
    const double shear = beam.section.shear * 0.2;
    const auto   force = forces_under(beam, [](const double s) {
      return std::array<double, 3>{{0, 0.2 * s, 0}};
    });
    for (int a = 0; a <= beam.order; ++a)
      {
        EXPECT_NEAR(force[3 * a], 0., beam_2d_round_off);
        EXPECT_NEAR(force[3 * a + 1],
                    a == 0     ? -shear
                      : a == 1 ? shear
                               : 0.,
                    beam_2d_round_off);
        // Virtual work -Q dphi along the axis. The Gauss rule integrates the
        // shape functions exactly (degree p <= 2 p - 1).
        EXPECT_NEAR(force[3 * a + 2],
                    -shear * beam.jacobian * beam.shape.integral[a],
                    beam_2d_round_off);
      }
  });
}

TEST(Beam2D, UniformCurvatureWithoutShearGivesEndMomentsOnly)
{
  // The square of this small curvature, an axial strain, is below round-off.
  const double curvature = 1e-7;
  for (unsigned int order = 2; order <= 6; ++order)
    dispatch_order(order, [curvature](auto p) {
      const BeamOnTrial<p> beam(1.6, 0, 0);
      const double         moment = beam.section.bending * curvature;
      const auto force = forces_under(beam, [curvature](const double s) {
        return std::array<double, 3>{{0, curvature * s * s / 2, curvature * s}};
      });
      for (unsigned int i = 0; i < force.size(); ++i)
        EXPECT_NEAR(force[i], i == 2 ? -moment : i == 5 ? moment : 0., 1e-12);
    });
}

TEST(Beam2D, LinearElementBendsWithoutShearLocking)
{
  // Equal and opposite end rotations with one Gauss point: zero shear strain in
  // the middle, so the moment is EI 2 phi / L.
  const BeamOnTrial<1>         beam(1.6, 0, 0);
  const double                 angle = 1e-7;
  BeamOnTrial<1>::Vector       force;
  const BeamOnTrial<1>::Vector u = {{0, 0, -angle, 0, 0, angle}};
  beam.force<true, false>(u, u, force);
  EXPECT_NEAR(force[5], beam.section.bending * 2 * angle / 1.6, 1e-20);
  EXPECT_NEAR(force[1], 0., 1e-20);
}
