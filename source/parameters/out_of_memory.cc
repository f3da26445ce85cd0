#include <auxfem/parameters/out_of_memory.h>

#include <deal.II/base/mpi.h>

#include <sys/resource.h>

namespace auxfem
{
  std::string out_of_memory_text()
  {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const unsigned long mebibytes = usage.ru_maxrss >> 10; // it counts in KiB
    return "out of memory on rank " +
      std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD)) +
      " of " +
      std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) +
      ", which has had up to " + std::to_string(mebibytes) +
      " MiB in use.\nTake fewer cells, a lower Discretization/Order or fewer "
      "Global refinements; or more memory (see `ulimit -v` and the limits of the "
      "batch system), more ranks on more machines, or another Solver/Type.";
  }
} // namespace auxfem
