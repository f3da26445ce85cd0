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
     * Pivots below this, beside the norm of the scaled matrix, are zeros
     * (CNTL(3)).
     */
    constexpr double null_pivot_threshold = 1e-13;

    /**
     * By how much, in percent, MUMPS's room may exceed its estimate
     * (ICNTL(14)): its own start, and where it is out of reason.
     */
    constexpr int initial_room = 20, largest_room = 20000;

    /**
     * A first estimate of the inverse's norm below this, by a vector of which
     * the modes in question are some part, is no sign of a singular matrix.
     */
    constexpr double regular_norm_bound = 1 / sqrt_round_off;

    void divide(std::vector<double> &x, const std::vector<double> &by)
    {
      for (std::size_t i = 0; i < x.size(); ++i)
        x[i] /= by[i];
    }

    /** Numbers of the actions that MUMPS can be asked for (JOB). */
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
      bool                 lacks_room() const;

      /** By the numbers of MUMPS's manual, which begin at 1. */
      MUMPS_INT &setting(int number);
      int        result_of_all(int number) const;

      MPI_Comm         communicator = MPI_COMM_NULL;
      unsigned int     rank = 0, n_ranks = 1;
      std::vector<int> first_row, sizes; ///< by rank

      DMUMPS_STRUC_C id            = {};
      bool           is_started    = false;
      bool           is_symmetric  = true;
      bool           is_factorized = false;

      /** The lower triangle if symmetric, from 1. */
      std::vector<int>         rows, columns;
      std::vector<std::size_t> positions; ///< in the matrix
      std::vector<double>      entries;
      std::vector<double>      scale, room;
      std::vector<double>      x_of_all; ///< on the first of several ranks
    };

    Mumps::~Mumps()
    {
      // All ranks have to stop it together: not if an exception, which may be
      // of this one alone, ends the run.
      if (n_ranks == 1 || std::uncaught_exceptions() == 0)
        stop();
    }

    MUMPS_INT &Mumps::setting(const int number)
    {
      return id.icntl[number - 1];
    }

    int Mumps::result_of_all(const int number) const
    {
      return id.infog[number - 1];
    }

    FactorizationOutcome Mumps::run(const Job job)
    {
      id.job = job;
      dmumps_c(&id);
      switch (result_of_all(1))
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
            AssertThrow(result_of_all(1) >= 0,
                        dealii::ExcMessage(
                          "MUMPS fails with INFOG(1) = " +
                          std::to_string(result_of_all(1)) +
                          ", INFOG(2) = " + std::to_string(result_of_all(2))));
            return FactorizationOutcome::done;
        }
    }

    /** Whether more room than its own estimate helps MUMPS. */
    bool Mumps::lacks_room() const
    {
      constexpr std::array<int, 6> codes = {{-8, -9, -14, -15, -17, -20}};
      return std::find(codes.begin(), codes.end(), result_of_all(1)) !=
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
      id.par             = 1; // the first rank takes its share of the work
      id.sym             = matrix.is_symmetric ? 2 : 0;
      is_symmetric       = matrix.is_symmetric;
      const auto outcome = run(begin);
      // What cannot begin cannot be ended either: MUMPS would abort.
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
      setting(13) = 1; // all negative pivots are counted
      setting(14) = initial_room;
      setting(18) = 3;                    // each rank gives its entries
      setting(24) = 1;                    // finds null pivots
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

      FactorizationOutcome outcome = agree(catch_bad_alloc([&] {
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
        x_of_all.resize(layout.n_global());

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
        agree(has_finite_entries(matrix) ? FactorizationOutcome::done
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
      while (outcome == FactorizationOutcome::out_of_memory && lacks_room() &&
             setting(14) < largest_room)
        {
          setting(14) *= 3;
          outcome = run(factorizing);
        }
      if (outcome != FactorizationOutcome::done)
        return outcome;
      is_factorized = true;
      if (result_of_all(28) > 0)
        return FactorizationOutcome::singular;
      outcome = check(matrix);
      // Zeros that MUMPS has not found are not in its counts.
      is_factorized = outcome == FactorizationOutcome::done;
      return outcome;
    }

    /**
     * Null pivots of large matrices drown in the round-off of all before them.
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
      id.rhs = n_ranks == 1 ? x : x_of_all.data();
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
      const unsigned long negative = result_of_all(12),
                          zero     = result_of_all(28);
      return Inertia{negative, zero, id.n - negative - zero};
    }

    std::optional<int> Mumps::determinant_sign() const
    {
      if (id.n == 0 || !is_factorized || is_symmetric)
        return DirectSolver::determinant_sign();
      // A mantissa, of which the exponent is INFOG(34).
      return id.rinfog[11] < 0 ? -1 : 1;
    }

    std::size_t Mumps::memory() const
    {
      if (!is_factorized)
        return 0;
      // INFO(9) and INFO(10); in millions if negative.
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
