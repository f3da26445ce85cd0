#include <gtest/gtest.h>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  using Indices = std::vector<unsigned int>;

  /** Two bars that end at one place, and one between two joints 1 um apart. */
  Lattice frame_of_bars(const std::string &distance)
  {
    return make_array(
      cell_from_text("frame",
                     "set Joints = 0 0; 0 1; 0 1; 1 1; 1 1.000001; 1 2\n"
                     "set Struts = 0 1; 2 3; 3 4; 4 5; 1 4\n"
                     "set Merge distance = " +
                       distance)
        ->build(),
      {{1, 1, 1}});
  }
} // namespace

TEST(MergeJoints, JointsAtOnePlaceAreNamed)
{
  const Lattice lattice = frame_of_bars("0");
  EXPECT_EQ(lattice.joints.size(), 6u);
  EXPECT_EQ(lattice.struts.size(), 5u);
  ASSERT_EQ(lattice.notes.size(), 1u);
  EXPECT_TRUE(contains(lattice.notes[0], "joint 1 and joint 2 at (0, 1) m"))
    << lattice.notes[0];
  EXPECT_TRUE(contains(lattice.notes[0], "Merge distance"));
  EXPECT_FALSE(contains(lattice.notes[0], "joint 4"));
}

TEST(MergeJoints, NearJointsBecomeOne)
{
  const Lattice                       lattice = frame_of_bars("1 mm");
  const std::vector<dealii::Point<3>> joints  = {{0, 0, 0},
                                                 {0, 1, 0},
                                                 {1, 1, 0},
                                                 {1, 2, 0}};
  EXPECT_EQ(lattice.joints, joints);
  // The strut of 1 um is gone, and the last repeats the second.
  ASSERT_EQ(lattice.struts.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    EXPECT_EQ(lattice.struts[i].joints,
              (std::array<unsigned int, 2>{{i, i + 1}}));
  ASSERT_EQ(lattice.notes.size(), 3u);
  EXPECT_TRUE(contains(lattice.notes[0], "joint 1 and joint 2 at (0, 1) m"));
  EXPECT_TRUE(contains(lattice.notes[0], "joint 3 and joint 4"));
  EXPECT_TRUE(contains(lattice.notes[1], "without length")) << lattice.notes[1];
  EXPECT_TRUE(contains(lattice.notes[1], "strut 2")) << lattice.notes[1];
  EXPECT_TRUE(contains(lattice.notes[2], "repeat")) << lattice.notes[2];
  EXPECT_TRUE(contains(lattice.notes[2], "strut 4")) << lattice.notes[2];
}

TEST(MergeJoints, ArcsBesideStraightStrutsStay)
{
  const auto lattice =
    make_array(cell_from_text("frame",
                              "set Joints = 0 0; 1 0; 0 0; 1 0\n"
                              "set Struts = 0 1; 2 3 0.2; 3 2 0.2; 1 0 -0.2\n"
                              "set Merge distance = 1 mm")
                 ->build(),
               {{1, 1, 1}});
  EXPECT_EQ(lattice.joints.size(), 2u);
  ASSERT_EQ(lattice.struts.size(), 3u);
  EXPECT_EQ(lattice.struts[1].sagitta, 0.2);
  EXPECT_EQ(lattice.struts[2].sagitta, 0.2);
  EXPECT_EQ(lattice.notes.size(), 2u);
}

TEST(MergeJoints, RefusesToRemoveAllStruts)
{
  EXPECT_TRUE(contains(input_error_of([]() { frame_of_bars("5 m"); }),
                       "Lattice/Merge distance: no strut is longer"));
}

TEST(MergeJoints, SoundFramesHaveNoNotes)
{
  const auto lattice = make_array(cell_from_text("frame",
                                                 "set Joints = 0 0; 1 0; 1 1\n"
                                                 "set Struts = 0 1; 1 2\n"
                                                 "set Merge distance = 1 mm")
                                    ->build(),
                                  {{1, 1, 1}});
  EXPECT_EQ(lattice.joints.size(), 3u);
  EXPECT_TRUE(lattice.notes.empty());
}
