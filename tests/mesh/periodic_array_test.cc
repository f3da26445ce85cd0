#include <auxfem/mesh/periodic_array.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <map>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  UnitCell cell_of(const std::string &kind,
                   const unsigned int dimension,
                   const std::string &entries = "")
  {
    return cell_from_text(kind, entries, ".", dimension)->build();
  }

  struct PeriodCounts
  {
    std::string  kind;
    unsigned int dimension, joints, struts;
  };
} // namespace

TEST(PeriodicArray, HasEachJointAndStrutOnce)
{
  // The table of doc/theory/cells.md.
  for (const PeriodCounts &counts : {PeriodCounts{"square", 2, 1, 2},
                                     {"triangular", 2, 2, 6},
                                     {"kagome", 2, 6, 12},
                                     {"hexagonal", 2, 4, 6},
                                     {"double arrowhead", 2, 2, 4},
                                     {"tetrachiral", 2, 4, 6},
                                     {"hexachiral", 2, 12, 18},
                                     {"anti-tetrachiral", 2, 16, 24},
                                     {"cubic", 3, 1, 3},
                                     {"body-centred cubic", 3, 2, 8},
                                     {"octet", 3, 4, 24},
                                     {"Kelvin", 3, 12, 24},
                                     {"diamond", 3, 8, 16},
                                     {"space re-entrant", 3, 8, 20}})
    for (const std::array<unsigned int, 3> n :
         {std::array<unsigned int, 3>{{1, 1, 1}}, {{2, 3, 1}}})
      {
        const unsigned int  n_cells = n[0] * n[1] * n[2];
        const PeriodicArray array =
          make_periodic_array(cell_of(counts.kind, counts.dimension),
                              n,
                              counts.dimension);
        EXPECT_EQ(array.lattice.joints.size() - array.periodicity.images.size(),
                  counts.joints * n_cells)
          << counts.kind;
        EXPECT_EQ(array.lattice.struts.size(), counts.struts * n_cells)
          << counts.kind;
        EXPECT_EQ(array.lattice.n_cells, n_cells);
      }
}

TEST(PeriodicArray, ImagesLieATranslationAway)
{
  const PeriodicArray array =
    make_periodic_array(cell_of("kagome", 2), {{2, 1, 1}}, 2);
  const Lattice &lattice = array.lattice;
  ASSERT_FALSE(array.periodicity.images.empty());
  for (const JointImage &image : array.periodicity.images)
    {
      EXPECT_LT((lattice.joints[image.joint] - lattice.joints[image.base] -
                 array.periodicity.translation(image.shift))
                  .norm(),
                1e-12);
      EXPECT_LT(image.base,
                lattice.joints.size() - array.periodicity.images.size());
    }
  // All joints of the kagome lattice have four struts.
  std::map<unsigned int, unsigned int> n_struts, base_of;
  for (const JointImage &image : array.periodicity.images)
    base_of[image.joint] = image.base;
  for (const Strut &strut : lattice.struts)
    for (const unsigned int joint : strut.joints)
      ++n_struts[base_of.count(joint) ? base_of[joint] : joint];
  for (const auto &[joint, n] : n_struts)
    EXPECT_EQ(n, 4u);
}

TEST(PeriodicArray, TakesStrutsAndPairsToNeighbours)
{
  const PeriodicArray array =
    make_periodic_array(cell_of("pattern",
                                2,
                                "set Joints = 0 0; 0.5 0.25\n"
                                "set Struts = 0 1\n"
                                "set Neighbour struts = link: 1 0 at 1 0; "
                                "link: 1 0 at 0 1\n"
                                "set Pairs = rod: 0 0 at 1 0; damper: 0 1\n"
                                "set Vector x = 1 0.1\n"
                                "set Vector y = 0.2 1\n"),
                        {{1, 1, 1}},
                        2);
  EXPECT_EQ(array.lattice.struts.size(), 3u);
  EXPECT_EQ(array.lattice.strut_sets.at("link").size(), 2u);
  EXPECT_EQ(array.lattice.pair_sets.at("rod").size(), 1u);
  EXPECT_EQ(array.lattice.pair_sets.at("damper").size(), 1u);
  EXPECT_NEAR(array.periodicity.volume(), 1 - 0.02, 1e-14);
}

TEST(PeriodicArray, RefusesCellsWithoutVectors)
{
  const UnitCell cell = cell_of("pattern",
                                2,
                                "set Joints = 0 0; 1 0; 0.5 1\n"
                                "set Struts = 0 1; 1 2; 2 0\n"
                                "set Vector x = 1 0\n");
  EXPECT_TRUE(contains(input_error_of([&] {
                         make_periodic_array(cell, {{1, 1, 1}}, 2);
                       }),
                       "cannot be repeated along y"));
}
