#include <auxfem/algebra/row_migration.h>

#include <gtest/gtest.h>
#include <support/beam_lattice.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Sums of the rows of this rank, weighted by columns, by joint and
   * component. */
  std::map<std::pair<unsigned int, unsigned int>, double>
  row_sums(const SparseMatrix &matrix, const Unknowns &unknowns)
  {
    std::map<std::pair<unsigned int, unsigned int>, double> sums;
    for (unsigned int row = 0; row < matrix.layout->n_owned(); ++row)
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        sums[{unknowns.joint[row], unknowns.component[row]}] +=
          matrix.entries[i] * (1 + unknowns.joint[matrix.columns[i]]);
    return sums;
  }
} // namespace

TEST(RowMigration, BringsRowsInsideAndBack)
{
  const BeamSystem   system(2, star_lattice(2, {{5, 5, 1}}));
  const Unknowns    &unknowns = *system.unknowns;
  const unsigned int n        = unknowns.layout.n_owned(),
                     rank     = unknowns.layout.rank();

  RowMigration inside(*system.matrix, unknowns);
  inside.fill(*system.matrix);
  const unsigned int  n_inside = inside.unknowns().layout.n_owned();
  std::vector<double> ranks(n_inside);
  inside.go(std::vector<double>(n, rank).data(), ranks.data());
  // The first rank gains what others lose.
  if (unknowns.layout.n_ranks() > 1)
    {
      EXPECT_EQ(n_inside > n, rank == 0);
      EXPECT_EQ(std::count(ranks.begin(), ranks.end(), rank) < n_inside,
                rank + 1 < unknowns.layout.n_ranks());
    }

  RowMigration back(inside.matrix(),
                    inside.unknowns(),
                    {ranks.begin(), ranks.end()});
  back.fill(inside.matrix());
  const auto before = row_sums(*system.matrix, unknowns),
             after  = row_sums(back.matrix(), back.unknowns());
  ASSERT_EQ(before.size(), after.size());
  for (const auto &[place, sum] : before)
    {
      ASSERT_EQ(after.count(place), 1u);
      EXPECT_NEAR(after.at(place), sum, 1e-12 * std::abs(sum) + 1e-6);
    }

  // Values go the way of the rows.
  std::vector<double> values(n), there(n_inside), home(n);
  for (unsigned int row = 0; row < n; ++row)
    values[row] = 10. * unknowns.joint[row] + unknowns.component[row];
  inside.go(values.data(), there.data());
  back.go(there.data(), home.data());
  for (unsigned int row = 0; row < n; ++row)
    EXPECT_EQ(home[row],
              10. * back.unknowns().joint[row] +
                back.unknowns().component[row]);
  back.come_back(home.data(), there.data());
  std::vector<double> again(n);
  inside.come_back(there.data(), again.data());
  EXPECT_EQ(again, values);
}
