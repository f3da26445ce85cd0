#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <algorithm>
#include <string>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  /** A square of 1 m with one diagonal. */
  const std::string square   = "set Joints = 0 0; 1 0; 1 1; 0 1\n"
                               "set Struts = 0 1; 1 2; 2 3; 3 0; 0 2\n",
                    by_sides = "set Vector x = 1 0\nset Vector y = 0 1\n";

  Lattice pattern(const std::string &text,
                  const unsigned int nx,
                  const unsigned int ny,
                  const unsigned int nz        = 1,
                  const unsigned int dimension = 2)
  {
    return make_array(cell_from_text("pattern", text, ".", dimension)->build(),
                      {{nx, ny, nz}});
  }

  std::string refusal(const std::string &text)
  {
    return input_error_of([&] { cell_from_text("pattern", text); });
  }
} // namespace

TEST(PatternCell, UnitesWhatNeighboursShare)
{
  const Lattice lattice = pattern(square + by_sides, 3, 2);
  EXPECT_EQ(lattice.joints.size(), 12u);
  EXPECT_EQ(lattice.struts.size(), 3u * 3 + 2 * 4 + 6);
  EXPECT_EQ(lattice.joint_sets.at("left").size(), 3u);
  EXPECT_EQ(lattice.joint_sets.at("top").size(), 4u);
}

TEST(PatternCell, VectorsMayBeOblique)
{
  // Rows of squares, each shifted by half a side: bricks.
  const Lattice lattice =
    pattern("set Joints = 0 0; 1 0; 0 1; 0.5 1; 1 1; 0.5 0\n"
            "set Struts = 0 5; 5 1; 1 4; 4 3; 3 2; 2 0\n"
            "set Vector x = 1 0\nset Vector y = 0.5 1\n",
            2,
            3);
  // Rows of joints at y = 0 to 3, half a side apart.
  EXPECT_EQ(lattice.joints.size(), 5u + 6 + 6 + 5);
  EXPECT_EQ(lattice.struts.size(), 4u + 5 + 5 + 4 + 3 * 3);
}

TEST(PatternCell, NamesSetsAndPairs)
{
  const Lattice lattice = pattern(square + by_sides +
                                    "set Joint sets = corners: 0 2; heads: 2\n"
                                    "set Strut sets = braces: 4; rims: 0 2\n"
                                    "set Pairs = in: 1 3; link: 1 3 at 1 0; "
                                    "in: 0 2; skew: 0 3 at 1 -1\n",
                                  2,
                                  2);
  EXPECT_EQ(lattice.strut_sets.at("braces").size(), 4u);
  EXPECT_EQ(lattice.strut_sets.at("rims").size(), 6u);
  EXPECT_EQ(lattice.joint_sets.at("heads").size(), 4u);
  EXPECT_EQ(lattice.pair_sets.at("in").size(), 8u);
  EXPECT_EQ(lattice.pair_sets.at("link").size(), 2u);
  EXPECT_EQ(lattice.pair_sets.at("skew").size(), 1u);
  for (const JointPair &pair : lattice.pair_sets.at("link"))
    EXPECT_EQ(lattice.joints[pair.second] - lattice.joints[pair.first],
              (dealii::Tensor<1, 3>({0, 1, 0})));
}

TEST(PatternCell, StrutsMayLeadToNeighbours)
{
  const Lattice lattice =
    pattern("set Joints = 0 0; 0.2 0\n"
            "set Struts = 0 1\n"
            "set Vector x = 1 0\n"
            "set Neighbour struts = bridges: 1 0 at 1 0\n",
            4,
            1);
  EXPECT_EQ(lattice.struts.size(), 4u + 3);
  for (const unsigned int bridge : lattice.strut_sets.at("bridges"))
    EXPECT_NEAR(lattice.length(lattice.struts[bridge]), 0.8, 1e-15);
}

TEST(PatternCell, RepeatsInSpace)
{
  const Lattice lattice = pattern("set Joints = 0 0 0; 1 0 0; 0 1 0; 0 0 1\n"
                                  "set Struts = 0 1; 0 2; 0 3\n"
                                  "set Vector x = 1 0 0\nset Vector y = 0 1 0\n"
                                  "set Vector z = 0 0 1\n",
                                  2,
                                  2,
                                  2,
                                  3);
  EXPECT_EQ(lattice.struts.size(), 24u);
  EXPECT_EQ(lattice.joints.size(), 27u - 7);
}

TEST(PatternCell, MergesRoundedPositions)
{
  const std::string hexagon =
    "set Joints = 0 0; 0.866 -0.5; 1.732 0; 1.732 1; 0.866 1.5; 0 1\n"
    "set Struts = 0 1; 1 2; 2 3; 3 4; 4 5; 5 0\n"
    "set Vector x = 1.73205081 0\nset Vector y = 0.8660254 1.5\n";
  expect_parts(refusal(hexagon), {"cells do not meet", "Merge distance"});
  const Lattice lattice =
    pattern(hexagon + "set Merge distance = 1e-3\n", 2, 2);
  EXPECT_EQ(lattice.joints.size(), 16u);
  EXPECT_EQ(lattice.struts.size(), 19u);
}

TEST(PatternCell, RefusesWhatHasNoMeaning)
{
  expect_parts(refusal(square + "set Vector x = 1.5 0\n"),
               {"Lattice", "cells do not meet", "2 of them are 2 pieces"});
  expect_parts(refusal(square + "set Vector x = 1 0\nset Vector y = 2 0\n"),
               {"Lattice", "parallel"});
  expect_parts(refusal(square + "set Vector x = 0 0\n"),
               {"Lattice/Vector x = 0 0", "zero vector"});
  expect_parts(refusal(square + "set Joint sets = 0 1\n"),
               {"Joint sets", "has no name"});
  expect_parts(refusal(square + "set Joint sets = tips: 4\n"),
               {"Joint sets", "names joint 4", "4 joints"});
  expect_parts(refusal(square + "set Strut sets = rims: 5\n"),
               {"Strut sets", "\"5\"", "from 0 to 4"});
  expect_parts(refusal(square + "set Pairs = a: 0 1 2\n"),
               {"Pairs", "is no pair", "at I J"});
  expect_parts(refusal(square + "set Neighbour struts = a: 0 1\n"),
               {"Neighbour struts", "lies within the cell"});
  // Cells that only connectors join.
  EXPECT_EQ(refusal(square +
                    "set Vector x = 1.5 0\n"
                    "set Pairs = link: 1 0 at 1 0\n"),
            "");
}
