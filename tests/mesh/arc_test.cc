#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_geometry.h>

#include <deal.II/base/tensor.h>
#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace auxfem;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Round-off of a handful of operations on numbers of size one. */
  constexpr double arc_round_off = 1e-14;

  /** Turns by 1.1 rad about an axis along no coordinate. */
  Tensor<2, 3> rotation()
  {
    const Tensor<1, 3> axis = Point<3>(1, 2, -2) / 3.;
    return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      Point<3>(axis),
      1.1);
  }

  Lattice one_arc(const Point<3>     &first,
                  const Point<3>     &second,
                  const double        sagitta,
                  const Tensor<1, 3> &normal)
  {
    Lattice lattice;
    lattice.joints = {first, second};
    lattice.struts.resize(1);
    lattice.struts[0].joints  = {{0, 1}};
    lattice.struts[0].sagitta = sagitta;
    lattice.struts[0].normal  = normal;
    return lattice;
  }

  const Tensor<1, 3> z = Point<3>(0, 0, 1);
} // namespace

TEST(Arc, InThePlaneLeftIsExact)
{
  for (const double angle : {0.1, 0.7, 2., 3., 4.5})
    {
      const double x = std::cos(angle), y = std::sin(angle);
      const auto   left = left_of(Point<3>(x, y, 0), z);
      EXPECT_EQ(left[0], -y / std::hypot(x, y));
      EXPECT_EQ(left[1], x / std::hypot(x, y));
      EXPECT_EQ(left[2], 0.);
    }
}

TEST(Arc, InOtherPlanesItIsThePlanarArcRotated)
{
  const Point<3> first(0.3, -0.2, 0), second(-1.1, 0.7, 0);
  const auto     turn = rotation();
  for (const double sagitta : {-1.5, -0.4, 1e-3, 0.8})
    {
      const auto planar = one_arc(first, second, sagitta, z);
      const auto turned = one_arc(Point<3>(turn * first),
                                  Point<3>(turn * second),
                                  sagitta,
                                  turn * z);
      EXPECT_NEAR(planar.length(planar.struts[0]),
                  turned.length(turned.struts[0]),
                  arc_round_off);
      for (const double s : {0., 0.25, 0.5, 0.8, 1.})
        {
          Point<3>     position, turned_position;
          Tensor<1, 3> tangent, turned_tangent;
          planar.axis(planar.struts[0], s, position, tangent);
          turned.axis(turned.struts[0], s, turned_position, turned_tangent);
          EXPECT_NEAR((turn * position - turned_position).norm(),
                      0,
                      arc_round_off);
          EXPECT_NEAR((turn * tangent - turned_tangent).norm(),
                      0,
                      arc_round_off);
        }
    }
}

TEST(Arc, AlongZItRisesToTheLeftSeenAgainstItsNormal)
{
  // Going up, seen from the end of the y axis: y x z = x is on the left.
  const auto   lattice = one_arc({0, 0, -1}, {0, 0, 1}, 1, Point<3>(0, 1, 0));
  Point<3>     position;
  Tensor<1, 3> tangent;
  lattice.axis(lattice.struts[0], 0.5, position, tangent);
  EXPECT_NEAR(position.distance({1, 0, 0}), 0, arc_round_off);
  EXPECT_NEAR((tangent - z).norm(), 0, arc_round_off);
}

TEST(Arc, ThePartOfTheNormalAlongTheChordDoesNotCount)
{
  const Point<3>     chord(0.6, 0, 0.8);
  const Tensor<1, 3> perpendicular = Point<3>(-0.8, 0, 0.6);
  const auto         rise          = rise_of_arc(chord, 0.3, perpendicular);
  EXPECT_NEAR((rise_of_arc(chord, 0.3, z) - rise).norm(), 0, arc_round_off);
  EXPECT_NEAR((rise - 0.3 * Point<3>(0, 1, 0)).norm(), 0, arc_round_off);
}

TEST(Arc, TheRiseIsTheSameFromBothEnds)
{
  const Tensor<1, 3> chord  = Point<3>(0.3, -0.7, 0.4);
  const Tensor<1, 3> normal = Point<3>(0, 0.6, 0.8);
  EXPECT_EQ(rise_of_arc(chord, 0.2, normal), rise_of_arc(-chord, -0.2, normal));
  EXPECT_EQ(rise_of_arc(chord, 0.2, normal), rise_of_arc(-chord, 0.2, -normal));
  EXPECT_EQ(rise_of_arc(chord, 0., normal), (Tensor<1, 3>()));
}

TEST(Arc, ThroughAPointInAnyPlane)
{
  // A quarter of the unit circle, and a point of it off the middle.
  const Point<3> start(1, 0, 0), end(0, 1, 0), on(0.8, 0.6, 0);
  const double   sagitta = 1 - std::sqrt(0.5);
  const auto     turn    = rotation();
  const auto     planar  = arc_through(end - start, on - start);
  ASSERT_TRUE(planar);
  // To the right of the way there and to the left of the way back.
  EXPECT_NEAR(planar->sagitta, -sagitta, arc_round_off);
  EXPECT_EQ(planar->normal, z);
  EXPECT_NEAR(arc_through(start - end, on - end)->sagitta,
              sagitta,
              arc_round_off);

  const auto turned = arc_through(turn * (end - start), turn * (on - start));
  ASSERT_TRUE(turned);
  const auto rise = rise_of_arc(end - start, planar->sagitta, z);
  EXPECT_NEAR(
    (rise_of_arc(turn * (end - start), turned->sagitta, turned->normal) -
     turn * rise)
      .norm(),
    0,
    arc_round_off);
  EXPECT_NEAR(turned->normal.norm(), 1, arc_round_off);
}

TEST(Arc, ThroughPointsOfTheChordsLine)
{
  const Tensor<1, 3> chord = Point<3>(0, 0, 2);
  ASSERT_TRUE(arc_through(chord, 0.3 * chord));
  EXPECT_EQ(arc_through(chord, 0.3 * chord)->sagitta, 0);
  EXPECT_EQ(arc_through(chord, 0.3 * chord)->normal, z);
  EXPECT_FALSE(arc_through(chord, 1.5 * chord));
  EXPECT_FALSE(arc_through(chord, -0.5 * chord));
  EXPECT_FALSE(arc_through(chord, chord));
}
