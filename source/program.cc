#include <auxfem/analysis/reduced_cell/cell_run.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/text.h>
#include <auxfem/program.h>
#include <auxfem/scene/scene.h>
#include <auxfem/simulation.h>
#include <auxfem/state/interruption.h>
#include <auxfem/version.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <new>

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

      /** The lines above name the files. */
      std::string make_positionals(const CLI::App *) const override
      {
        return "";
      }
    };

    /** The options, which fill a CommandLine. */
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
        app
          .add_option_function<std::vector<std::string>>(
            "--sweep",
            [this](const std::vector<std::string> &entries) {
              for (const std::string &entry : entries)
                line.overrides.push_back("Sweep/" + entry);
            },
            "run all VALUES, e.g. 50:80:5 deg (repeatable)")
          ->type_name("\"PARAM=VALUES\"")
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
                   "read and check FILE.prm, print counts and size, write "
                   "DIR/lattice.vtu");
        add_action("--compare",
                   Action::compare,
                   "compute each FILE.prm (Model = reduced cell) with every "
                   "scheme, write a table");
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

  namespace
  {
    /** The text printed by actions that compute nothing. */
    std::optional<std::string> answer(const CommandLine::Action action)
    {
      switch (action)
        {
          case CommandLine::Action::help:
            return usage();
          case CommandLine::Action::version:
            return "auxfem " + std::string(version) + '\n';
          case CommandLine::Action::print_parameters:
            return describe_parameters(scene_schemas());
          case CommandLine::Action::print_parameters_markdown:
            return describe_parameters_markdown(scene_schemas());
          case CommandLine::Action::print_parameters_json:
            return describe_parameters_json(scene_schemas());
          case CommandLine::Action::resume:
          case CommandLine::Action::check:
          case CommandLine::Action::compare:
          case CommandLine::Action::run:
            break;
        }
      return std::nullopt;
    }

    void report(const std::string &message)
    {
      std::cerr << "\nauxfem: " << with_short_lines(message) << std::endl;
    }

    /** Exit code of a run that has ended. */
    int exit_code(const Scene &scene, const RunResult &result)
    {
      constexpr int unreliable = 3;
      return scene.output.verdict_fails &&
          verdict_of(result.findings) == Verdict::not_to_be_used
        ? unreliable
        : 0;
    }

    int go_on(const CommandLine &line,
              const FileRules   &rules,
              const bool         speaks,
              const StartTimes  &start)
    {
      RestartedRun run = find_run_to_resume(line.folder, MPI_COMM_WORLD);
      if (speaks && !run.warning.empty())
        report("warning: " + run.warning);
      const Scene scene = scene_to_resume(run, line.overrides);
      return exit_code(scene,
                       auxfem::run(scene,
                                   MPI_COMM_WORLD,
                                   {rules, start, std::move(run.records)}));
    }

    int
    execute(const CommandLine &line, const bool speaks, const StartTimes &start)
    {
      if (const auto text = answer(line.action))
        {
          if (speaks)
            std::cout << *text;
          return 0;
        }
      FileRules          rules;
      std::vector<Scene> scenes;
      for (const std::string &file : line.files)
        scenes.push_back(read_scene(file, line.overrides));
      rules.replaces_files_of_others = line.replaces_files_of_others;
      if (line.action == CommandLine::Action::resume)
        return go_on(line, rules, speaks, start);
      if (line.action == CommandLine::Action::compare)
        on_first_rank(MPI_COMM_WORLD,
                      [&]() { run_comparison(scenes, line.folder, rules); });
      else if (line.action == CommandLine::Action::check)
        check(scenes[0], MPI_COMM_WORLD);
      else
        return exit_code(scenes[0],
                         run(scenes[0], MPI_COMM_WORLD, {rules, start}));
      return 0;
    }
  } // namespace

  std::optional<int>
  answer_without_mpi(const std::vector<std::string> &arguments)
  {
    const PrintableStream output(std::cout), errors(std::cerr);
    try
      {
        const auto text = answer(read_command_line(arguments).action);
        if (!text)
          return std::nullopt;
        std::cout << *text;
        return 0;
      }
    catch (const InputError &error)
      {
        report(error.what());
        return 1;
      }
  }

  int end_all_ranks(const std::string &message)
  {
    report(message);
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      MPI_Abort(MPI_COMM_WORLD, 2);
    return 2;
  }

  int run_program(const std::vector<std::string> &arguments,
                  const StartTimes               &start)
  {
    // Titles, names and files that are quoted may hold escape sequences.
    const PrintableStream output(std::cout), errors(std::cerr);
    const bool            speaks =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    const auto report_internal = [](const std::string &what) {
      return end_all_ranks("internal error, please report it together with the "
                           "parameter file:\n" +
                           what);
    };
    try
      {
        return execute(read_command_line(arguments), speaks, start);
      }
    catch (const InputError &error)
      {
        if (speaks)
          report(error.what());
        return 1;
      }
    catch (const Interrupted &interruption)
      {
        if (speaks)
          report(interruption.what());
        return 128 + interruption.signal();
      }
    catch (const ComputationError &error)
      {
        if (speaks)
          report(error.what());
        return 2;
      }
    catch (const std::bad_alloc &)
      {
        return end_all_ranks(out_of_memory_text());
      }
    catch (const std::exception &error)
      {
        return report_internal(error.what());
      }
    catch (...)
      {
        return report_internal("an exception of Trilinos or another library");
      }
  }
} // namespace auxfem
