#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  Lattice frame(const std::string &joints, const std::string &struts)
  {
    const auto cell =
      cell_from_text("frame",
                     "set Joints = " + joints + "\nset Struts = " + struts);
    return make_array(cell->build(), {{1, 1, 1}});
  }

  std::string refusal(const std::string &joints, const std::string &struts)
  {
    return input_error_of([&]() { frame(joints, struts); });
  }
} // namespace

TEST(FrameCell, Portal)
{
  const auto lattice = frame("0 0; 0 2; 3 2; 3 0", "0 1; 1 2; 2 3");
  ASSERT_EQ(lattice.joints.size(), 4u);
  EXPECT_EQ(lattice.joints[2], dealii::Point<3>(3, 2, 0));
  ASSERT_EQ(lattice.struts.size(), 3u);
  EXPECT_EQ(lattice.length(lattice.struts[1]), 3);
  EXPECT_EQ(lattice.joint_sets.at("bottom"), (std::vector<unsigned int>{0, 3}));
  EXPECT_EQ(lattice.joint_sets.at("left"), (std::vector<unsigned int>{0, 1}));
  EXPECT_EQ(lattice.strut_sets.at("all").size(), 3u);
}

TEST(FrameCell, RingOfTwoHalfCircles)
{
  const auto lattice = frame("-1 0; 1 0", "0 1 1; 1 0 1");
  ASSERT_EQ(lattice.struts.size(), 2u);
  // Round-off of numbers of size one.
  for (const auto &strut : lattice.struts)
    EXPECT_NEAR(lattice.length(strut), dealii::numbers::PI, 1e-14);
}

TEST(FrameCell, RefusesJointsThatDoNotExist)
{
  const auto message = refusal("0 0; 1 0", "0 1; 1 2");
  EXPECT_TRUE(contains(message, "Lattice/Struts: strut 1 (\"1 2\")"))
    << message;
  EXPECT_TRUE(contains(message, "joint 2, which does not exist")) << message;
  EXPECT_TRUE(contains(message, "2 joints, numbered from 0 to 1")) << message;
}

TEST(FrameCell, RefusesStrutsWithoutLength)
{
  EXPECT_TRUE(contains(refusal("0 0; 1 0", "0 0"), "zero length"));
  EXPECT_TRUE(contains(refusal("0 0; 1 0; 1 0", "0 1; 1 2"), "zero length"));
}

TEST(FrameCell, RefusesRepeatedStruts)
{
  EXPECT_TRUE(
    contains(refusal("0 0; 1 0", "0 1; 0 1"), "strut 1 (\"0 1\") repeats"));
  EXPECT_TRUE(
    contains(refusal("0 0; 1 0", "0 1 1; 1 0 -1"), "repeats strut 0"));
}

TEST(FrameCell, RefusesWhatItCannotRead)
{
  EXPECT_TRUE(contains(refusal("0 0; 1 zero", "0 1"), "\"zero\""));
  EXPECT_TRUE(contains(refusal("0 0; 1", "0 1"), "has 1 numbers"));
  EXPECT_TRUE(contains(refusal("0 0; 1 2mm", "0 1"), "without unit word"));
  EXPECT_TRUE(contains(refusal("0 0; 1 0", "0 1.5"), "\"1.5\""));
  EXPECT_TRUE(contains(refusal("0 0; 1 0", "0 -1"), "\"-1\""));
  EXPECT_TRUE(contains(refusal("0 0; 1 0", "0"), "has 1 numbers"));
  EXPECT_TRUE(contains(refusal("0 0", "0 0"), "at least two joints"));
}

TEST(FrameCell, CannotBeRepeated)
{
  const auto cell =
    cell_from_text("frame", "set Joints = 0 0; 1 0\nset Struts = 0 1");
  EXPECT_TRUE(contains(input_error_of([&]() {
                         make_array(cell->build(), {{2, 1, 1}});
                       }),
                       "2 cells along x"));
}
