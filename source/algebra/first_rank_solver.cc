#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/rank_exchange.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <new>
#include <numeric>

namespace auxfem
{
  namespace MPI = dealii::Utilities::MPI;

  namespace
  {
    /**
     * Gathers the values of the ranks on the first rank, those of rank r at @p
     * first [r] of @p all. Collective.
     */
    template <typename T>
    void gather(const T                        *mine,
                const std::vector<std::size_t> &first,
                T                              *all,
                const MPI_Comm                  communicator)
    {
      const unsigned int rank = MPI::this_mpi_process(communicator);
      if (rank > 0)
        {
          send_to_first(mine, first[rank + 1] - first[rank], communicator);
          return;
        }
      std::copy(mine, mine + first[1], all);
      for (unsigned int from = 1; from + 1 < first.size(); ++from)
        receive(all + first[from],
                first[from + 1] - first[from],
                from,
                communicator);
    }

    std::vector<std::size_t> offsets(const std::vector<std::size_t> &sizes)
    {
      std::vector<std::size_t> result(1, 0);
      for (const std::size_t size : sizes)
        result.push_back(result.back() + size);
      return result;
    }

    /** See make_first_rank_solver(). */
    class FirstRankSolver : public DirectSolver
    {
    public:
      explicit FirstRankSolver(std::unique_ptr<DirectSolver> solver)
        : solver(std::move(solver))
      {}

      FactorizationOutcome analyse(const SparseMatrix &matrix) override
      {
        communicator = matrix.layout->communicator();
        rank         = matrix.layout->rank();
        n_ranks      = matrix.layout->n_ranks();
        global_inertia.reset();
        global_sign.reset();
        gathered.reset();
        if (n_ranks == 1)
          return catch_bad_alloc([&] { return solver->analyse(matrix); });

        FactorizationOutcome outcome = collect_pattern(matrix);
        if (outcome == FactorizationOutcome::done && gathered)
          outcome =
            catch_bad_alloc([&] { return solver->analyse(gathered->matrix); });
        return gravest_outcome(outcome, communicator);
      }

      FactorizationOutcome factorize(const SparseMatrix &matrix) override
      {
        FactorizationOutcome outcome = has_finite_entries(matrix)
          ? FactorizationOutcome::done
          : FactorizationOutcome::not_finite;
        global_inertia.reset();
        global_sign.reset();
        if (n_ranks == 1)
          {
            if (outcome != FactorizationOutcome::done)
              return outcome;
            outcome =
              catch_bad_alloc([&] { return solver->factorize(matrix); });
            global_inertia = solver->inertia();
            global_sign    = solver->determinant_sign();
            return outcome;
          }

        outcome = gravest_outcome(outcome, communicator);
        if (outcome != FactorizationOutcome::done)
          return outcome;
        for (std::size_t i = 0; i < order.size(); ++i)
          entries[i] = matrix.entries[order[i]];
        gather(entries.data(),
               first_entry,
               gathered ? gathered->matrix.entries.data() : nullptr,
               communicator);
        if (gathered)
          {
            gathered->matrix.is_symmetric = matrix.is_symmetric;
            outcome                       = catch_bad_alloc(
              [&] { return solver->factorize(gathered->matrix); });
            global_inertia = solver->inertia();
            global_sign    = solver->determinant_sign();
          }
        broadcast_signs();
        return gravest_outcome(outcome, communicator);
      }

      void solve(double *x) override
      {
        if (n_ranks == 1)
          {
            solver->solve(x);
            return;
          }

        gather(x,
               first_row,
               gathered ? gathered->x.data() : nullptr,
               communicator);
        int is_out_of_memory = 0;
        if (gathered)
          try
            {
              solver->solve(gathered->x.data());
            }
          catch (const std::bad_alloc &)
            {
              is_out_of_memory = 1;
            }
        MPI_Bcast(&is_out_of_memory, 1, MPI_INT, 0, communicator);
        if (is_out_of_memory != 0)
          throw std::bad_alloc();

        const std::vector<int> first(first_row.begin(), first_row.end());
        std::vector<int>       sizes(n_ranks);
        for (unsigned int r = 0; r < n_ranks; ++r)
          sizes[r] = first[r + 1] - first[r];
        MPI_Scatterv(gathered ? gathered->x.data() : nullptr,
                     sizes.data(),
                     first.data(),
                     MPI_DOUBLE,
                     x,
                     sizes[rank],
                     MPI_DOUBLE,
                     0,
                     communicator);
      }

