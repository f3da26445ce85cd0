#include <auxfem/command_line.h>
#include <auxfem/parameters/errors.h>

namespace auxfem
{
  CommandLine read_command_line(const std::vector<std::string> &arguments)
  {
    CommandLine line;
    if (arguments.empty())
      throw InputError("No parameter file given.\n\n" + usage());
    bool       has_action = false;
    const auto choose     = [&](const CommandLine::Action action) {
      line.action = action;
      has_action  = true;
    };
    std::string output;
    const auto  set_file = [&](const std::string &file) {
      line.files.push_back(file);
    };
    for (std::size_t i = 0; i < arguments.size(); ++i)
      {
        const std::string &argument = arguments[i];
        if (argument.rfind("-", 0) != 0)
          {
            set_file(argument);
            continue;
          }
        // Accepts `--option value` and `--option=value`.
        const std::string name      = argument.substr(0, argument.find('='));
        const bool        has_value = name.size() < argument.size();
        const auto        value     = [&]() -> std::string {
          if (has_value)
            return argument.substr(name.size() + 1);
          if (i + 1 == arguments.size() || arguments[i + 1].rfind("--", 0) == 0)
            throw InputError(name + " needs a value.\n\n" + usage());
          return arguments[++i];
        };
        if (name == "--help" || name == "-h")
          choose(CommandLine::Action::help);
        else if (name == "--version")
          choose(CommandLine::Action::version);
        else if (argument == "--print-parameters")
          choose(CommandLine::Action::print_parameters);
        else if (argument == "--print-parameters=markdown")
          choose(CommandLine::Action::print_parameters_markdown);
        else if (argument == "--print-parameters=json")
          choose(CommandLine::Action::print_parameters_json);
        else if (name == "--check")
          {
            choose(CommandLine::Action::check);
            if (has_value)
              set_file(value());
          }
        else if (name == "--compare")
          {
            choose(CommandLine::Action::compare);
            if (has_value)
              set_file(value());
          }
        else if (name == "--set")
          line.overrides.push_back(value());
        else if (name == "--output")
          {
            output = value();
            if (output.empty())
              throw InputError("--output needs the name of a folder; \".\" is "
                               "the one auxfem is called from.");
          }
        else if (argument == "--force")
          line.replaces_files_of_others = true;
        else
          throw InputError("Unknown option '" + argument + "'.\n\n" + usage());
      }
    if (!has_action)
      line.action = CommandLine::Action::run;
    const bool compares   = line.action == CommandLine::Action::compare;
    const bool needs_file = line.action == CommandLine::Action::run ||
      line.action == CommandLine::Action::check || compares;
    if (needs_file && line.files.empty())
      throw InputError("No parameter file given.\n\n" + usage());
    if (!compares && line.files.size() > 1)
      throw InputError("Two parameter files given, '" + line.files[0] +
                       "' and '" + line.files[1] +
                       "'; auxfem runs one at a time.");
    if (compares)
      line.folder = output.empty() ? "output/comparison" : output;
    else if (!output.empty())
      line.overrides.push_back("Output/Directory=" + output);
    return line;
  }

  std::string usage()
  {
    return R"(Usage: auxfem [OPTIONS] FILE.prm
       mpirun -n N auxfem [OPTIONS] FILE.prm
       auxfem --compare [OPTIONS] FILE.prm [FILE.prm ...]

Simulates a lattice of beams with viscoelastic connectors as described in FILE.prm
and leaves the results in a folder: history.csv, *.pvd for ParaView, log.txt, summary.json.

  --check                  read and check FILE.prm, build the mesh, print counts; no run
  --compare                compute each FILE.prm (Model = reduced cell) with every scheme,
                           print a table, write it to DIR/comparison.csv (output/comparison)
  --set "SUB/PARAM=VALUE"  use VALUE instead of the one in FILE.prm (repeatable)
  --output DIR             folder for the results, short for --set "Output/Directory=DIR"
  --force                  replace files in DIR that auxfem has not written there
  --print-parameters       print all parameters with defaults, units and ranges
  --print-parameters=markdown, --print-parameters=json
                           the same as the page doc/parameters.md, for other programs
  --help                   print this
  --version                print the version

Exit code: 0 success, 1 wrong input, 2 failed computation, 3 results not to be used,
128 + N ended by signal N (SIGTERM or SIGINT); results until then are kept.
)";
  }
} // namespace auxfem
