#include <auxfem/command_line.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/parameters/describe.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/out_of_memory.h>
#include <auxfem/parameters/printable.h>
#include <auxfem/parameters/short_lines.h>
#include <auxfem/program.h>
#include <auxfem/reduced_cell/comparison.h>
#include <auxfem/resumption.h>
#include <auxfem/scene/scene_subsections.h>
#include <auxfem/simulation.h>
#include <auxfem/time/interruption.h>
#include <auxfem/version.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <new>

namespace auxfem
{
  namespace
  {
    /** What is printed for actions that compute nothing. */
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
      RunToResume run = find_run_to_resume(line.folder, MPI_COMM_WORLD);
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
