#include <gtest/gtest.h>
#include <mathematics/sample_rotation.h>

#include <support/pi.h>

#include "beam_3d_on_trial.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // Forces are sums of some 100 products of numbers of about 1 to 10, each
  // rounded once.
  constexpr double beam_3d_round_off = 1e-12;

  const SpaceVector some_shift({1, -2, 0.7});

  /** Strains of about one, neighbouring nodes up to about 70 degrees apart, all
   * in an arbitrary orientation. */
  template <class Beam>
  typename Beam::Nodes irregular_nodes(const Beam        &beam,
                                       const unsigned int seed)
  {
    return beam.moved(Beam::nodes_of(
                        irregular<typename Beam::Vector>(0.4, seed)),
                      some_rotation,
                      some_shift);
  }

  SpaceVector space_vector(const double *numbers)
  {
    return SpaceVector({numbers[0], numbers[1], numbers[2]});
  }
} // namespace

TEST(Beam3D, TangentIsTheDerivativeOfTheForce)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam          = std::decay_t<decltype(beam)>;
    const auto   nodes  = irregular_nodes(beam, 1);
    const double factor = 0.9, step = 1e-5;
    const auto   matrix = beam.tangent(nodes, factor);
    double       worst  = 0;
    for (int j = 0; j < Beam::n; ++j)
      {
        typename Beam::Vector right, left;
        beam.force(Beam::varied(nodes, j, step), right);
        beam.force(Beam::varied(nodes, j, -step), left);
        for (int i = 0; i < Beam::n; ++i)
          worst =
            std::max(worst,
                     std::abs(matrix[i * Beam::n + j] -
                              factor * (right[i] - left[i]) / (2 * step)));
      }
    // The difference has errors of step^2 (1e-10) and 1e-16 / step (1e-11),
    // times numbers up to 100.
    EXPECT_LT(worst, 1e-8 * largest(matrix));
  });
}

TEST(Beam3D, ForceIsTheDerivativeOfTheStrainEnergy)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam                  = std::decay_t<decltype(beam)>;
    const auto            nodes = irregular_nodes(beam, 2);
    typename Beam::Vector force, unused;
    beam.force(nodes, force);
    const double step = 1e-5;
    for (int i = 0; i < Beam::n; ++i)
      {
        const double slope =
          (beam.force(Beam::varied(nodes, i, step), unused) -
           beam.force(Beam::varied(nodes, i, -step), unused)) /
          (2 * step);
        // Errors of step^2 and 1e-16 / step times numbers up to 100.
        EXPECT_NEAR(force[i], slope, 1e-8 * largest(force));
      }
  });
}

TEST(Beam3D, AntisymmetricPartOfTheTangentIsHalfTheMomentsOnTheNodes)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam                   = std::decay_t<decltype(beam)>;
    const auto            nodes  = irregular_nodes(beam, 3);
    const auto            matrix = beam.tangent(nodes);
    typename Beam::Vector force;
    beam.force(nodes, force);
    const int components = Beam3D::n_components;
    for (int i = 0; i < Beam::n; ++i)
      for (int j = 0; j < Beam::n; ++j)
        {
          double    expected = 0;
          const int row = i % components - 3, column = j % components - 3;
          if (i / components == j / components && row >= 0 && column >= 0 &&
              row != column)
            {
              // Expected: -1/2 times the spin tensor of the moment.
              const int    third = 3 - row - column;
              const double sign  = (row + 1) % 3 == column ? 0.5 : -0.5;
              expected =
                sign * force[components * (i / components) + 3 + third];
            }
          EXPECT_NEAR((matrix[i * Beam::n + j] - matrix[j * Beam::n + i]) / 2,
                      expected,
                      beam_3d_round_off * largest(matrix));
        }
  });
}

TEST(Beam3D, ElementAtRestIsFreeOfStressHoweverCurvedAndTwisted)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    typename Beam::Vector force;
    EXPECT_EQ(beam.force(typename Beam::Nodes(), force), 0);
    EXPECT_EQ(largest(force), 0);
  });
}

