#include <auxfem/output/summary.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/program.h>
#include <auxfem/start_up.h>
#include <auxfem/state/step_report.h>

#include <deal.II/base/mpi.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace
{
  using namespace auxfem;

  /** Whether the program is in the middle of a computation. */
  bool is_computing = false;

  /** A library may leave the program by exit(), above all without memory. */
  void report_exit_by_library()
  {
    if (!is_computing)
      return;
    is_computing = false;
    std::_Exit(end_all_ranks(errno == ENOMEM
                               ? out_of_memory_text()
                               : "a library has ended the program"));
  }
} // namespace

int main(int argc, char *argv[])
{
  if (const std::optional<std::string> missing = missing_instructions())
    {
      std::cerr << *missing << std::endl;
      return 2;
    }

  StartTimes start;
  start.program = seconds_since_process_start();

  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!has_mpi_launcher())
    {
      if (const std::optional<int> exit_code = answer_without_mpi(arguments))
        return *exit_code;
      prepare_mpi_for_one_process();
    }

  auto mpi_watch = std::make_unique<Stopwatch>(start.mpi);
  // The libraries get no options: PETSc would complain about unknown ones.
  int                                      n_arguments = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(n_arguments,
                                               argv,
                                               /*max_num_threads=*/1);
  mpi_watch.reset();
  start.cpu = cpu_seconds();
  flush_denormals_to_zero();

  // At the limit of a file's size a write fails instead of ending the process.
  std::signal(SIGXFSZ, SIG_IGN);
  std::atexit(report_exit_by_library);
  is_computing        = true;
  const int exit_code = run_program(arguments, start);
  is_computing        = false;
  return exit_code;
}
