#include <auxfem/mesh/lattice.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Round-off of a handful of operations on numbers of size one. */
  constexpr double lattice_round_off = 1e-14;

  Lattice strut_between(const dealii::Point<3> &first,
                        const dealii::Point<3> &second,
                        const double            sagitta)
  {
    Lattice lattice;
    lattice.joints = {first, second};
    Strut strut;
    strut.joints  = {{0, 1}};
    strut.sagitta = sagitta;
    lattice.struts.push_back(strut);
    return lattice;
  }

  dealii::Point<3> position(const Lattice &lattice, const double s)
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> tangent;
    lattice.axis(lattice.struts[0], s, position, tangent);
    return position;
  }

  dealii::Tensor<1, 3> tangent(const Lattice &lattice, const double s)
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> direction;
    lattice.axis(lattice.struts[0], s, position, direction);
    return direction;
  }
} // namespace

TEST(Lattice, StraightStrut)
{
  const auto lattice = strut_between({1, 2, 3}, {4, 6, 3}, 0);
  EXPECT_NEAR(lattice.length(lattice.struts[0]), 5, lattice_round_off);
  EXPECT_NEAR(position(lattice, 0.25).distance({1.75, 3, 3}),
              0,
              lattice_round_off);
  EXPECT_NEAR(tangent(lattice, 0.7)[0], 0.6, lattice_round_off);
  EXPECT_NEAR(tangent(lattice, 0.7)[1], 0.8, lattice_round_off);
}

TEST(Lattice, HalfCircleBulgesToTheLeft)
{
  // Going along +x, left is +y.
  const auto lattice = strut_between({-1, 0, 0}, {1, 0, 0}, 1);
  EXPECT_NEAR(lattice.length(lattice.struts[0]), pi, lattice_round_off);
  EXPECT_NEAR(position(lattice, 0.5).distance({0, 1, 0}), 0, lattice_round_off);
  EXPECT_NEAR(tangent(lattice, 0)[1], 1, lattice_round_off);
  EXPECT_NEAR(tangent(lattice, 0.5)[0], 1, lattice_round_off);
  EXPECT_NEAR(tangent(lattice, 1)[1], -1, lattice_round_off);
}

TEST(Lattice, NegativeSagittaBulgesToTheRight)
{
  const auto lattice = strut_between({-1, 0, 0}, {1, 0, 0}, -0.5);
  EXPECT_NEAR(position(lattice, 0.5).distance({0, -0.5, 0}),
              0,
              lattice_round_off);
}

TEST(Lattice, ThreeQuarterCircleExceedsHalfTheChord)
{
  // Unit circle about the origin from 225 deg clockwise to 315 deg (through
  // the top): the chord is sqrt(2), the middle (0, 1) is 1 + sqrt(1/2) above.
  const double h       = std::sqrt(0.5);
  const auto   lattice = strut_between({-h, -h, 0}, {h, -h, 0}, 1 + h);
  EXPECT_NEAR(lattice.length(lattice.struts[0]),
              1.5 * pi,
              4 * lattice_round_off);
  for (const double s : {0., 0.2, 0.5, 0.9, 1.})
    {
      const double angle = (225 - 270 * s) * pi / 180;
      EXPECT_NEAR(
        position(lattice, s).distance({std::cos(angle), std::sin(angle), 0}),
        0,
        lattice_round_off);
      EXPECT_NEAR(tangent(lattice, s)[0], std::sin(angle), lattice_round_off);
      EXPECT_NEAR(tangent(lattice, s)[1], -std::cos(angle), lattice_round_off);
    }
}

TEST(Lattice, ArcEndsAtItsJoints)
{
  const dealii::Point<3> first(0.3, -0.2, 0), second(-1.1, 0.7, 0);
  for (const double sagitta : {-3., -0.4, 1e-3, 0.8, 2.})
    {
      const auto lattice = strut_between(first, second, sagitta);
      EXPECT_NEAR(position(lattice, 0).distance(first), 0, lattice_round_off);
      EXPECT_NEAR(position(lattice, 1).distance(second), 0, lattice_round_off);
    }
}

TEST(Lattice, FlatArcKeepsItsDigits)
{
  // length = chord (1 + 8/3 (sagitta/chord)^2 + O(4)); the second term
  // is 2.7e-12, the next one 1e-24.
  const auto lattice = strut_between({0, 0, 0}, {1, 0, 0}, 1e-6);
  EXPECT_NEAR(lattice.length(lattice.struts[0]) - 1, 8. / 3. * 1e-12, 1e-15);
  EXPECT_NEAR(position(lattice, 0.5)[1], 1e-6, 1e-20);
}
