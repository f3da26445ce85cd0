#include <auxfem/algebra/direct_solvers.h>
#include <auxfem/algebra/factor_checks.h>
#include <auxfem/algebra/first_rank_solver.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

extern "C"
{
  void dsytrf_(const char *uplo,
               const int  *n,
               double     *a,
               const int  *lda,
               int        *ipiv,
               double     *work,
               const int  *lwork,
               int        *info);
  void dsytrs_(const char   *uplo,
               const int    *n,
               const int    *nrhs,
               const double *a,
               const int    *lda,
               const int    *ipiv,
               double       *b,
               const int    *ldb,
               int          *info);
}

namespace auxfem
{
  namespace
  {
    /**
     * Eigenvalues of D below this, beside the largest pivot of the equilibrated
     * matrix, are round-off.
     */
    constexpr double zero_pivot = 1e-13;

    /** Of the block of LAPACK that dsytrf() works with. */
    constexpr int block_size = 32;

    /** On one rank. */
    class Dense : public DirectSolver
    {
    public:
      FactorizationOutcome   analyse(const SparseMatrix &matrix) override;
      FactorizationOutcome   factorize(const SparseMatrix &matrix) override;
      void                   solve(double *x) override;
      std::optional<Inertia> inertia() const override;
      std::size_t            memory() const override;

    private:
      void fill(const SparseMatrix &matrix);
      void count_signs();

      int                    n = 0;
      std::vector<double>    scale, room;
      std::vector<double>    factor; ///< by columns, lower triangle
      std::vector<int>       pivots;
      std::vector<double>    work;
      std::optional<Inertia> signs;
    };

    FactorizationOutcome Dense::analyse(const SparseMatrix &matrix)
    {
      signs.reset();
      n = matrix.layout->n_owned();
      factor.resize(static_cast<std::size_t>(n) * n);
      pivots.resize(n);
      work.resize(static_cast<std::size_t>(n) * block_size);
      return FactorizationOutcome::done;
    }

    void Dense::fill(const SparseMatrix &matrix)
    {
      // Pivots are chosen by size: units must not matter.
      equilibrate(matrix, scale, room);
      std::fill(factor.begin(), factor.end(), 0.);
      for (int row = 0; row < n; ++row)
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          {
            const std::size_t column = matrix.columns[i];
            factor[column * n + row] =
              scale[row] * matrix.entries[i] * scale[column];
          }
    }

    FactorizationOutcome Dense::factorize(const SparseMatrix &matrix)
    {
      Assert(matrix.is_symmetric, dealii::ExcInternalError());
      signs.reset();
      fill(matrix);
      const int n_work = work.size();
      int       info   = 0;
      if (n > 0)
        dsytrf_("L",
                &n,
                factor.data(),
                &n,
                pivots.data(),
                work.data(),
                &n_work,
                &info);
      count_signs();
      return signs->zero > 0 ? FactorizationOutcome::singular
                             : FactorizationOutcome::done;
    }

    /** Of the blocks of D, of one and two rows. */
    void Dense::count_signs()
    {
      std::vector<double> eigenvalues;
      for (int i = 0; i < n; ++i)
        {
          const std::size_t at = static_cast<std::size_t>(i) * n + i;
          if (pivots[i] > 0)
            eigenvalues.push_back(factor[at]);
          else
            {
              const double mean = (factor[at] + factor[at + n + 1]) / 2;
              const double half = (factor[at] - factor[at + n + 1]) / 2;
              const double root = std::hypot(half, factor[at + 1]);
              eigenvalues.push_back(mean + root);
              eigenvalues.push_back(mean - root);
              ++i;
            }
        }
      double largest = 0;
      for (const double eigenvalue : eigenvalues)
        largest = std::max(largest, std::abs(eigenvalue));

      signs = Inertia();
      for (const double eigenvalue : eigenvalues)
        if (std::abs(eigenvalue) <= zero_pivot * largest)
          ++signs->zero;
        else
          ++(eigenvalue > 0 ? signs->positive : signs->negative);
    }

    void Dense::solve(double *x)
    {
      for (int i = 0; i < n; ++i)
        x[i] *= scale[i];
      const int one  = 1;
      int       info = 0;
      if (n > 0)
        dsytrs_("L", &n, &one, factor.data(), &n, pivots.data(), x, &n, &info);
      for (int i = 0; i < n; ++i)
        x[i] *= scale[i];
    }

    std::optional<Inertia> Dense::inertia() const
    {
      return signs;
    }

    std::size_t Dense::memory() const
    {
      return factor.size() * sizeof(double) + pivots.size() * sizeof(int);
    }
  } // namespace

  std::unique_ptr<DirectSolver> make_dense()
  {
    return std::make_unique<FirstRankSolver>(std::make_unique<Dense>());
  }
} // namespace auxfem
