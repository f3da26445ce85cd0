#include <auxfem/algebra/direct_solvers.h>
#include <auxfem/algebra/factor_checks.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <limits>

extern "C"
{
  void dsytrf_(const char *uplo,
               const int  *n,
               double     *a,
               const int  *lda,
               int        *pivots,
               double     *work,
               const int  *lwork,
               int        *info);

  void dsytrs_(const char   *uplo,
               const int    *n,
               const int    *n_right_sides,
               const double *a,
               const int    *lda,
               const int    *pivots,
               double       *b,
               const int    *ldb,
               int          *info);
}

namespace auxfem
{
  namespace
  {
    /** LAPACK's blocks of columns have at most as many. */
    constexpr int block_size = 64;

    /** The triangle that is factorized, where columns come first. */
    constexpr const char *lower = "L";

    /** On one rank; the matrix is factorized with rows and columns scaled. */
    class BunchKaufman : public DirectSolver
    {
    public:
      FactorizationOutcome   analyse(const SparseMatrix &matrix) override;
      FactorizationOutcome   factorize(const SparseMatrix &matrix) override;
      void                   solve(double *x) override;
      std::optional<Inertia> inertia() const override;
      std::size_t            memory() const override;

    private:
      void fill(const SparseMatrix &matrix);
      bool is_singular(const UnknownLayout &layout);
      void solve_scaled(double *x) const;
      void count_signs();

      int                    n = 0;
      std::vector<double>    factors; ///< n x n
      std::vector<int>       pivots;  ///< numbered from 1, see dsytrf
      std::vector<double>    scale, room;
      std::optional<Inertia> signs;
    };

    FactorizationOutcome BunchKaufman::analyse(const SparseMatrix &matrix)
    {
      signs.reset();
      if (matrix.layout->n_owned() >
          std::numeric_limits<int>::max() / block_size)
        return FactorizationOutcome::too_large;
      n = static_cast<int>(matrix.layout->n_owned());
      factors.resize(static_cast<std::size_t>(n) * n);
      pivots.resize(n);
      return FactorizationOutcome::done;
    }

    FactorizationOutcome BunchKaufman::factorize(const SparseMatrix &matrix)
    {
      Assert(matrix.is_symmetric, dealii::ExcInternalError());
      signs.reset();
      equilibrate(matrix, scale, room);
      fill(matrix);
      std::vector<double> work(static_cast<std::size_t>(n) * block_size + 1);
      const int           n_work = work.size(), lda = std::max(n, 1);
      int                 info = 0;
      dsytrf_(lower,
              &n,
              factors.data(),
              &lda,
              pivots.data(),
              work.data(),
              &n_work,
              &info);
      // A pivot that is zero.
      if (info > 0 || is_singular(*matrix.layout))
        return FactorizationOutcome::singular;
      count_signs();
      return FactorizationOutcome::done;
    }

    /** Rows above the diagonal, which are columns below it to LAPACK. */
    void BunchKaufman::fill(const SparseMatrix &matrix)
    {
      std::fill(factors.begin(), factors.end(), 0.);
      for (int row = 0; row < n; ++row)
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          if (const int column = matrix.columns[i]; column >= row)
            factors[static_cast<std::size_t>(row) * n + column] =
              matrix.entries[i] * scale[row] * scale[column];
    }

    bool BunchKaufman::is_singular(const UnknownLayout &layout)
    {
      const auto apply_inverse = [this](std::vector<double> &x) {
        solve_scaled(x.data());
      };
      return n > 0 &&
        !(estimate_norm(layout, room, 0., apply_inverse) <
          singular_inverse_norm);
    }

    void BunchKaufman::count_signs()
    {
      signs = Inertia();
      for (int i = 0; i < n; ++i)
        if (pivots[i] > 0)
          ++(factors[static_cast<std::size_t>(i) * n + i] > 0
               ? signs->positive
               : signs->negative);
        else
          {
            // Two rows are one pivot where their own entries are small beside
            // the one between them: its eigenvalues have different signs.
            ++signs->positive;
            ++signs->negative;
            ++i;
          }
    }

    void BunchKaufman::solve_scaled(double *x) const
    {
      const int one = 1, lda = std::max(n, 1);
      int       info = 0;
      dsytrs_(lower,
              &n,
              &one,
              factors.data(),
              &lda,
              pivots.data(),
              x,
              &lda,
              &info);
    }

    void BunchKaufman::solve(double *x)
    {
      for (int i = 0; i < n; ++i)
        x[i] *= scale[i];
      solve_scaled(x);
      for (int i = 0; i < n; ++i)
        x[i] *= scale[i];
    }

    std::optional<Inertia> BunchKaufman::inertia() const
    {
      return signs;
    }

    std::size_t BunchKaufman::memory() const
    {
      return factors.size() * sizeof(double) + pivots.size() * sizeof(int);
    }
  } // namespace

  std::unique_ptr<DirectSolver> make_dense()
  {
    return make_first_rank_solver(std::make_unique<BunchKaufman>());
  }
} // namespace auxfem
