#include <auxfem/algebra/direct_solver.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

#include <klu.h>

namespace auxfem
{
  namespace
  {
    /**
     * Growth of the factors, relative to that with new pivots, up to which
     * pivots are reused for new entries. The growth is computed only where the
     * condition, which costs less, has fallen by as much.
     * @tuned judgement
     */
    constexpr double max_growth_of_reused_pivots = 100;

    /** Sign, 1 or -1, of the determinant of a permutation of @p n numbers. */
    int sign_of_permutation(const int *permutation, const std::size_t n)
    {
      std::vector<bool> is_done(n, false);
      int               sign = 1;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = permutation[i]; !is_done[i] && k != i;
             k             = permutation[k])
          {
                        // A cycle of k + 1 members is a product of k exchanges.
            is_done[k] = true;
            sign       = -sign;
          }
      return sign;
    }

    /**
     * KLU on one rank. KLU works by columns: it factorizes the transpose, and
     * solves with the transpose of that.
     */
    class Klu : public DirectSolver
    {
    public:
      explicit Klu(EliminationOrder order);
      ~Klu() override;
      Klu(const Klu &)            = delete;
      Klu &operator=(const Klu &) = delete;

      FactorizationOutcome   analyse(const SparseMatrix &matrix) override;
      FactorizationOutcome   factorize(const SparseMatrix &matrix) override;
      void                   solve(double *x) override;
      std::optional<Inertia> inertia() const override;
      std::optional<int>     determinant_sign() const override;
      std::size_t            memory() const override;
      void                   forget_pivots() override;

    private:
      FactorizationOutcome outcome_of_failure() const;
      bool                 choose_pivots(int *columns, double *entries);
      bool                 refactorize(int *columns, double *entries);
      bool                 is_singular(const SparseMatrix &matrix);

      const EliminationOrder elimination;
      klu_common             common;
      klu_symbolic          *symbolic = nullptr;
      klu_numeric           *numeric  = nullptr;
      std::size_t            n        = 0;
      std::vector<int>       offsets;
      /** Growth and condition with new pivots, as klu_rgrowth() and klu_rcond()
       * define them. */
      double fresh_growth = 0, fresh_condition = 0;
    };

    Klu::Klu(const EliminationOrder order) : elimination(order)
    {
      klu_defaults(&common);
      // Lattices are connected: a block triangular form would have blocks of
      // one unknown only.
      common.btf = 0;
    }

    Klu::~Klu()
    {
      klu_free_numeric(&numeric, &common);
      klu_free_symbolic(&symbolic, &common);
    }

    FactorizationOutcome Klu::outcome_of_failure() const
    {
      switch (common.status)
        {
          case KLU_SINGULAR:
            return FactorizationOutcome::singular;
          case KLU_OUT_OF_MEMORY:
            return FactorizationOutcome::out_of_memory;
          case KLU_TOO_LARGE:
            return FactorizationOutcome::too_large;
          default:
            AssertThrow(false,
                        dealii::ExcMessage("KLU fails with status " +
                                           std::to_string(common.status)));
            return FactorizationOutcome::singular;
        }
    }

    FactorizationOutcome Klu::analyse(const SparseMatrix &matrix)
    {
      klu_free_numeric(&numeric, &common);
      klu_free_symbolic(&symbolic, &common);
      n = matrix.layout->n_owned();
      if (!fits_narrow_offsets(matrix))
        return FactorizationOutcome::too_large;
      if (n == 0)
        return FactorizationOutcome::done;
      offsets                  = narrow_offsets(matrix);
      std::vector<int> order   = elimination_order(matrix, elimination);
      std::vector<int> columns = matrix.columns;
      symbolic                 = klu_analyze_given(n,
                                   offsets.data(),
                                   columns.data(),
                                   order.data(),
                                   order.data(),
                                   &common);
      return symbolic == nullptr ? outcome_of_failure()
                                 : FactorizationOutcome::done;
    }

    FactorizationOutcome Klu::factorize(const SparseMatrix &matrix)
    {
      if (n == 0)
        return FactorizationOutcome::done;
      // KLU does not write to these.
      int *const    columns = const_cast<int *>(matrix.columns.data());
      double *const entries = const_cast<double *>(matrix.entries.data());
      const bool is_done = numeric != nullptr && refactorize(columns, entries);
      if (!is_done && !choose_pivots(columns, entries))
        return outcome_of_failure();
      if (!is_singular(matrix))
        return FactorizationOutcome::done;
      forget_pivots();
      return FactorizationOutcome::singular;
    }