TEST(Beam3D, RigidMotionGivesNoForceEvenAfterSeveralTurns)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    for (const double angle : {1e-9, 0.3, 3.1, -12.4, 44.})
      {
        typename Beam::Vector force;
        const Quaternion      rotation =
          exponential(angle * SpaceVector({2. / 7, -3. / 7, 6. / 7}));
        const double energy =
          beam.force(beam.moved({}, rotation, some_shift), force);
        EXPECT_LT(largest(force), 10 * beam_3d_round_off) << "angle " << angle;
        EXPECT_LT(energy, beam_3d_round_off * beam_3d_round_off);
      }
  });
}

TEST(Beam3D, StrainsAreObjectiveAndForcesFollowASuperposedRotation)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam             = std::decay_t<decltype(beam)>;
    const auto       nodes = irregular_nodes(beam, 4);
    const Quaternion turn  = exponential(SpaceVector({-3.3, 5., 0.4}));
    const auto       same  = beam.moved(nodes, turn, SpaceVector({0.3, 2, -1}));
    typename Beam::Vector force, turned;
    const double          energy = beam.force(nodes, force);
    EXPECT_NEAR(beam.force(same, turned), energy, beam_3d_round_off * energy);
    for (int g = 0; g < Beam::order; ++g)
      {
        EXPECT_LT(distance_between(beam.strains(nodes, g).gamma,
                                   beam.strains(same, g).gamma),
                  beam_3d_round_off);
        EXPECT_LT(distance_between(beam.strains(nodes, g).kappa,
                                   beam.strains(same, g).kappa),
                  beam_3d_round_off);
      }
    for (int i = 0; i < Beam::n; i += 3)
      EXPECT_LT(distance_between(space_vector(turned.data() + i),
                                 rotated(turn, space_vector(force.data() + i))),
                beam_3d_round_off * largest(force));
  });
}

TEST(Beam3D, StrainsDoNotDependOnSignsOfTheQuaternions)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam         = std::decay_t<decltype(beam)>;
    const auto nodes   = irregular_nodes(beam, 5);
    auto       flipped = nodes;
    for (int a = 1; a <= Beam::order; a += 2)
      flipped[a].rotation = -1 * flipped[a].rotation;
    typename Beam::Vector force, same;
    beam.force(nodes, force);
    beam.force(flipped, same);
    for (int i = 0; i < Beam::n; ++i)
      EXPECT_NEAR(force[i], same[i], beam_3d_round_off * largest(force));
  });
}

TEST(Beam3D, ClosedPathsOfRotationsBeyondATurnReturn)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam       = std::decay_t<decltype(beam)>;
    const auto start = irregular_nodes(beam, 6);
    auto       nodes = start;
    // Each node rotates about its own axis by up to three turns, in steps.
    for (int a = 0; a <= Beam::order; ++a)
      {
        const int         n_steps = 40, turns = 1 + a % 3;
        const SpaceVector axis = normalized(start[a].rotation).vector;
        for (int step = 0; step < n_steps; ++step)
          nodes[a].rotation = normalized(
            exponential(2 * pi * turns / n_steps / axis.norm() * axis) *
            nodes[a].rotation);
      }
    typename Beam::Vector force, again;
    beam.force(start, force);
    beam.force(nodes, again);
    for (int i = 0; i < Beam::n; ++i)
      EXPECT_NEAR(force[i], again[i], 10 * beam_3d_round_off * largest(force));
  });
}

TEST(Beam3D, ForcesAreInEquilibriumInAnyState)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam                  = std::decay_t<decltype(beam)>;
    const auto            nodes = irregular_nodes(beam, 7);
    typename Beam::Vector force;
    beam.force(nodes, force);
    SpaceVector sum, moment;
    for (int a = 0; a <= Beam::order; ++a)
      {
        const SpaceVector at_node =
          space_vector(force.data() + Beam3D::n_components * a);
        sum += at_node;
        moment += space_vector(force.data() + Beam3D::n_components * a + 3) +
          dealii::cross_product_3d(beam.positions[a] + nodes[a].displacement,
                                   at_node);
      }
    EXPECT_LT(sum.norm(), beam_3d_round_off * largest(force));
    EXPECT_LT(moment.norm(), beam_3d_round_off * largest(force));
  });
}

