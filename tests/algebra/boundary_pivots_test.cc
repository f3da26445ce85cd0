#include <auxfem/algebra/boundary_pivots.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Ranks = std::vector<std::optional<unsigned int>>;

  bool is_multiplier(const BeamSystem &system, const int row)
  {
    return system.unknowns->kinds[row] == UnknownKind::multiplier;
  }

  /** Calls with every owned row and each of its columns. */
  template <typename Visit>
  void for_each_entry(const SparseMatrix &matrix, const Visit &visit)
  {
    for (unsigned int row = 0; row < matrix.layout->n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        visit(row, matrix.columns[i]);
  }

  void expect_no_conflicts(const BeamSystem &system, const Ranks &pivots)
  {
    std::map<unsigned int, std::optional<unsigned int>> of_joint;
    for_each_entry(*system.matrix, [&](const int row, const int column) {
      if (pivots[row] && pivots[column])
        EXPECT_EQ(*pivots[row], *pivots[column]);
      if (is_multiplier(system, row) || is_multiplier(system, column))
        EXPECT_EQ(pivots[row], pivots[column]);
      if (!is_multiplier(system, row))
        EXPECT_EQ(of_joint.emplace(system.unknowns->joint[row], pivots[row])
                    .first->second,
                  pivots[row]);
    });
  }
} // namespace

TEST(BoundaryPivots, LowestRankTakesJointsAsAWhole)
{
  const BeamSystem     system(2, star_lattice(2, {{6, 6, 1}}));
  const UnknownLayout &layout = *system.layout;
  const Ranks pivots = boundary_pivots(*system.matrix, *system.unknowns);
  expect_no_conflicts(system, pivots);

  // Of joints, what their rows act on.
  std::map<unsigned int, unsigned int> lowest;
  std::set<unsigned int>               at_boundary;
  for_each_entry(*system.matrix, [&](const int row, const int column) {
    const unsigned int joint = system.unknowns->joint[row],
                       owner = layout.owner(layout.global(column));
    unsigned int &rank       = lowest.emplace(joint, owner).first->second;
    rank                     = std::min(rank, owner);
    if (owner != layout.rank())
      at_boundary.insert(joint);
  });
  double n_of_two = 0, n_waiting = 0;
  for (unsigned int row = 0; row < layout.n_owned(); ++row)
    {
      const unsigned int joint = system.unknowns->joint[row];
      if (pivots[row])
        {
          EXPECT_EQ(at_boundary.count(joint), 1u);
          EXPECT_EQ(*pivots[row], lowest.at(joint));
          ++n_of_two;
        }
      else if (at_boundary.count(joint) > 0)
        ++n_waiting;
    }
  EXPECT_EQ(layout.sum(n_of_two) > 0, layout.n_ranks() > 1);
  // Only where more than two ranks meet some wait.
  EXPECT_EQ(layout.sum(n_waiting) > 0, layout.n_ranks() > 2);
}

TEST(BoundaryPivots, WhatMultipliersTieGoesTogetherAndFirst)
{
  BeamOptions       options;
  const BeamLattice lattice = star_lattice(2, {{6, 6, 1}});
  for (unsigned int strut = 0; strut < lattice.struts.size(); strut += 3)
    options.rigid_struts.push_back(strut);
  const BeamSystem system(2, lattice, options);
  const Ranks      pivots = boundary_pivots(*system.matrix, *system.unknowns);
  expect_no_conflicts(system, pivots);

  // What multipliers tie waits for others of them alone.
  const UnknownLayout                     &layout = *system.layout;
  std::vector<std::optional<unsigned int>> tied(layout.n_local());
  for_each_entry(*system.matrix, [&](const int row, const int column) {
    if (is_multiplier(system, row) || is_multiplier(system, column))
      tied[row] = 0;
  });
  layout.update_ghosts(tied);
  double n_tied = 0;
  for_each_entry(*system.matrix, [&](const int row, const int column) {
    if (!pivots[row] || !pivots[column])
      return;
    n_tied += tied[row] ? 1 : 0;
  });
  EXPECT_EQ(layout.sum(n_tied) > 0, layout.n_ranks() > 1);
}
