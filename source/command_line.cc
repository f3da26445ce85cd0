#include <auxfem/command_line.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <map>

#include <CLI/CLI.hpp>

namespace auxfem
{
  namespace
  {
    using Action = CommandLine::Action;

    class Usage : public CLI::Formatter
    {
    public:
      Usage()
      {
        column_width(27);
      }

      std::string make_usage(const CLI::App *, std::string) const override
      {
        return "\nUsage: auxfem [OPTIONS] FILE.prm\n"
               "       mpirun -n N auxfem [OPTIONS] FILE.prm\n"
               "       auxfem --resume DIR [--set ...]\n"
               "       auxfem --compare [OPTIONS] FILE.prm [FILE.prm ...]\n";
      }

      std::string make_option_opts(const CLI::Option *option) const override
      {
        const std::string name = option->get_type_name();
        return name.empty() ? "" : " " + name;
      }

      /** The files are in the lines above. */
      std::string make_positionals(const CLI::App *) const override
      {
        return "";
      }
    };

    /** The options, and what they leave in a CommandLine. */
    class Options
    {
    public:
      Options()
      {
        app.formatter(std::make_shared<Usage>());
        app.set_help_flag();
        app.add_option("FILE.prm", line.files);
        add_actions();
        app
          .add_option("--set",
                      line.overrides,
                      "use VALUE instead of the one in FILE.prm (repeatable)")
          ->type_name("\"SUB/PARAM=VALUE\"")
          ->allow_extra_args(false);
        output = app
                   .add_option("--output",
                               line.folder,
                               "folder for the results, short for --set "
                               "\"Output/Directory=DIR\"")
                   ->type_name("DIR");
        app.add_flag("--force",
                     line.replaces_files_of_others,
                     "replace files in DIR that auxfem has not written there");
        app.footer(
          "Exit code: 0 success, 1 wrong input, 2 failed computation, 3 results "
          "not to be\nused, 128 + N ended by signal N (SIGTERM or SIGINT); "
          "results until then are kept.");
      }

      std::string usage() const
      {
        return app.help();
      }

      CommandLine parse(std::vector<std::string> arguments)
      {
        // CLI11 takes them from the end
        std::reverse(arguments.begin(), arguments.end());
        app.allow_extras();
        try
          {
            app.parse(std::move(arguments));
          }
        catch (const CLI::ParseError &error)
          {
            refuse(std::string(error.what()) + ".");
          }
        if (!app.remaining().empty())
          refuse("Unknown option '" + app.remaining().front() + "'.");
        take_resumed_folder();
        check_files();
        take_folder();
        return line;
      }

    private:
      void add_action(const std::string &name,
                      const Action       action,
                      const std::string &description)
      {
        app.add_flag_callback(
          name,
          [this, action] { line.action = action; },
          description);
      }

      void add_actions()
      {
        line.action = Action::run;
        resume      = app
                   .add_option("--resume",
                               resumed_folder,
                               "go on with the run in DIR from its last "
                               "checkpoint")
                   ->type_name("DIR");
        add_action("--check",
                   Action::check,
                   "read and check FILE.prm, build the mesh, print counts; "
                   "no run");
        add_action("--compare",
                   Action::compare,
                   "compute each FILE.prm (Model = reduced cell) with every "
                   "scheme,\nprint a table, write it to DIR/comparison.csv "
                   "(output/comparison)");
        app
          .add_option_function<std::string>(
            "--print-parameters",
            [this](const std::string &form) { print_parameters(form); },
            "print all parameters with defaults, units and ranges;\n"
            "=markdown: as the page doc/user/parameters.md, =json: for "
            "other programs")
          ->expected(0, 1)
          ->type_name("");
        add_action("--help,-h", Action::help, "print this");
        add_action("--version", Action::version, "print the version");
      }

      void print_parameters(const std::string &form)
      {
        const std::map<std::string, Action> actions = {
          {"", Action::print_parameters},
          {"markdown", Action::print_parameters_markdown},
          {"json", Action::print_parameters_json}};
        if (actions.count(form) == 0)
          refuse("Unknown option '--print-parameters=" + form + "'.");
        line.action = actions.at(form);
      }

      bool needs_file() const
      {
        return line.action == Action::run || line.action == Action::check ||
          line.action == Action::compare;
      }

      void take_resumed_folder()
      {
        if (resume->count() == 0)
          return;
        if (line.action != Action::run)
          refuse("--resume goes on with a run; it does not go with other "
                 "actions.");
        if (!line.files.empty())
          throw InputError("--resume takes the scene from the folder of the "
                           "run; leave out '" +
                           line.files[0] + "'.");
        if (output->count() > 0)
          throw InputError("--resume goes on in the folder of the run; leave "
                           "out --output.");
        line.action = Action::resume;
        line.folder = resumed_folder;
      }

      void check_files() const
      {
        if (needs_file() && line.files.empty())
          refuse("No parameter file given.");
        if (line.action != Action::compare && line.files.size() > 1)
          throw InputError("Two parameter files given, '" + line.files[0] +
                           "' and '" + line.files[1] +
                           "'; auxfem runs one at a time.");
        if (output->count() > 0 && line.folder.empty())
          throw InputError("--output needs the name of a folder; \".\" is the "
                           "one auxfem is called from.");
      }

      /** It is an override, except for the table of a comparison. */
      void take_folder()
      {
        if (line.action == Action::compare && line.folder.empty())
          line.folder = "output/comparison";
        else if (line.action != Action::compare && output->count() > 0)
          line.overrides.push_back("Output/Directory=" + line.folder);
      }

      [[noreturn]] void refuse(const std::string &problem) const
      {
        throw InputError(problem + "\n\n" + usage());
      }

      CommandLine  line;
      CLI::App     app{"Simulates a lattice of beams with viscoelastic "
                       "connectors as described in FILE.prm\nand leaves the "
                       "results in a folder: history.csv, *.pvd for ParaView, "
                       "log.txt, summary.json."};
      CLI::Option *output = nullptr, *resume = nullptr;
      std::string  resumed_folder;
    };
  } // namespace



  CommandLine read_command_line(const std::vector<std::string> &arguments)
  {
    return Options().parse(arguments);
  }



  std::string usage()
  {
    return Options().usage();
  }
} // namespace auxfem
