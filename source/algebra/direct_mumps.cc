#include <auxfem/algebra/direct_solver.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <dmumps_c.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <new>

namespace auxfem
{
  namespace
  {
    /**
     * Pivots below this, relative to the norm of the scaled matrix, count as
     * zero (CNTL(3)).
     */
    constexpr double null_pivot_threshold = 1e-13;

    /**
     * Working space beyond MUMPS's estimate in percent (ICNTL(14)): its
     * default, and the limit of increases.
     */
    constexpr int initial_extra_space = 20, max_extra_space = 20000;

    /**
     * Estimate of the inverse's norm after one iteration below which a matrix
     * counts as regular. The first vector contains each mode in part only.
     */
    constexpr double regular_norm_bound = 1 / sqrt_round_off;

    void divide(std::vector<double> &x, const std::vector<double> &by)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] /= by[i];
    }

    /** Values of MUMPS's parameter JOB. */
    enum Job : int
    {
      begin       = -1,
      end         = -2,
      analysis    = 1,
      factorizing = 2,
      solving     = 3
    };

    class Mumps : public DirectSolver
    {
    public:
      Mumps() = default;
      ~Mumps() override;
      Mumps(const Mumps &)            = delete;
      Mumps &operator=(const Mumps &) = delete;

      FactorizationOutcome   analyse(const SparseMatrix &matrix) override;
      FactorizationOutcome   factorize(const SparseMatrix &matrix) override;
      void                   solve(double *x) override;
      std::optional<Inertia> inertia() const override;
      std::optional<int>     determinant_sign() const override;
      std::size_t            memory() const override;

    private:
      FactorizationOutcome run(Job job);
      FactorizationOutcome check(const SparseMatrix &matrix);
      FactorizationOutcome start(const SparseMatrix &matrix);
      void                 stop();
      void                 choose_settings();
      void                 collect_pattern(const SparseMatrix &matrix);
      bool                 lacks_working_space() const;

      /** Numbered from 1, as in MUMPS's manual. */
      MUMPS_INT &setting(int number);
      int        global_result(int number) const;

      MPI_Comm         communicator = MPI_COMM_NULL;
      unsigned int     rank = 0, n_ranks = 1;
      std::vector<int> first_row, sizes; ///< by rank

      DMUMPS_STRUC_C id            = {};
      bool           is_started    = false;
      bool           is_symmetric  = true;
      bool           is_factorized = false;

      /** The lower triangle if symmetric; numbered from 1. */
      std::vector<int>         rows, columns;
      std::vector<std::size_t> positions; ///< in the matrix
      std::vector<double>      entries;
      std::vector<double>      scale, room;
      std::vector<double>      gathered_x; ///< on the first of several ranks
    };

    Mumps::~Mumps()
    {
      // Ending MUMPS is collective, and an exception may unwind this rank
      // alone.
      if (n_ranks == 1 || std::uncaught_exceptions() == 0)
        stop();
    }

    MUMPS_INT &Mumps::setting(const int number)
    {
      return id.icntl[number - 1];
    }

    int Mumps::global_result(const int number) const
    {
      return id.infog[number - 1];
    }

    FactorizationOutcome Mumps::run(const Job job)
    {
      id.job = job;
      dmumps_c(&id);
      switch (global_result(1))
        {
          case -6:
          case -10:
            return FactorizationOutcome::singular;
          case -5:
          case -7:
          case -8:
          case -9:
          case -11:
          case -13:
          case -14:
          case -15:
          case -17:
          case -20:
            return FactorizationOutcome::out_of_memory;
          case -18:
          case -51:
          case -52:
            return FactorizationOutcome::too_large;
          default:
            AssertThrow(global_result(1) >= 0,
                        dealii::ExcMessage(
                          "MUMPS fails with INFOG(1) = " +
                          std::to_string(global_result(1)) +
                          ", INFOG(2) = " + std::to_string(global_result(2))));
            return FactorizationOutcome::done;
        }
    }

    /** Whether more working space may help MUMPS. */
    bool Mumps::lacks_working_space() const
    {
      constexpr std::array<int, 6> codes = {{-8, -9, -14, -15, -17, -20}};
      return std::find(codes.begin(), codes.end(), global_result(1)) !=
        codes.end();
    }

    void Mumps::stop()
    {
      if (is_started)
        {
          id.job = end;
          dmumps_c(&id);
        }
      is_started = false;
    }

    FactorizationOutcome Mumps::start(const SparseMatrix &matrix)
    {
      stop();
      id                 = {};
      id.comm_fortran    = MPI_Comm_c2f(communicator);
      id.par             = 1; // the first rank works, too
      id.sym             = matrix.is_symmetric ? 2 : 0;
      is_symmetric       = matrix.is_symmetric;
      const auto outcome = run(begin);
      // MUMPS would abort at the end of an instance that failed to begin.
      is_started = outcome == FactorizationOutcome::done;
      if (is_started)
        choose_settings();
      return outcome;
    }

    void Mumps::choose_settings()
    {
      for (const int output : {1, 2, 3, 4})
        setting(output) = 0;
      setting(7)  = 5; // METIS
      setting(13) = 1; // count all negative pivots
      setting(14) = initial_extra_space;
      setting(18) = 3;                    // distributed entries
      setting(24) = 1;                    // null pivot detection
      setting(28) = 1;                    // METIS on one rank
      setting(33) = is_symmetric ? 0 : 1; // the determinant
      id.cntl[2]  = null_pivot_threshold;
    }

    FactorizationOutcome Mumps::analyse(const SparseMatrix &matrix)
    {
      is_factorized = false;
      communicator  = matrix.layout->communicator();
      rank          = matrix.layout->rank();
      n_ranks       = matrix.layout->n_ranks();
      id.n          = matrix.layout->n_global();
      if (id.n == 0)
        return FactorizationOutcome::done;

      FactorizationOutcome outcome =
        gravest_outcome(catch_bad_alloc([&] {
                          collect_pattern(matrix);
                          return FactorizationOutcome::done;
                        }),
                        communicator);
      if (outcome == FactorizationOutcome::done)
        outcome = start(matrix);
      if (outcome != FactorizationOutcome::done)
        return outcome;
      id.n       = matrix.layout->n_global();
      id.nnz_loc = rows.size();
      id.irn_loc = rows.data();
      id.jcn_loc = columns.data();
      id.a_loc   = entries.data();
      return run(analysis);
    }

    void Mumps::collect_pattern(const SparseMatrix &matrix)
    {
      const UnknownLayout &layout = *matrix.layout;
      first_row.clear();
      sizes.clear();
      for (unsigned int r = 0; r < n_ranks; ++r)
        {
          first_row.push_back(layout.first_of(r));
          sizes.push_back(layout.first_of(r + 1) - layout.first_of(r));
        }
      if (n_ranks > 1 && rank == 0)
        gathered_x.resize(layout.n_global());

      rows.clear();
      columns.clear();
      positions.clear();
      for (unsigned int row = 0; row < layout.n_owned(); ++row)
        for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
          {
            const int column = layout.global(matrix.columns[i]);
            if (matrix.is_symmetric && column > layout.global(row))
              continue;
            rows.push_back(layout.global(row) + 1);
            columns.push_back(column + 1);
            positions.push_back(i);
          }
      entries.resize(positions.size());
      scale.resize(layout.n_local());
      room.resize(layout.n_owned());
    }

    FactorizationOutcome Mumps::factorize(const SparseMatrix &matrix)
    {
      is_factorized = false;
      FactorizationOutcome outcome =
        gravest_outcome(has_finite_entries(matrix)
                          ? FactorizationOutcome::done
                          : FactorizationOutcome::not_finite,
                        matrix.layout->communicator());
      if (outcome != FactorizationOutcome::done || id.n == 0)
        return outcome;
      if (matrix.is_symmetric != is_symmetric)
        outcome = analyse(matrix);
      if (outcome != FactorizationOutcome::done)
        return outcome;

      for (std::size_t i = 0; i < positions.size(); ++i)
        entries[i] = matrix.entries[positions[i]];
      outcome = run(factorizing);
      while (outcome == FactorizationOutcome::out_of_memory &&
             lacks_working_space() && setting(14) < max_extra_space)
        {
          setting(14) *= 3;
          outcome = run(factorizing);
        }
      if (outcome != FactorizationOutcome::done)
        return outcome;
      is_factorized = true;
      if (global_result(28) > 0)
        return FactorizationOutcome::singular;
      outcome = check(matrix);
      // MUMPS does not count zero pivots that it has not detected.
      is_factorized = outcome == FactorizationOutcome::done;
      return outcome;
    }

    /**
     * Tests for singularity by the norm of the inverse: round-off hides null
     * pivots of large matrices.
     */
    FactorizationOutcome Mumps::check(const SparseMatrix &matrix)
    {
      equilibrate(matrix, scale, room);
      const auto apply_inverse = [&](std::vector<double> &x) {
        divide(x, scale);
        solve(x.data());
        if (!is_symmetric)
          {
            divide(x, scale);
            divide(x, scale);
            setting(9) = 0; // by the transpose
            solve(x.data());
            setting(9) = 1;
          }
        divide(x, scale);
      };
      double norm = 0;
      try
        {
          norm = estimate_norm(*matrix.layout,
                               room,
                               regular_norm_bound,
                               std::cref(apply_inverse));
        }
      catch (const std::bad_alloc &)
        {
          return FactorizationOutcome::out_of_memory;
        }
      if (!is_symmetric)
        norm = std::sqrt(norm);
      return norm < singular_inverse_norm ? FactorizationOutcome::done
                                          : FactorizationOutcome::singular;
    }

    void Mumps::solve(double *x)
    {
      if (id.n == 0)
        return;
      id.rhs = n_ranks == 1 ? x : gathered_x.data();
      if (n_ranks > 1)
        MPI_Gatherv(x,
                    sizes[rank],
                    MPI_DOUBLE,
                    id.rhs,
                    sizes.data(),
                    first_row.data(),
                    MPI_DOUBLE,
                    0,
                    communicator);
      if (run(solving) != FactorizationOutcome::done)
        throw std::bad_alloc();
      if (n_ranks > 1)
        MPI_Scatterv(id.rhs,
                     sizes.data(),
                     first_row.data(),
                     MPI_DOUBLE,
                     x,
                     sizes[rank],
                     MPI_DOUBLE,
                     0,
                     communicator);
    }

    std::optional<Inertia> Mumps::inertia() const
    {
      if (id.n == 0)
        return Inertia();
      if (!is_factorized || !is_symmetric)
        return {};
      const unsigned long negative = global_result(12),
                          zero     = global_result(28);
      return Inertia{negative, zero, id.n - negative - zero};
    }

    std::optional<int> Mumps::determinant_sign() const
    {
      if (id.n == 0 || !is_factorized || is_symmetric)
        return DirectSolver::determinant_sign();
      // Mantissa of the determinant; INFOG(34) is its exponent.
      return id.rinfog[11] < 0 ? -1 : 1;
    }

    std::size_t Mumps::memory() const
    {
      if (!is_factorized)
        return 0;
      // INFO(9) and INFO(10) are in millions if negative.
      const auto count = [](const int number) -> std::size_t {
        return number >= 0 ? number : -1000000l * number;
      };
      return count(id.info[8]) * sizeof(double) +
        count(id.info[9]) * sizeof(int);
    }
  } // namespace

  std::unique_ptr<DirectSolver> make_mumps(const MumpsRanks ranks)
  {
    auto mumps = std::make_unique<Mumps>();
    if (ranks == MumpsRanks::first)
      return make_first_rank_solver(std::move(mumps));
    return mumps;
  }
} // namespace auxfem