      std::optional<Inertia> inertia() const override
      {
        return global_inertia;
      }

      std::optional<int> determinant_sign() const override
      {
        return global_sign;
      }

      std::size_t memory() const override
      {
        return n_ranks == 1 || gathered ? solver->memory() : 0;
      }

      void forget_pivots() override
      {
        solver->forget_pivots();
      }

    private:
      FactorizationOutcome collect_pattern(const SparseMatrix &matrix)
      {
        first_entry =
          offsets(MPI::all_gather(communicator, matrix.columns.size()));
        first_row.clear();
        for (unsigned int r = 0; r <= n_ranks; ++r)
          first_row.push_back(matrix.layout->first_of(r));

        const FactorizationOutcome outcome = gravest_outcome(
          catch_bad_alloc([&] {
            sort_rows(matrix);
            if (rank == 0)
              {
                gathered = std::make_unique<GatheredMatrix>(first_row.back());
                gathered->matrix.columns.resize(first_entry.back());
                gathered->matrix.entries.resize(first_entry.back());
              }
            return FactorizationOutcome::done;
          }),
          communicator);
        if (outcome != FactorizationOutcome::done)
          {
            gathered.reset();
            return outcome;
          }

        gather(matrix.first.data(),
               first_row,
               gathered ? gathered->matrix.first.data() : nullptr,
               communicator);
        gather(columns.data(),
               first_entry,
               gathered ? gathered->matrix.columns.data() : nullptr,
               communicator);
        if (gathered)
          {
            std::vector<std::size_t> &first = gathered->matrix.first;
            for (unsigned int r = 0; r < n_ranks; ++r)
              for (std::size_t row = first_row[r]; row < first_row[r + 1];
                   ++row)
                first[row] += first_entry[r];
            first.back() = first_entry.back();
          }
        return outcome;
      }

      void sort_rows(const SparseMatrix &matrix)
      {
        order.resize(matrix.columns.size());
        std::iota(order.begin(), order.end(), 0);
        columns.resize(order.size());
        entries.resize(order.size());
        const auto global = [&](const std::size_t i) {
          return matrix.layout->global(matrix.columns[i]);
        };
        for (std::size_t row = 0; row + 1 < matrix.first.size(); ++row)
          std::sort(order.begin() + matrix.first[row],
                    order.begin() + matrix.first[row + 1],
                    [&](const std::size_t a, const std::size_t b) {
                      return global(a) < global(b);
                    });
        for (std::size_t i = 0; i < order.size(); ++i)
          columns[i] = global(order[i]);
      }

      void broadcast_signs()
      {
        const Inertia mine       = global_inertia.value_or(Inertia());
        long          numbers[5] = {global_inertia.has_value(),
                                    static_cast<long>(mine.negative),
                                    static_cast<long>(mine.zero),
                                    static_cast<long>(mine.positive),
                                    global_sign.value_or(0)};
        MPI_Bcast(numbers, 5, MPI_LONG, 0, communicator);
        if (numbers[0] != 0)
          global_inertia = Inertia{static_cast<unsigned long>(numbers[1]),
                                   static_cast<unsigned long>(numbers[2]),
                                   static_cast<unsigned long>(numbers[3])};
        if (numbers[4] != 0)
          global_sign = static_cast<int>(numbers[4]);
      }

      /** The matrix of all ranks, on the first rank. */
      struct GatheredMatrix
      {
        explicit GatheredMatrix(const unsigned int n_rows)
          : layout(MPI_COMM_SELF, n_rows, {})
          , matrix(layout)
          , x(n_rows)
        {}

        UnknownLayout       layout;
        SparseMatrix        matrix;
        std::vector<double> x;
      };

      const std::unique_ptr<DirectSolver> solver;
      MPI_Comm                            communicator = MPI_COMM_NULL;
      unsigned int                        rank = 0, n_ranks = 1;
      /** First row and entry of each rank, and the end. */
      std::vector<std::size_t> first_row, first_entry;
      /** This rank's entries in rows sorted by global columns. */
      std::vector<std::size_t> order;
      std::vector<int>         columns;
      std::vector<double>      entries;
      std::unique_ptr<GatheredMatrix>
                             gathered; ///< on the first of several ranks
      std::optional<Inertia> global_inertia;
      std::optional<int>     global_sign; ///< of the determinant
    };
  } // namespace



  std::unique_ptr<DirectSolver>
  make_first_rank_solver(std::unique_ptr<DirectSolver> solver)
  {
    return std::make_unique<FirstRankSolver>(std::move(solver));
  }
} // namespace auxfem
