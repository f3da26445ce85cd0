#include <auxfem/algebra/boundary_pivots.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Ranks = std::vector<std::optional<unsigned int>>;

  /** Calls with every owned row and each of its columns. */
  template <typename Visit>
  void for_each_entry(const SparseMatrix &matrix, const Visit &visit)
  {
    for (unsigned int row = 0; row < matrix.layout->n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        visit(row, matrix.columns[i]);
  }

  /** Joints and what multipliers tie go as a whole, neighbours to one rank. */
  void expect_no_conflicts(const BeamSystem &system, const Ranks &pivots)
  {
    const auto is_multiplier = [&](const int row) {
      return system.unknowns->kinds[row] == UnknownKind::multiplier;
    };
    std::map<unsigned int, std::optional<unsigned int>> of_joint;
    for_each_entry(*system.matrix, [&](const int row, const int column) {
      if (pivots[row] && pivots[column])
        {
          EXPECT_EQ(*pivots[row], *pivots[column]);
        }
      if (is_multiplier(row) || is_multiplier(column))
        {
          EXPECT_EQ(pivots[row], pivots[column]);
          return;
        }
      EXPECT_EQ(of_joint.emplace(system.unknowns->joint[row], pivots[row])
                  .first->second,
                pivots[row]);
    });
  }

  /** The lowest rank that the joint of each row at the boundary acts on. */
  Ranks lowest_ranks(const BeamSystem &system)
  {
    const UnknownLayout                 &layout = *system.layout;
    std::map<unsigned int, unsigned int> lowest;
    for_each_entry(*system.matrix, [&](const int row, const int column) {
      if (!layout.is_owned(column))
        {
          const unsigned int other =
            std::min(layout.rank(), layout.owner(layout.global(column)));
          unsigned int &rank =
            lowest.emplace(system.unknowns->joint[row], other).first->second;
          rank = std::min(rank, other);
        }
    });
    Ranks ranks(layout.n_owned());
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      if (const auto known = lowest.find(system.unknowns->joint[row]);
          known != lowest.end())
        ranks[row] = known->second;
    return ranks;
  }

  /** Some joints at the boundary wait, but only where more than two ranks
   * meet. */
  void expect_few_to_wait(const BeamSystem &system,
                          const Ranks      &pivots,
                          const Ranks      &lowest)
  {
    const UnknownLayout &layout     = *system.layout;
    double               n_boundary = 0, n_waiting = 0;
    for (unsigned int row = 0; row < layout.n_owned(); ++row)
      if (lowest[row])
        {
          ++n_boundary;
          n_waiting += pivots[row] ? 0 : 1;
        }
    n_boundary = layout.sum(n_boundary);
    n_waiting  = layout.sum(n_waiting);
    EXPECT_EQ(n_boundary > 0, layout.n_ranks() > 1);
    EXPECT_EQ(n_waiting > 0, layout.n_ranks() > 2);
    EXPECT_LE(n_waiting, n_boundary / 2);
  }
} // namespace

TEST(BoundaryPivots, GoToTheLowestRankTheyActOn)
{
  const BeamSystem system(2, star_lattice(2, {{6, 6, 1}}));
  const Ranks      pivots = boundary_pivots(*system.matrix, *system.unknowns),
              lowest      = lowest_ranks(system);
  expect_no_conflicts(system, pivots);
  expect_few_to_wait(system, pivots, lowest);
  for (unsigned int row = 0; row < lowest.size(); ++row)
    if (pivots[row])
      {
        EXPECT_EQ(pivots[row], lowest[row]);
      }
}

TEST(BoundaryPivots, WhatMultipliersTieGoesTogether)
{
  BeamOptions       options;
  const BeamLattice lattice = star_lattice(2, {{6, 6, 1}});
  for (unsigned int strut = 0; strut < lattice.struts.size(); strut += 3)
    options.rigid_struts.push_back(strut);
  const BeamSystem system(2, lattice, options);
  const Ranks      pivots = boundary_pivots(*system.matrix, *system.unknowns);
  expect_no_conflicts(system, pivots);
  expect_few_to_wait(system, pivots, lowest_ranks(system));
}
