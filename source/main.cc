#include <auxfem/command_line.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/simulation.h>
#include <auxfem/version.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <iostream>

namespace
{
  using namespace auxfem;

  void execute(const CommandLine &line, const bool speaks)
  {
    switch (line.action)
      {
        case CommandLine::Action::help:
          if (speaks)
            std::cout << usage();
          break;
        case CommandLine::Action::version:
          if (speaks)
            std::cout << "auxfem " << version << '\n';
          break;
        case CommandLine::Action::print_parameters:
          if (speaks)
            std::cout << describe_all_parameters();
          break;
        case CommandLine::Action::print_parameters_markdown:
          if (speaks)
            std::cout << describe_all_parameters_markdown();
          break;
        case CommandLine::Action::check:
          check(read_scene(line.files[0], line.overrides), MPI_COMM_WORLD);
          break;
        case CommandLine::Action::compare:
          {
            std::vector<Scene> scenes;
            for (const std::string &file : line.files)
              scenes.push_back(read_scene(file, line.overrides));
            compare(scenes, line.folder, MPI_COMM_WORLD);
            break;
          }
        case CommandLine::Action::run:
          run(read_scene(line.files[0], line.overrides), MPI_COMM_WORLD);
          break;
      }
  }
} // namespace

int main(int argc, char *argv[])
{
  const std::vector<std::string>           arguments(argv + 1, argv + argc);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc,
                                               argv,
                                               /*max_num_threads=*/1);
  const bool                               speaks =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const auto report = [speaks](const std::string &message) {
    if (speaks)
      std::cerr << "\nauxfem: " << message << std::endl;
  };
  // It may be on this rank only: the others must not wait for it.
  const auto report_internal = [](const std::string &what) {
    std::cerr << "\nauxfem: internal error, please report it together with the "
                 "parameter file:\n"
              << what << std::endl;
    if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
      MPI_Abort(MPI_COMM_WORLD, 2);
    return 2;
  };
  try
    {
      execute(read_command_line(arguments), speaks);
      return 0;
    }
  catch (const InputError &error)
    {
      report(error.what());
      return 1;
    }
  catch (const ComputationError &error)
    {
      report(error.what());
      return 2;
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
