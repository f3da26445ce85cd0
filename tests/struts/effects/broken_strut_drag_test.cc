#include <auxfem/struts/effects/broken_strut_drag.h>

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

using namespace auxfem;

namespace
{
  /** Three nodes of an element whose unknowns are in reverse order. */
  template <unsigned int n_components>
  struct ThreeNodes
  {
    static constexpr unsigned int n = 3 * n_components;

    ThreeNodes()
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          unknowns[i] = n - 1 - i;
          velocity[i] = 0.3 * i * i - i + 2;
        }
    }

    std::array<int, n>    unknowns;
    std::array<double, n> velocity;
  };

  template <unsigned int n_components>
  void expect_consistent_terms()
  {
    const ThreeNodes<n_components> nodes;
    constexpr unsigned int         n = ThreeNodes<n_components>::n;
    const BrokenStrutDrag          drag({-1, 1, -0.2}, n_components);
    const double                   c = 1.5;

    std::vector<double> force(n, 0.), block(n * n, 0.);
    drag.add_force(c,
                   nodes.unknowns.data(),
                   nodes.velocity.data(),
                   force.data());
    drag.add_block(c, block.data());
    double power = 0;
    for (unsigned int i = 0; i < n; ++i)
      {
        double by_block = 0;
        for (unsigned int j = 0; j < n; ++j)
          by_block += block[i * n + j] * nodes.velocity[nodes.unknowns[j]];
        EXPECT_NEAR(force[nodes.unknowns[i]], by_block, 1e-12);
        power += force[i] * nodes.velocity[i];
      }
    EXPECT_GT(power, 0);
    EXPECT_NEAR(c *
                  drag.power(nodes.unknowns.data(),
                             nodes.velocity.data(),
                             nodes.velocity.data()),
                power,
                1e-12 * power);
    EXPECT_NEAR(std::accumulate(force.begin(), force.end(), 0.), 0, 1e-12);
  }
} // namespace

TEST(BrokenStrutDrag, HasTheTangentAndPowerOfItsForces)
{
  expect_consistent_terms<3>();
  expect_consistent_terms<6>();
}

// Where velocities are linear between the ends, inner nodes are not pulled.
TEST(BrokenStrutDrag, LetsAStrutStretchEvenly)
{
  const std::vector<double> at       = {-1, 1, -0.2};
  const std::array<int, 9>  unknowns = {{0, 1, 2, 3, 4, 5, 6, 7, 8}};
  std::vector<double>       velocity(9, 0.), force(9, 0.);
  for (unsigned int a = 0; a < 3; ++a)
    velocity[3 * a] = 7 * at[a];
  BrokenStrutDrag(at, 3).add_force(1,
                                   unknowns.data(),
                                   velocity.data(),
                                   force.data());
  EXPECT_NEAR(force[6], 0, 1e-14);
  EXPECT_NEAR(force[0], -7, 1e-14);
}

// Nodes that move alike feel nothing; rotations never do.
TEST(BrokenStrutDrag, LeavesCommonMotionAndRotationsAlone)
{
  const ThreeNodes<3>   nodes;
  const BrokenStrutDrag drag({-1, 1, -0.2}, 3);
  std::vector<double>   force(9, 0.);
  // Unknowns in reverse order: the rotation of a node comes first.
  const std::vector<double> velocity = {5, 2, 1, -3, 2, 1, 4, 2, 1};
  drag.add_force(1, nodes.unknowns.data(), velocity.data(), force.data());
  for (const double f : force)
    EXPECT_EQ(f, 0);
}
