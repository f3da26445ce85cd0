#include <auxfem/command_line.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/out_of_memory.h>
#include <auxfem/parameters/short_lines.h>
#include <auxfem/simulation.h>
#include <auxfem/start_up.h>
#include <auxfem/time/interruption.h>
#include <auxfem/time/stopwatch.h>
#include <auxfem/version.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <new>
#include <optional>

namespace
{
  using namespace auxfem;

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
          return describe_all_parameters();
        case CommandLine::Action::print_parameters_markdown:
          return describe_all_parameters_markdown();
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

  /**
   * Answers what needs no computation, and complains of a command line that is
   * not understood: the exit code then, nothing if there is something to do.
   */
  std::optional<int>
  answer_without_mpi(const std::vector<std::string> &arguments)
  {
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

  /** Reports what the other ranks may know nothing of, and ends them. */
  int end_all_ranks(const std::string &message)
  {
    report(message);
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      MPI_Abort(MPI_COMM_WORLD, 2);
    return 2;
  }

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

  int execute(const CommandLine &line,
              const bool         speaks,
              const StartTimes  &start)
  {
    constexpr int unreliable = 3;
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
    if (line.action == CommandLine::Action::compare)
      compare(scenes, line.folder, rules, MPI_COMM_WORLD);
    else if (line.action == CommandLine::Action::check)
      check(scenes[0], MPI_COMM_WORLD);
    else
      {
        const RunResult result = run(scenes[0], MPI_COMM_WORLD, start, rules);
        if (scenes[0].output.verdict_fails &&
            verdict_of(result.findings) == Verdict::not_to_be_used)
          return unreliable;
      }
    return 0;
  }

  int execute_on_ranks(const std::vector<std::string> &arguments,
                       const StartTimes               &start)
  {
    const bool speaks =
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
} // namespace

int main(int argc, char *argv[])
{
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
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc,
                                               argv,
                                               /*max_num_threads=*/1);
  mpi_watch.reset();
  start.cpu = cpu_seconds();
  take_denormal_numbers_as_zero();

  // A file that may not grow is a failed write, not the end without a word.
  std::signal(SIGXFSZ, SIG_IGN);
  std::atexit(report_exit_by_library);
  is_computing        = true;
  const int exit_code = execute_on_ranks(arguments, start);
  is_computing        = false;
  return exit_code;
}
