#ifndef auxfem_algebra_first_rank_solver_h
#define auxfem_algebra_first_rank_solver_h

#include <auxfem/algebra/direct_solver.h>

namespace auxfem
{
  /**
   * Lets a solver for one rank serve any number of them: brings the pattern
   * (once) and the entries (each time) to the first rank, and the solution back
   * from there. The solver sees finite entries only; its std::bad_alloc becomes
   * `out_of_memory`.
   */
  class FirstRankSolver : public DirectSolver
  {
  public:
    explicit FirstRankSolver(std::unique_ptr<DirectSolver> solver);

    FactorizationOutcome analyse(const SparseMatrix &matrix) override;
    FactorizationOutcome factorize(const SparseMatrix &matrix) override;
    void                 solve(double *x) override;

    std::optional<Inertia> inertia() const override
    {
      return inertia_of_all;
    }

    std::optional<int> determinant_sign() const override
    {
      return sign_of_all;
    }

    std::size_t         memory() const override;
    std::vector<double> pivot_entries() const override;
    void take_pivots_of(const std::vector<double> &entries) override;

  private:
    FactorizationOutcome collect_pattern(const SparseMatrix &matrix);
    void                 sort_rows(const SparseMatrix &matrix);
    void                 broadcast_signs();

    /** What the first rank has of the matrix of all. */
    struct Gathered
    {
      explicit Gathered(unsigned int n_rows);

      UnknownLayout       layout;
      SparseMatrix        matrix;
      std::vector<double> x;
    };

    const std::unique_ptr<DirectSolver> solver;
    MPI_Comm                            communicator = MPI_COMM_NULL;
    unsigned int                        rank = 0, n_ranks = 1;
    /** By rank, and the end of the last. */
    std::vector<std::size_t> first_row, first_entry;
    /** Of this rank's entries in rows sorted by global columns. */
    std::vector<std::size_t>  order;
    std::vector<int>          columns;
    std::vector<double>       entries;
    std::unique_ptr<Gathered> gathered; ///< none but on the first of several
    std::optional<Inertia>    inertia_of_all;
    std::optional<int>        sign_of_all; ///< of the determinant
  };
} // namespace auxfem

#endif
