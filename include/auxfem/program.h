#ifndef auxfem_program_h
#define auxfem_program_h

#include <auxfem/output/start_times.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Answers on standard output what needs no computation, and complains on
   * standard error of @p arguments (those after the program's name) that are not
   * understood: the exit code then, nothing if there is something to do. Needs
   * no MPI.
   */
  std::optional<int>
  answer_without_mpi(const std::vector<std::string> &arguments);

  /**
   * The program between the start of MPI and its end: does what @p arguments
   * ask for, reports what goes wrong on standard error, and returns the exit
   * code. Throws nothing. Collective.
   * @param start of this rank, for the summary.
   */
  int run_program(const std::vector<std::string> &arguments,
                  const StartTimes               &start);

  /**
   * Reports what the other ranks may know nothing of, and ends them; returns
   * the exit code if there are none.
   */
  int end_all_ranks(const std::string &message);
} // namespace auxfem

#endif