TEST(Beam3D, SmallDisplacementFormIsTheDerivativeAtRest)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam   = std::decay_t<decltype(beam)>;
    using Vector = typename Beam::Vector;
    typename Beam::Matrix        tangent;
    const auto                   u = irregular<Vector>(1., 8);
    const Beam3D::ElasticSection section{beam.section};
    Beam3D::small_displacement_tangent(beam.shape,
                                       beam.frames.data(),
                                       beam.jacobian,
                                       section,
                                       u.data(),
                                       1.,
                                       tangent.data());
    Vector       force, tiny, exact;
    const double energy = Beam3D::small_displacement_force(beam.shape,
                                                           beam.frames.data(),
                                                           beam.jacobian,
                                                           section,
                                                           u.data(),
                                                           force.data());
    const double size   = 1e-8;
    for (int i = 0; i < Beam::n; ++i)
      tiny[i] = size * u[i];
    beam.force(Beam::nodes_of(tiny), exact);
    double work = 0;
    for (int i = 0; i < Beam::n; ++i)
      {
        double sum = 0;
        for (int j = 0; j < Beam::n; ++j)
          sum += tangent[i * Beam::n + j] * u[j];
        EXPECT_NEAR(force[i], sum, beam_3d_round_off * largest(force));
        // Error of the neglected squares.
        EXPECT_NEAR(force[i], exact[i] / size, 100 * size * largest(force));
        work += force[i] * u[i] / 2;
      }
    EXPECT_NEAR(energy, work, beam_3d_round_off * work);
  });
}

namespace
{
  /** Motion (s -> displacement, rotation vector) of the nodes of an element. */
  template <class Beam, class Motion>
  typename Beam::Nodes nodes_under(const Beam &beam, const Motion &motion)
  {
    typename Beam::Vector u;
    for (int a = 0; a <= Beam::order; ++a)
      {
        const std::array<double, 6> at_node = motion(beam.positions[a][0]);
        std::copy(at_node.begin(),
                  at_node.end(),
                  u.begin() + Beam3D::n_components * a);
      }
    return Beam::nodes_of(u);
  }

  /**
   * Checks the forces of a straight element under a motion, in a random
   * orientation. It expects @p at_end at s = 1.6, the opposite at 0 and zero
   * elsewhere.
   */
  template <class Beam, class Motion>
  void expect_end_forces(const Beam                  &beam,
                         const Motion                &motion,
                         const std::array<double, 6> &at_end,
                         const double                 tolerance)
  {
    typename Beam::Vector force;
    beam.force(beam.moved(nodes_under(beam, motion), some_rotation, some_shift),
               force);
    for (int i = 0; i < Beam::n; i += 3)
      {
        SpaceVector expected;
        if (i < 12)
          expected = (i < 6 ? -1. : 1.) * space_vector(at_end.data() + i % 6);
        EXPECT_LT(distance_between(rotated(conjugate(some_rotation),
                                           space_vector(force.data() + i)),
                                   expected),
                  tolerance)
          << "node " << i / 6;
      }
  }
} // namespace

TEST(Beam3D, UniformStretchGivesTheNormalForceAtTheEndsOnly)
{
  for_each_straight_beam_3d([](const auto &beam) {
    expect_end_forces(
      beam,
      [](const double s) {
        return std::array<double, 6>{{0.2 * s, 0, 0, 0, 0, 0}};
      },
      {{beam.section.axial * 0.2, 0, 0, 0, 0, 0}},
      beam_3d_round_off);
  });
}

