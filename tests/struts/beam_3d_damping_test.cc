#include <auxfem/struts/beam_3d_damping.h>

#include <gtest/gtest.h>
#include <mathematics/sample_rotation.h>

#include "beam_3d_on_trial.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double damping_time = 0.4;

  // Forces are sums of some 100 products of numbers of about 1 to 10, each
  // rounded once.
  constexpr double damping_round_off = 1e-12;

  /** A test beam with nodal velocities. */
  template <class Beam>
  struct Moving
  {
    using Velocities = std::array<Beam3D::NodeVelocity, Beam::order + 1>;

    const Beam          &beam;
    typename Beam::Nodes nodes;
    Velocities           velocities;

    Moving(const Beam &beam, const unsigned int seed)
      : beam(beam)
      , nodes(beam.moved(Beam::nodes_of(
                           irregular<typename Beam::Vector>(0.4, seed)),
                         some_rotation,
                         SpaceVector({1, -2, 0.7})))
    {
      const auto v = irregular<typename Beam::Vector>(2., seed + 100);
      for (int i = 0; i < Beam::n; ++i)
        component(velocities, i) = v[i];
    }

    static double &component(Velocities &velocities, const int i)
    {
      Beam3D::NodeVelocity &node = velocities[i / Beam3D::n_components];
      const int             part = i % Beam3D::n_components;
      return part < 3 ? node.linear[part] : node.angular[part - 3];
    }

    double force(typename Beam::Vector &result) const
    {
      result.fill(0);
      return Beam3D::add_damping_force(beam.shape,
                                       beam.kinematics(nodes),
                                       beam.jacobian,
                                       beam.section,
                                       damping_time,
                                       velocities.data(),
                                       result.data());
    }
  };
} // namespace

TEST(DampingOfBeam3D, TangentIsTheDerivativeOfTheForce)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    const Moving<Beam>    moving(beam, 1);
    const double          stiffness = 0.9, damping = 2.5, step = 1e-5;
    typename Beam::Matrix matrix;
    matrix.fill(0);
    SpaceTensor scaled_identity;
    for (int i = 0; i < 3; ++i)
      scaled_identity[i][i] = damping;
    const std::vector<SpaceTensor> by_spin(Beam::n / 6, scaled_identity);
    Beam3D::add_damping_tangent(beam.shape,
                                beam.kinematics(moving.nodes),
                                beam.jacobian,
                                beam.section,
                                damping_time,
                                moving.velocities.data(),
                                stiffness,
                                damping,
                                by_spin.data(),
                                matrix.data());
    double worst = 0;
    for (int j = 0; j < Beam::n; ++j)
      {
        typename Beam::Vector right, left;
        const auto            varied = [&](const double sign) {
          Moving<Beam> copy = moving;
          copy.nodes = Beam::varied(copy.nodes, j, sign * stiffness * step);
          copy.component(copy.velocities, j) += sign * damping * step;
          return copy;
        };
        varied(1).force(right);
        varied(-1).force(left);
        for (int i = 0; i < Beam::n; ++i)
          worst = std::max(worst,
                           std::abs(matrix[i * Beam::n + j] -
                                    (right[i] - left[i]) / (2 * step)));
      }
    // The difference has errors of step^2 (1e-10) and 1e-16 / step (1e-11),
    // times numbers up to 100.
    EXPECT_LT(worst, 1e-8 * largest(matrix));
  });
}

TEST(DampingOfBeam3D, UniformRatesOfStretchAndTwistGiveForcesAtTheEndsOnly)
{
  for_each_straight_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    Moving<Beam> moving(beam, 2);
    moving.nodes = {};
    for (int a = 0; a <= Beam::order; ++a)
      moving.velocities[a] = {0.3 * beam.positions[a], 0.7 * beam.positions[a]};
    typename Beam::Vector force;
    const double          power = moving.force(force);
    for (int i = 0; i < Beam::n; ++i)
      {
        const double sign = i < 6 ? -1 : i < 12 ? 1 : 0;
        const double part = i % 6 == 0 ? 0.3 * beam.section.axial
          : i % 6 == 3                 ? 0.7 * beam.section.torsion
                                       : 0;
        EXPECT_NEAR(force[i], sign * damping_time * part, damping_round_off);
      }
    EXPECT_NEAR(power,
                1.6 * damping_time *
                  (0.09 * beam.section.axial + 0.49 * beam.section.torsion),
                damping_round_off);
  });
}

TEST(DampingOfBeam3D, DissipatesThePowerOfItsForce)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    for (unsigned int seed = 10; seed < 15; ++seed)
      {
        Moving<Beam>          moving(beam, seed);
        typename Beam::Vector force;
        const double          dissipation = moving.force(force);
        double                power = 0, size = 0;
        for (int i = 0; i < Beam::n; ++i)
          {
            const double share =
              force[i] * moving.component(moving.velocities, i);
            power += share;
            size += std::abs(share);
          }
        EXPECT_GT(dissipation, 0);
        EXPECT_NEAR(dissipation, power, damping_round_off * size);
      }
  });
}

TEST(DampingOfBeam3D, RigidMotionOfADeformedElementIsNotDamped)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    Moving<Beam>      moving(beam, 3);
    const SpaceVector omega({2., -5., 1.}), shift({0.4, 1., -2.});
    for (int a = 0; a <= Beam::order; ++a)
      moving.velocities[a] = {
        shift +
          dealii::cross_product_3d(omega,
                                   beam.positions[a] +
                                     moving.nodes[a].displacement),
        omega};
    typename Beam::Vector force;
    const double          power = moving.force(force);
    EXPECT_LT(largest(force), 10 * damping_round_off);
    EXPECT_LT(power, 100 * damping_round_off * damping_round_off);
  });
}

TEST(DampingOfBeam3D, StrainRatesAreExactIfNodesRotateAlike)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    Moving<Beam> moving(beam, 4);
    for (Beam3D::Node &node : moving.nodes)
      node.rotation = moving.nodes[0].rotation;
    const double step  = 1e-5;
    const auto   after = [&](const double time) {
      auto nodes = moving.nodes;
      for (int a = 0; a <= Beam::order; ++a)
        nodes[a] = {nodes[a].displacement + time * moving.velocities[a].linear,
                    exponential(time * moving.velocities[a].angular) *
                      nodes[a].rotation};
      return nodes;
    };
    const auto kinematics = beam.kinematics(moving.nodes);
    for (int g = 0; g < Beam::order; ++g)
      {
        const auto &point = kinematics.points[g];
        const auto  rates = Beam3D::rates(beam.shape,
                                         g,
                                         1 / beam.jacobian,
                                         point,
                                         moving.velocities.data());
        const auto  right = beam.strains(after(step), g),
                   left   = beam.strains(after(-step), g);
        // step^2 (1e-10) times third derivatives of up to 1000
        EXPECT_LT((rates.gamma * point.axes -
                   (right.gamma - left.gamma) / (2 * step))
                    .norm(),
                  1e-7);
        EXPECT_LT((rates.kappa * point.axes -
                   (right.kappa - left.kappa) / (2 * step))
                    .norm(),
                  1e-7);
      }
  });
}
