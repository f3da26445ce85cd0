#include <auxfem/algebra/direct_solver.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include <cholmod.h>

namespace auxfem
{
  namespace
  {
    /**
     * Largest growth of the factors, relative to the equilibrated matrix, that
     * keeps half of the digits. It is 1 for definite matrices.
     */
    constexpr double largest_growth = 1 / sqrt_round_off;

    /** CHOLMOD's simplicial LDL' on one rank. */
    class Cholmod : public DirectSolver
    {
    public:
      explicit Cholmod(EliminationOrder order);
      ~Cholmod() override;
      Cholmod(const Cholmod &)            = delete;
      Cholmod &operator=(const Cholmod &) = delete;

      FactorizationOutcome   analyse(const SparseMatrix &matrix) override;
      FactorizationOutcome   factorize(const SparseMatrix &matrix) override;
      void                   solve(double *x) override;
      std::optional<Inertia> inertia() const override;
      std::size_t            memory() const override;

    private:
      cholmod_sparse       view(const SparseMatrix &matrix);
      FactorizationOutcome outcome_of_failure() const;
      bool                 is_accurate(const SparseMatrix &matrix);
      void                 count_signs();

      /** By position in the elimination order. */
      double              pivot(std::size_t column) const;
      std::vector<double> sums_of_absolute_terms() const;

      const EliminationOrder elimination;
      cholmod_common         common;
      cholmod_factor        *factor = nullptr;
      std::size_t            n      = 0;
      std::vector<int>       offsets;
      std::optional<Inertia> signs;

      /** Scratch for solutions. */
      cholmod_dense *solution = nullptr, *room_1 = nullptr, *room_2 = nullptr;
    };

    Cholmod::Cholmod(const EliminationOrder order) : elimination(order)
    {
      cholmod_start(&common);
      common.print = 0;
      // The order is given; CHOLMOD only postorders its elimination tree.
      common.nmethods           = 1;
      common.method[0].ordering = CHOLMOD_GIVEN;
      // LDL' alone factorizes indefinite matrices; the supernodal LL' is also
      // slower on lattices.
      common.supernodal = CHOLMOD_SIMPLICIAL;
      common.final_ll   = 0;
    }

    Cholmod::~Cholmod()
    {
      cholmod_free_factor(&factor, &common);
      cholmod_free_dense(&solution, &common);
      cholmod_free_dense(&room_1, &common);
      cholmod_free_dense(&room_2, &common);
      cholmod_finish(&common);
    }

    cholmod_sparse Cholmod::view(const SparseMatrix &matrix)
    {
      cholmod_sparse result = {};
      result.nrow = result.ncol = n;
      result.nzmax              = matrix.columns.size();
      result.p                  = offsets.data();
      // CHOLMOD does not write to these.
      result.i = const_cast<int *>(matrix.columns.data());
      result.x = const_cast<double *>(matrix.entries.data());
      // The lower triangle of CHOLMOD's columns is the upper triangle of our
      // rows; this choice avoids a transposition.
      result.stype  = -1;
      result.itype  = CHOLMOD_INT;
      result.xtype  = CHOLMOD_REAL;
      result.dtype  = CHOLMOD_DOUBLE;
      result.sorted = 1;
      result.packed = 1;
      return result;
    }

    FactorizationOutcome Cholmod::outcome_of_failure() const
    {
      if (common.status == CHOLMOD_OUT_OF_MEMORY)
        return FactorizationOutcome::out_of_memory;
      if (common.status == CHOLMOD_TOO_LARGE)
        return FactorizationOutcome::too_large;
      AssertThrow(false,
                  dealii::ExcMessage("CHOLMOD fails with status " +
                                     std::to_string(common.status)));
      return FactorizationOutcome::singular;
    }

    FactorizationOutcome Cholmod::analyse(const SparseMatrix &matrix)
    {
      signs.reset();
      cholmod_free_factor(&factor, &common);
      n = matrix.layout->n_owned();
      if (!fits_narrow_offsets(matrix))
        return FactorizationOutcome::too_large;
      if (n == 0)
        return FactorizationOutcome::done;
      offsets                = narrow_offsets(matrix);
      std::vector<int> order = elimination_order(matrix, elimination);
      cholmod_sparse   a     = view(matrix);
      a.xtype                = CHOLMOD_PATTERN;

      factor = cholmod_analyze_p(&a, order.data(), nullptr, 0, &common);
      if (factor == nullptr)
        return outcome_of_failure();
      if (common.lnz > std::numeric_limits<int>::max())
        return FactorizationOutcome::too_large;
      return FactorizationOutcome::done;
    }

