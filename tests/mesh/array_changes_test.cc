#include <auxfem/mesh/array_changes.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  /** An array of n x n squares of 1 m with a pair along one diagonal. */
  Lattice squares(const unsigned int n,
                  const unsigned int dimension = 2,
                  const std::string &region    = "")
  {
    SceneContext context;
    context.path        = "Lattice";
    const UnitCell cell = cell_from_text("pattern",
                                         "set Joints = 0 0; 1 0; 1 1; 0 1\n"
                                         "set Struts = 0 1; 1 2; 2 3; 3 0\n"
                                         "set Vector x = 1 0\n"
                                         "set Vector y = 0 1\n"
                                         "set Pairs = damper: 0 2\n",
                                         ".",
                                         dimension)
                            ->build();
    Lattice lattice = make_array_in_region(cell, {{n, n, 1}}, region, context);
    lattice.dimension = dimension;
    return lattice;
  }

  void change(const ArrayChanges &changes, Lattice &lattice)
  {
    SceneContext context;
    context.path      = "Lattice";
    context.dimension = lattice.dimension;
    change_array(changes, context, lattice);
  }

  ArrayChanges missing(const std::string &struts,
                       const double       probability,
                       const unsigned int seed)
  {
    ArrayChanges changes;
    changes.missing_struts      = struts;
    changes.missing_probability = probability;
    changes.seed                = seed;
    return changes;
  }
} // namespace

TEST(ArrayChanges, RegionKeepsCellsByTheirMiddles)
{
  const Lattice lattice = squares(4, 2, "x < 1 || x > 3 || y < 1 || y > 3");
  // A frame of 12 cells without the joint and the four struts in the middle.
  EXPECT_EQ(lattice.joints.size(), 24u);
  EXPECT_EQ(lattice.struts.size(), 36u);
  EXPECT_EQ(lattice.pair_sets.at("damper").size(), 12u);
  EXPECT_EQ(lattice.strut_sets.at("all").size(), lattice.struts.size());
  EXPECT_TRUE(std::any_of(lattice.notes.begin(),
                          lattice.notes.end(),
                          [](const std::string &note) {
                            return note ==
                              "Lattice/Region leaves 12 of 16 cells.";
                          }));
}

TEST(ArrayChanges, MissingStrutsDependOnTheSeedAlone)
{
  const auto n_left = [](const unsigned int seed) {
    Lattice lattice = squares(40);
    change(missing("all", 0.05, seed), lattice);
    double sum = 0;
    for (const Strut &strut : lattice.struts)
      sum += strut.joints[0];
    return std::pair(lattice.struts.size(), sum);
  };
  const unsigned int all = 2 * 40 * 41;
  EXPECT_EQ(n_left(1), n_left(1));
  EXPECT_NE(n_left(1).second, n_left(2).second);
  // Within four standard deviations.
  EXPECT_NEAR(n_left(1).first, 0.95 * all, 4 * std::sqrt(0.05 * 0.95 * all));
}

TEST(ArrayChanges, JointsAndPairsGoWithTheirStruts)
{
  Lattice lattice = squares(1);
  change(missing("0, 1", 1, 1), lattice);
  EXPECT_EQ(lattice.struts.size(), 2u);
  EXPECT_EQ(lattice.joints.size(), 3u);
  EXPECT_EQ(lattice.pair_sets.at("damper").size(), 1u);
  Lattice other = squares(1);
  change(missing("x > 0.3 && y > 0.3", 1, 1), other);
  EXPECT_EQ(other.joints.size(), 3u);
  EXPECT_EQ(other.pair_sets.at("damper").size(), 0u);
  EXPECT_EQ(other.notes.back(),
            "2 of 4 struts are missing. Also removed are joints without "
            "struts: 1, connectors: 1.");
}

TEST(ArrayChanges, MapsClosePanelsToTubes)
{
  Lattice      lattice = squares(12, 3);
  ArrayChanges changes;
  changes.map = {{"2 * cos(pi * x / 6)", "2 * sin(pi * x / 6)", "y"}};
  change(changes, lattice);
  EXPECT_EQ(lattice.joints.size(), 12u * 13);
  EXPECT_EQ(lattice.struts.size(), 12u * 13 + 12 * 12);
  for (const auto &joint : lattice.joints)
    EXPECT_NEAR(std::hypot(joint[0], joint[1]), 2, 1e-14);
  EXPECT_EQ(lattice.joint_sets.at("left"), lattice.joint_sets.at("right"));
  EXPECT_EQ(lattice.joint_sets.at("bottom").size(), 12u);
  EXPECT_EQ(lattice.pair_sets.at("damper").size(), 144u);
}

TEST(ArrayChanges, RefusesToRemoveEverything)
{
  expect_parts(input_error_of([] { squares(2, 2, "x > 100"); }),
               {"Lattice/Region = x > 100", "no strut of the lattice remains"});
  expect_parts(input_error_of([] {
                 Lattice lattice = squares(2);
                 change(missing("all", 1, 1), lattice);
               }),
               {"Lattice/Missing struts", "no strut of the lattice remains"});
}
