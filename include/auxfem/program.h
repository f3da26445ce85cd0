#ifndef auxfem_program_h
#define auxfem_program_h

#include <auxfem/output/output_folder.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** The parsed command line. */
  struct CommandLine
  {
    enum class Action
    {
      run,
      resume,
      check,
      compare,
      print_parameters,
      print_parameters_markdown,
      print_parameters_json,
      help,
      version
    };
    Action action = Action::help;
    /** Parameter files: one, with Action::compare one or more. */
    std::vector<std::string> files;
    /** For the table of Action::compare; of the run that Action::resume goes on
     * with. */
    std::string folder;
    /** --force: files of others in that folder or a run's are replaced. */
    bool replaces_files_of_others = false;
    /** `Subsection/Parameter=value`, in the order given. */
    std::vector<std::string> overrides;
  };

  /**
   * Reads the arguments after the program's name. Throws InputError for what
   * it does not understand.
   */
  CommandLine read_command_line(const std::vector<std::string> &arguments);

  /** The text of --help. */
  std::string usage();

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
