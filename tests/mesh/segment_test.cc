#include <auxfem/mesh/segment.h>

#include <gtest/gtest.h>

using namespace auxfem;
using dealii::Point;

TEST(Segment, MeetsAnotherInThePlaneAtFractionsOfBoth)
{
  const Segment one{Point<3>(0, 0, 0), Point<3>(4, 0, 0)};
  const auto at = meeting_point(one, {Point<3>(1, -1, 0), Point<3>(1, 3, 0)});
  ASSERT_TRUE(at);
  EXPECT_DOUBLE_EQ((*at)[0], 0.25);
  EXPECT_DOUBLE_EQ((*at)[1], 0.25);
  // The other way round.
  EXPECT_TRUE(meeting_point({Point<3>(1, -1, 0), Point<3>(1, 3, 0)}, one));

  EXPECT_FALSE(meeting_point(one, {Point<3>(1, 1, 0), Point<3>(1, 3, 0)}));
  EXPECT_FALSE(meeting_point(one, {Point<3>(5, -1, 0), Point<3>(5, 3, 0)}));
  EXPECT_FALSE(meeting_point(one, {Point<3>(0, 1, 0), Point<3>(4, 1, 0)}));
  EXPECT_FALSE(meeting_point(one, one));
}

TEST(Segment, HasADistanceToAnother)
{
  const Segment one{Point<3>(0, 0, 0), Point<3>(4, 0, 0)};
  // Inside of both, at ends, parallel, of a point.
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(1, -1, 2), Point<3>(1, 3, 2)}), 2);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(7, 4, 0), Point<3>(9, 4, 0)}), 5);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(3, 1, 0), Point<3>(9, 1, 0)}), 1);
  EXPECT_DOUBLE_EQ(distance({Point<3>(3, 1, 0), Point<3>(9, 1, 0)}, one), 1);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(2, 0, 3), Point<3>(2, 0, 3)}), 3);
  EXPECT_DOUBLE_EQ(distance({Point<3>(2, 0, 3), Point<3>(2, 0, 3)}, one), 3);
  EXPECT_DOUBLE_EQ(distance(one, {Point<3>(-3, 8, 0), Point<3>(-3, 4, 0)}), 5);
}
