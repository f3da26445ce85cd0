// Static star lattices solved by iteration:
//
//   mpirun -n RANKS iterative_solver DIMENSION CELLS [amg|ilu] [INERTIA]
//
// CELLS along each side; INERTIA on the diagonal (N/m). Prints iterations, wall
// and largest processor seconds of a rank, and memory of all ranks.

#include <auxfem/algebra/linear_solver_method.h>
#include <auxfem/start_up.h>

#include <deal.II/base/utilities.h>

#include <mpi.h>
#include <support/beam_lattice.h>

#include <cstdlib>
#include <ctime>
#include <iostream>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Wall time since construction. */
  class Times
  {
  public:
    explicit Times(const UnknownLayout &layout) : layout(layout)
    {
      MPI_Barrier(layout.communicator());
      wall      = MPI_Wtime();
      processor = std::clock();
    }

    void print(const std::string &what) const
    {
      const double rank_seconds =
        static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
      const double largest = layout.largest(rank_seconds);
      if (layout.rank() == 0)
        std::cout << what << ": wall " << MPI_Wtime() - wall << " s, processor "
                  << largest << " s\n";
    }

  private:
    const UnknownLayout &layout;
    double               wall;
    std::clock_t         processor;
  };

  double memory()
  {
    dealii::Utilities::System::MemoryStats stats;
    dealii::Utilities::System::get_memory_stats(stats);
    return stats.VmHWM / 1024.;
  }

  void measure(const BeamSystem &system, const SolverParameters &parameters)
  {
    const UnknownLayout                      &layout  = *system.layout;
    const bool                                is_root = layout.rank() == 0;
    const double                              before  = memory();
    const std::unique_ptr<LinearSolverMethod> solver =
      make_iterative_solver(parameters);
    solver->analyse(*system.matrix, *system.unknowns);
    for (const std::string which : {"first", "second"})
      {
        const Times factorization_time(layout);
        const bool  is_done =
          solver->factorize(*system.matrix) == FactorizationOutcome::done;
        factorization_time.print(which + " factorization");
        if (!is_done)
          return;
        const std::vector<double> b = system.loads();
        std::vector<double>       x = b;
        const Times               solution_time(layout);
        const unsigned long       n   = solver->n_iterations();
        const std::string         why = solver->solve(x.data());
        solution_time.print(which + " solution");
        const double residual = system.residual(x, b);
        if (is_root)
          std::cout << solver->n_iterations() - n << " iterations, residual "
                    << residual << ' ' << why << '\n';
      }
    const double sum = layout.sum(memory() - before);
    if (is_root)
      std::cout << layout.n_global() << " unknowns, peak memory grown by "
                << sum << " MiB\n";
  }
} // namespace

int main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  flush_denormals_to_zero();
  if (argc < 3)
    {
      std::cerr << "iterative_solver DIMENSION CELLS [amg|ilu] [INERTIA]\n";
      return 1;
    }
  const unsigned int dimension = std::atoi(argv[1]), n = std::atoi(argv[2]);
  SolverParameters   parameters;
  BeamOptions        options;
  if (argc > 3)
    parameters.preconditioner = argv[3];
  if (argc > 4)
    options.inertia = std::atof(argv[4]);
  measure(BeamSystem(dimension, star_lattice(dimension, {{n, n, n}}), options),
          parameters);
}