    FactorizationOutcome Cholmod::factorize(const SparseMatrix &matrix)
    {
      Assert(matrix.is_symmetric, dealii::ExcInternalError());
      signs.reset();
      if (n == 0)
        {
          signs = Inertia();
          return FactorizationOutcome::done;
        }
      cholmod_sparse a = view(matrix);
      cholmod_factorize(&a, factor, &common);
      if (common.status < CHOLMOD_OK)
        return outcome_of_failure();
      // `minor` is less than n at a zero pivot.
      if (factor->minor < n || !is_accurate(matrix))
        return FactorizationOutcome::singular;
      count_signs();
      return FactorizationOutcome::done;
    }

    double Cholmod::pivot(const std::size_t column) const
    {
      const int *first = static_cast<const int *>(factor->p);
      return static_cast<const double *>(factor->x)[first[column]];
    }

    /** Diagonal of |L| |D| |L'|: sums of |terms| of a_ii. */
    std::vector<double> Cholmod::sums_of_absolute_terms() const
    {
      const int *const    first   = static_cast<const int *>(factor->p);
      const int *const    rows    = static_cast<const int *>(factor->i);
      const int *const    lengths = static_cast<const int *>(factor->nz);
      const double *const l       = static_cast<const double *>(factor->x);
      std::vector<double> sums(n, 0.);
      for (std::size_t column = 0; column < n; ++column)
        {
          const double size = std::abs(pivot(column));
          sums[column] += size;
          for (int i = first[column] + 1; i < first[column] + lengths[column];
               ++i)
            sums[rows[i]] += l[i] * l[i] * size;
        }
      return sums;
    }

    /**
     * Without pivoting the factors are those of A + E with |e_ij| at most
     * round-off times sqrt(g_i g_j), where g are these sums (Higham, Accuracy
     * and Stability of Numerical Algorithms, 2002, theorem 9.3). They are
     * inaccurate if g is large compared with A. A is singular to round-off if
     * the inverse, with rows and columns multiplied by sqrt(g), has a norm of
     * about one over round-off.
     */
    bool Cholmod::is_accurate(const SparseMatrix &matrix)
    {
      const std::vector<double> sums = sums_of_absolute_terms();
      std::vector<double>       scale(n), room(n);
      equilibrate(matrix, scale, room);
      const int *const unknown       = static_cast<const int *>(factor->Perm);
      bool             is_suspicious = false;
      for (std::size_t column = 0; column < n; ++column)
        {
          const double s = scale[unknown[column]];
          // The negated comparison also rejects NaN.
          if (!(s * s * sums[column] <= largest_growth))
            return false;
          is_suspicious = is_suspicious ||
            std::abs(pivot(column)) < suspicious_pivot * sums[column];
        }
      if (!is_suspicious)
        return true;

      std::vector<double> root(n);
      for (std::size_t column = 0; column < n; ++column)
        root[unknown[column]] = std::sqrt(sums[column]);
      const auto apply_inverse = [&](std::vector<double> &x) {
        for (std::size_t i = 0; i < n; ++i)
          x[i] *= root[i];
        solve(x.data());
        for (std::size_t i = 0; i < n; ++i)
          x[i] *= root[i];
      };
      return estimate_norm(*matrix.layout, room, 0., apply_inverse) <
        singular_inverse_norm;
    }

    void Cholmod::count_signs()
    {
      signs = Inertia();
      for (std::size_t column = 0; column < n; ++column)
        ++(pivot(column) > 0 ? signs->positive : signs->negative);
    }

    void Cholmod::solve(double *x)
    {
      if (n == 0)
        return;
      cholmod_dense b = {};
      b.nrow = b.nzmax = b.d = n;
      b.ncol                 = 1;
      b.x                    = x;
      b.xtype                = CHOLMOD_REAL;
      b.dtype                = CHOLMOD_DOUBLE;
      if (!cholmod_solve2(CHOLMOD_A,
                          factor,
                          &b,
                          nullptr,
                          &solution,
                          nullptr,
                          &room_1,
                          &room_2,
                          &common))
        throw std::bad_alloc();
      std::copy_n(static_cast<const double *>(solution->x), n, x);
    }

    std::optional<Inertia> Cholmod::inertia() const
    {
      return signs;
    }

    std::size_t Cholmod::memory() const
    {
      if (factor == nullptr)
        return 0;
      // Entries with row indices, and four integers per column.
      return factor->nzmax * (sizeof(double) + sizeof(int)) +
        4 * n * sizeof(int);
    }
  } // namespace

  std::unique_ptr<DirectSolver> make_cholmod(const EliminationOrder order)
  {
    return make_first_rank_solver(std::make_unique<Cholmod>(order));
  }
} // namespace auxfem
