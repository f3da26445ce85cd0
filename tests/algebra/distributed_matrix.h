#ifndef auxfem_tests_algebra_distributed_matrix_h
#define auxfem_tests_algebra_distributed_matrix_h

#include <auxfem/algebra/sparse_matrix.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace auxfem::testing_support
{
  /** Entries by row and column, the same on all ranks. */
  using Entries = std::vector<std::map<int, double>>;

  inline void
  add(Entries &entries, const int i, const int j, const double value)
  {
    entries[i][j] += value;
    if (i != j)
      entries[j][i] += value;
  }

  /** Whether the last of several ranks has rows. */
  enum class Spread
  {
    on_all_ranks,
    not_on_last_rank
  };

  /** Entries spread over the ranks of MPI_COMM_WORLD. */
  class DistributedMatrix
  {
  public:
    explicit DistributedMatrix(const Entries &entries,
                               const bool     is_symmetric = true,
                               const Spread   spread = Spread::on_all_ranks)
      : layout(MPI_COMM_WORLD, rows_of_rank(entries.size(), spread), {})
      , matrix(layout)
    {
      matrix.is_symmetric = is_symmetric;
      const int     begin = layout.first_of(layout.rank());
      std::set<int> ghosts;
      for (unsigned int row = 0; row < layout.n_owned(); ++row)
        for (const auto &[column, entry] : entries[begin + row])
          if (layout.local(column) < 0)
            ghosts.insert(column);
      // Ghosts in an order other than that of global numbers.
      layout.add_ghosts({ghosts.rbegin(), ghosts.rend()});

      for (unsigned int row = 0; row < layout.n_owned(); ++row)
        {
          std::map<int, double> local;
          for (const auto &[column, entry] : entries[begin + row])
            local[layout.local(column)] = entry;
          for (const auto &[column, entry] : local)
            {
              matrix.columns.push_back(column);
              matrix.entries.push_back(entry);
            }
          matrix.first[row + 1] = matrix.columns.size();
        }
    }

    DistributedMatrix(const DistributedMatrix &)            = delete;
    DistributedMatrix &operator=(const DistributedMatrix &) = delete;

    /** Right-hand side on owned rows, of size one. */
    std::vector<double> right_side() const
    {
      std::vector<double> b(layout.n_owned());
      for (unsigned int row = 0; row < b.size(); ++row)
        b[row] = std::cos(1. + layout.global(row));
      return b;
    }

    /**
     * Largest of |A x - b| / (|A| |x| + |b|) by rows: the backward error of
     * Oettli and Prager.
     */
    double residual(const std::vector<double> &x, const std::vector<double> &b)
    {
      std::vector<double> local(layout.n_local());
      std::copy(x.begin(), x.end(), local.begin());
      layout.update_ghosts(local.data());
      std::vector<double> image(layout.n_owned()), size(layout.n_owned());
      matrix.multiply(local.data(), image.data());
      SparseMatrix sizes = matrix;
      for (double &entry : sizes.entries)
        entry = std::abs(entry);
      for (double &value : local)
        value = std::abs(value);
      sizes.multiply(local.data(), size.data());
      double largest = 0;
      for (unsigned int row = 0; row < layout.n_owned(); ++row)
        {
          const double error = std::abs(image[row] - b[row]) /
            std::max(size[row] + std::abs(b[row]), 1e-300);
          // The negated comparison keeps NaN.
          if (!(error <= largest))
            largest = error;
        }
      return layout.largest(std::isnan(largest) ? HUGE_VAL : largest);
    }

    UnknownLayout layout;
    SparseMatrix  matrix;

  private:
    static unsigned int rows_of_rank(const std::size_t n, const Spread spread)
    {
      namespace MPI              = dealii::Utilities::MPI;
      const unsigned int n_ranks = MPI::n_mpi_processes(MPI_COMM_WORLD);
      const unsigned int rank    = MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n_with_rows =
        n_ranks > 1 && spread == Spread::not_on_last_rank ? n_ranks - 1
                                                          : n_ranks;
      return rank < n_with_rows
        ? n * (rank + 1) / n_with_rows - n * rank / n_with_rows
        : 0;
    }
  };

  /**
   * Random matrix with a symmetric pattern and @p n_neighbours entries per row.
   */
  inline Entries random_entries(const int     n,
                                const int     n_neighbours,
                                const double  diagonal,
                                std::mt19937 &random)
  {
    std::uniform_real_distribution<> entry(-1., 1.);
    std::uniform_int_distribution<>  position(0, n - 1);
    Entries                          entries(n);
    for (int i = 0; i < n; ++i)
      {
        add(entries, i, i, diagonal);
        for (int k = 0; k < n_neighbours / 2; ++k)
          if (const int j = position(random); j != i)
            add(entries, i, j, entry(random));
      }
    return entries;
  }

  /**
   * Squares of n x n plane beams with diagonals, of unit length and slenderness
   * @p slenderness (length over radius of gyration), free in the plane: the
   * pattern of joints, three unknowns each, and three rigid-body modes.
   */
  inline Entries free_grid(const int n, const double slenderness)
  {
    Entries    entries(3 * n * n);
    const auto beam = [&](const int a, const int b, double dx, double dy) {
      const double length = std::hypot(dx, dy);
      dx /= length;
      dy /= length;
      const double axial   = slenderness * slenderness / length;
      const double bending = 1 / length;
      // Elongation and end rotations relative to the chord, by unknowns.
      const int unknowns[6] =
        {3 * a, 3 * a + 1, 3 * a + 2, 3 * b, 3 * b + 1, 3 * b + 2};
      const double e[6] = {-dx, -dy, 0, dx, dy, 0};
      const double t1[6] =
        {-dy / length, dx / length, 1, dy / length, -dx / length, 0};
      const double t2[6] =
        {-dy / length, dx / length, 0, dy / length, -dx / length, 1};
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j)
          add(entries,
              unknowns[i],
              unknowns[j],
              axial * e[i] * e[j] +
                bending *
                  (4 * t1[i] * t1[j] + 4 * t2[i] * t2[j] + 2 * t1[i] * t2[j] +
                   2 * t2[i] * t1[j]));
    };
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        {
          const int here = y * n + x;
          if (x + 1 < n)
            beam(here, here + 1, 1, 0.1);
          if (y + 1 < n)
            beam(here, here + n, -0.1, 1);
          if (x + 1 < n && y + 1 < n)
            beam(here, here + n + 1, 0.9, 1.1);
          if (x > 0 && y + 1 < n)
            beam(here, here + n - 1, -1.1, 0.9);
        }
    return entries;
  }

  /** free_grid() with the joints of its first row on springs. */
  inline Entries supported_grid(const int n, const double slenderness)
  {
    Entries entries = free_grid(n, slenderness);
    for (int i = 0; i < 3 * n; ++i)
      add(entries, i, i, 1.);
    return entries;
  }
} // namespace auxfem::testing_support

#endif
