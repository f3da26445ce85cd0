#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <cmath>

using namespace auxfem;

namespace
{
  Lattice frame(const std::string &joints,
                const std::string &struts,
                const unsigned int dimension = 2)
  {
    const auto cell =
      cell_from_text("frame",
                     "set Joints = " + joints + "\nset Struts = " + struts,
                     ".",
                     dimension);
    return make_array(cell->build(), {{1, 1, 1}});
  }

  std::string frame_refusal(const std::string &joints,
                            const std::string &struts,
                            const unsigned int dimension = 2)
  {
    return input_error_of([&]() { frame(joints, struts, dimension); });
  }

  dealii::Point<3> middle(const Lattice &lattice, const unsigned int strut)
  {
    dealii::Point<3>     position;
    dealii::Tensor<1, 3> tangent;
    lattice.axis(lattice.struts[strut], 0.5, position, tangent);
    return position;
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
  const auto message = frame_refusal("0 0; 1 0", "0 1; 1 2");
  EXPECT_TRUE(contains(message, "Lattice/Struts: strut 1 (\"1 2\")"))
    << message;
  EXPECT_TRUE(contains(message, "joint 2, which does not exist")) << message;
  EXPECT_TRUE(contains(message, "2 joints, numbered from 0 to 1")) << message;
}

TEST(FrameCell, RefusesStrutsWithoutLength)
{
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 0", "0 0"), "zero length"));
  EXPECT_TRUE(
    contains(frame_refusal("0 0; 1 0; 1 0", "0 1; 1 2"), "zero length"));
}

TEST(FrameCell, RefusesRepeatedStruts)
{
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 0", "0 1; 0 1"),
                       "strut 1 (\"0 1\") repeats"));
  EXPECT_TRUE(
    contains(frame_refusal("0 0; 1 0", "0 1 1; 1 0 -1"), "repeats strut 0"));
}

TEST(FrameCell, RefusesMalformedEntries)
{
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 zero", "0 1"), "\"zero\""));
  EXPECT_TRUE(contains(frame_refusal("0 0; 1", "0 1"), "has 1 numbers"));
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 2 kg", "0 1"), "does not fit"));
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 0", "0 1.5"), "\"1.5\""));
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 0", "0 -1"), "\"-1\""));
  EXPECT_TRUE(contains(frame_refusal("0 0; 1 0", "0"), "has 1 numbers"));
  EXPECT_TRUE(contains(frame_refusal("0 0", "0 0"), "at least two joints"));
}

TEST(FrameCell, TakesUnitsAndCommas)
{
  const auto lattice = frame("0, 0; 20 mm 0; 1 in, 0.01", "0, 1; 1 2 1 mm");
  EXPECT_EQ(lattice.joints[1], dealii::Point<3>(0.02, 0, 0));
  EXPECT_EQ(lattice.joints[2], dealii::Point<3>(0.0254, 0.01, 0));
  EXPECT_EQ(lattice.struts[1].sagitta, 1e-3);
}

TEST(FrameCell, InSpace)
{
  // A table; one joint without its third coordinate.
  const auto lattice =
    frame("0 0 1; 0 0; 1 0 0; 1 0 1; 1 2 1", "1 0; 2 3; 0 3; 3 4; 0 4", 3);
  ASSERT_EQ(lattice.joints.size(), 5u);
  EXPECT_EQ(lattice.joints[0], dealii::Point<3>(0, 0, 1));
  EXPECT_EQ(lattice.joints[1], dealii::Point<3>(0, 0, 0));
  EXPECT_EQ(lattice.length(lattice.struts[0]), 1);
  EXPECT_NEAR(lattice.length(lattice.struts[4]), std::sqrt(5.), 1e-15);
  using Indices = std::vector<unsigned int>;
  EXPECT_EQ(lattice.joint_sets.at("back"), (Indices{1, 2}));
  EXPECT_EQ(lattice.joint_sets.at("front"), (Indices{0, 3, 4}));
  EXPECT_EQ(lattice.joint_sets.at("top"), (Indices{4}));
}

TEST(FrameCell, ArcsInSpaceLieInThePlaneOfTheirNormal)
{
  const auto lattice =
    frame("0 0 0; 2 0 0; 0 0 2", "0 1 0.5; 0 1 0.5 0 -3 0; 0 2 1 0 2 0", 3);
  // Round-off of numbers of size one.
  EXPECT_NEAR(middle(lattice, 0).distance({1, 0.5, 0}), 0, 1e-15);
  EXPECT_NEAR(middle(lattice, 1).distance({1, 0, 0.5}), 0, 1e-15);
  EXPECT_NEAR(middle(lattice, 2).distance({1, 0, 1}), 0, 1e-15);
  EXPECT_EQ(lattice.struts[1].normal, dealii::Point<3>(0, -1, 0));
}

TEST(FrameCell, RefusesArcsInSpaceWithoutAPlane)
{
  const std::string joints = "0 0 0; 0 0 1; 1 0 0";
  EXPECT_TRUE(
    contains(frame_refusal(joints, "0 1 0.2", 3), "chord is parallel to z"));
  EXPECT_TRUE(contains(frame_refusal(joints, "0 2 0.2 1 0 0", 3),
                       "parallel to the normal of its plane"));
  EXPECT_TRUE(
    contains(frame_refusal(joints, "0 2 0.2 0 0 0", 3), "normal 0 0 0"));
  EXPECT_TRUE(
    contains(frame_refusal(joints, "0 2 0.2 0 1", 3), "the three numbers"));
  EXPECT_TRUE(
    contains(frame_refusal(joints, "0 2 0.2 0 one 0", 3), "component"));
  // A straight strut needs none.
  EXPECT_EQ(frame_refusal(joints, "0 1", 3), "");
}

TEST(FrameCell, RefusesArcsThatRepeatOthersFromAnotherSide)
{
  const std::string joints = "0 0 0; 0 0 1";
  EXPECT_TRUE(
    contains(frame_refusal(joints, "0 1 0.2 1 3 0; 1 0 -0.2 2 6 0", 3),
             "repeats strut 0"));
  EXPECT_TRUE(
    contains(frame_refusal(joints, "0 1 0.2 1 3 0; 1 0 0.2 -2 -6 1", 3),
             "repeats strut 0"));
  EXPECT_EQ(frame_refusal(joints, "0 1 0.2 1 3 0; 1 0 0.2 2 6 0", 3), "");
}

TEST(FrameCell, InThePlaneTheThirdCoordinateIsZero)
{
  EXPECT_EQ(frame_refusal("0 0 0; 1 0 0", "0 1"), "");
  const auto message = frame_refusal("0 0; 1 0 0.5", "0 1");
  expect_parts(message,
               {"Lattice/Joints: joint 1 (\"1 0 0.5\")",
                "third coordinate 0.5",
                "plane z = 0",
                "Dimension = 3"});
  EXPECT_TRUE(
    contains(frame_refusal("0 0; 1 0", "0 1 1 0 0 1"), "has 6 numbers"));
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
