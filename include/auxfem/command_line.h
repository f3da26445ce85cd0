#ifndef auxfem_command_line_h
#define auxfem_command_line_h

#include <string>
#include <vector>

namespace auxfem
{
  /** What the user asked for on the command line. */
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
} // namespace auxfem

#endif
