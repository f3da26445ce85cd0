#include <auxfem/mesh/strut_geometry.h>

#include <gtest/gtest.h>

#include <random>

using namespace auxfem;
using dealii::Point;

TEST(Segment, IntersectsInThePlaneAtFractionsOfBoth)
{
  const Segment one{Point<3>(0, 0, 0), Point<3>(4, 0, 0)};
  const auto    at = intersection(one, {Point<3>(1, -1, 0), Point<3>(1, 3, 0)});
  ASSERT_TRUE(at);
  EXPECT_DOUBLE_EQ((*at)[0], 0.25);
  EXPECT_DOUBLE_EQ((*at)[1], 0.25);
  // The other way round.
  EXPECT_TRUE(intersection({Point<3>(1, -1, 0), Point<3>(1, 3, 0)}, one));

  EXPECT_FALSE(intersection(one, {Point<3>(1, 1, 0), Point<3>(1, 3, 0)}));
  EXPECT_FALSE(intersection(one, {Point<3>(5, -1, 0), Point<3>(5, 3, 0)}));
  EXPECT_FALSE(intersection(one, {Point<3>(0, 1, 0), Point<3>(4, 1, 0)}));
  EXPECT_FALSE(intersection(one, one));
}

TEST(Segment, PartsOfOneLineDoNotIntersect)
{
  // Thirds of lines in all directions, far from the origin too.
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (unsigned int i = 0; i < 20000; ++i)
    {
      const double   away = i % 2 == 0 ? 1 : 100;
      const Point<3> begin(away * any(generator), away * any(generator), 0);
      const dealii::Tensor<1, 3> third =
        Point<3>(any(generator), any(generator), 0) / 3;
      // Round-off of points that are interpolated and displaced.
      const auto at = [&](const unsigned int n) {
        return begin + n * third + 1e-5 * n * third;
      };
      EXPECT_FALSE(intersection({at(0), at(1)}, {at(2), at(3)})) << i;
    }
  // Barely crossing segments intersect.
  EXPECT_TRUE(intersection({Point<3>(0, 0, 0), Point<3>(1, 1e-9, 0)},
                           {Point<3>(0, 1e-9, 0), Point<3>(1, 0, 0)}));
}

TEST(Segment, DistanceOfTwoSegments)
{
  const Segment one{Point<3>(0, 0, 0), Point<3>(4, 0, 0)};
  // Nearest points inside of both, at ends, of parallels, of a point.
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(1, -1, 2), Point<3>(1, 3, 2)}), 2);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(7, 4, 0), Point<3>(9, 4, 0)}), 5);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(3, 1, 0), Point<3>(9, 1, 0)}), 1);
  EXPECT_DOUBLE_EQ(distance({Point<3>(3, 1, 0), Point<3>(9, 1, 0)}, one), 1);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(2, 0, 3), Point<3>(2, 0, 3)}), 3);
  EXPECT_DOUBLE_EQ(distance({Point<3>(2, 0, 3), Point<3>(2, 0, 3)}, one), 3);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(-3, 8, 0), Point<3>(-3, 4, 0)}), 5);
}