    bool Klu::choose_pivots(int *const columns, double *const entries)
    {
      klu_free_numeric(&numeric, &common);
      numeric = klu_factor(offsets.data(), columns, entries, symbolic, &common);
      if (numeric == nullptr ||
          !klu_rgrowth(offsets.data(),
                       columns,
                       entries,
                       symbolic,
                       numeric,
                       &common))
        return false;
      fresh_growth = common.rgrowth;
      klu_rcond(symbolic, numeric, &common);
      fresh_condition = common.rcond;
      return true;
    }

    /** Reuses the present pivots; false if they are not accurate enough. */
    bool Klu::refactorize(int *const columns, double *const entries)
    {
      if (!klu_refactor(offsets.data(),
                        columns,
                        entries,
                        symbolic,
                        numeric,
                        &common) ||
          common.status != KLU_OK)
        return false;
      // Growing entries enlarge the ratio of the largest and smallest pivot.
      klu_rcond(symbolic, numeric, &common);
      if (common.rcond * max_growth_of_reused_pivots >= fresh_condition)
        return true;
      return klu_rgrowth(offsets.data(),
                         columns,
                         entries,
                         symbolic,
                         numeric,
                         &common) &&
        common.rgrowth * max_growth_of_reused_pivots >= fresh_growth;
    }

    bool Klu::is_singular(const SparseMatrix &matrix)
    {
      klu_rcond(symbolic, numeric, &common);
      if (common.rcond > suspicious_pivot)
        return false;

      // Scaling removes the units of rows and columns, which do not make a
      // matrix singular.
      std::vector<double> row_size(n, 0.), column_size(n, 0.), room(n);
      for (std::size_t row = 0; row < n; ++row)
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          row_size[row] = std::max(row_size[row], std::abs(matrix.entries[i]));
      for (std::size_t row = 0; row < n; ++row)
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          column_size[matrix.columns[i]] =
            std::max(column_size[matrix.columns[i]],
                     std::abs(matrix.entries[i]) / row_size[row]);
      const auto apply_inverse_and_transpose = [&](std::vector<double> &x) {
        for (std::size_t i = 0; i < n; ++i)
          x[i] *= row_size[i];
        klu_tsolve(symbolic, numeric, n, 1, x.data(), &common);
        for (std::size_t i = 0; i < n; ++i)
          x[i] *= column_size[i] * column_size[i];
        klu_solve(symbolic, numeric, n, 1, x.data(), &common);
        for (std::size_t i = 0; i < n; ++i)
          x[i] *= row_size[i];
      };
      const double norm = std::sqrt(
        estimate_norm(*matrix.layout, room, 0., apply_inverse_and_transpose));
      return !(norm < singular_inverse_norm);
    }

    void Klu::solve(double *x)
    {
      Assert(n == 0 || numeric != nullptr, dealii::ExcInternalError());
      if (n > 0)
        klu_tsolve(symbolic, numeric, n, 1, x, &common);
    }

    std::optional<Inertia> Klu::inertia() const
    {
      return {};
    }

    /**
     * From P R^-1 A Q = L U, with positive scales R and a unit diagonal of L.
     */
    std::optional<int> Klu::determinant_sign() const
    {
      if (n == 0)
        return 1;
      if (numeric == nullptr)
        return {};
      int sign = sign_of_permutation(numeric->Pnum, n) *
        sign_of_permutation(symbolic->Q, n);
      const auto *const pivots = static_cast<const double *>(numeric->Udiag);
      for (std::size_t i = 0; i < n; ++i)
        if (pivots[i] < 0)
          sign = -sign;
      return sign;
    }

    std::size_t Klu::memory() const
    {
      if (numeric == nullptr)
        return 0;
      return (static_cast<std::size_t>(numeric->lnz) + numeric->unz) *
        (sizeof(double) + sizeof(int)) +
        numeric->worksize + 10 * n * sizeof(int);
    }

    void Klu::forget_pivots()
    {
      klu_free_numeric(&numeric, &common);
    }
  } // namespace

  std::unique_ptr<DirectSolver> make_klu(const EliminationOrder order)
  {
    return make_first_rank_solver(std::make_unique<Klu>(order));
  }
} // namespace auxfem