TEST(Beam3D, UniformShearGivesTheShearForceAndItsMoment)
{
  for_each_straight_beam_3d([](const auto &beam) {
    typename std::decay_t<decltype(beam)>::Vector force;
    beam.force(nodes_under(
                 beam,
                 [](const double s) {
                   return std::array<double, 6>{{0, 0.2 * s, 0.3 * s, 0, 0, 0}};
                 }),
               force);
    const SpaceVector shear(
      {0., beam.section.shear_2 * 0.2, beam.section.shear_3 * 0.3});
    // r' x force; the shear force along the slope contributes.
    const SpaceVector lever =
      dealii::cross_product_3d(shear, SpaceVector({1, 0.2, 0.3}));
    for (int a = 0; a <= beam.order; ++a)
      {
        const double *at_node = force.data() + Beam3D::n_components * a;
        EXPECT_LT(distance_between(space_vector(at_node),
                                   (a == 0     ? -1.
                                      : a == 1 ? 1.
                                               : 0.) *
                                     shear),
                  beam_3d_round_off);
        // The Gauss rule integrates the shape functions exactly.
        EXPECT_LT(distance_between(space_vector(at_node + 3),
                                   beam.jacobian * beam.shape.integral[a] *
                                     lever),
                  beam_3d_round_off);
      }
  });
}

namespace
{
  /** Motion with a uniform rate of rotation about axis @p component of the
   * rotation vector; all nodes on the matching curve. */
  std::array<double, 6>
  uniformly_turned(const double rate, const double s, const int component)
  {
    std::array<double, 6> u = {{0, 0, 0, 0, 0, 0}};
    u[3 + component]        = rate * s;
    if (component == 1)
      u[2] = -rate * s * s / 2;
    if (component == 2)
      u[1] = rate * s * s / 2;
    return u;
  }
} // namespace

TEST(Beam3D, UniformTorsionAndBendingGiveEndMomentsOnly)
{
  // Small enough that its square, in the axial strain and the interpolation, is
  // below round-off.
  const double rate = 1e-7;
  for_each_straight_beam_3d([rate](const auto &beam) {
    const double stiffness[] = {beam.section.torsion,
                                beam.section.bending_2,
                                beam.section.bending_3};
    // A straight line does not follow the parabola of bending.
    for (int i = 0; i < (beam.order == 1 ? 1 : 3); ++i)
      {
        std::array<double, 6> at_end = {{0, 0, 0, 0, 0, 0}};
        at_end[3 + i]                = stiffness[i] * rate;
        expect_end_forces(
          beam,
          [i, rate](const double s) { return uniformly_turned(rate, s, i); },
          at_end,
          // Large rotations have an absolute rounding error of one.
          beam_3d_round_off);
      }
  });
}

TEST(Beam3D, LargeTwistOfALinearElement)
{
  const Beam3DOnTrial<1> beam(1.6, {0, 0, 0});
  for (const double twist : {0.1, 1., 3.})
    {
      const double rate  = twist / 1.6;
      const auto   nodes = nodes_under(beam, [twist](const double s) {
        return std::array<double, 6>{{0, 0, 0, twist * s / 1.6, 0, 0}};
      });
      EXPECT_LT(distance_between(beam.strains(nodes, 0).kappa,
                                 SpaceVector({rate, 0, 0})),
                beam_3d_round_off);
      EXPECT_LT(beam.strains(nodes, 0).gamma.norm(), beam_3d_round_off);
    }
}

TEST(Beam3D, LinearElementBendsWithoutShearLocking)
{
  // Equal and opposite end rotations with one Gauss point: zero shear strain in
  // the middle, so the moment is EI 2 phi / L.
  const Beam3DOnTrial<1>   beam(1.6, {0, 0, 0});
  const double             angle = 1e-7;
  Beam3DOnTrial<1>::Vector force;
  beam.force(Beam3DOnTrial<1>::nodes_of(
               {{0, 0, 0, 0, -angle, -angle, 0, 0, 0, 0, angle, angle}}),
             force);
  EXPECT_NEAR(force[10], beam.section.bending_2 * 2 * angle / 1.6, 1e-20);
  EXPECT_NEAR(force[11], beam.section.bending_3 * 2 * angle / 1.6, 1e-20);
  EXPECT_LT(space_vector(force.data() + 6).norm(), 1e-20);
}
