#include <auxfem/analysis/analysis.h>
#include <auxfem/model/scene_size.h>
#include <auxfem/output/console.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/simulation.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>

namespace auxfem
{
  namespace
  {
    /** Reports what a large scene takes before the run takes it. */
    void report_size(const Scene &scene, const MPI_Comm communicator)
    {
      const std::string text = size_text(scene);
      if (!text.empty() &&
          dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        std::cout << indented(text) << '\n' << std::endl;
    }

    /** Files that only analyses other than @p entry write. */
    std::vector<std::string> files_of_others(const AnalysisEntry &entry)
    {
      const std::vector<std::string> &own = entry.files;
      std::vector<std::string>        others;
      for (const AnalysisEntry &other : analysis_registry())
        for (const std::string &file : other.files)
          if (std::find(own.begin(), own.end(), file) == own.end())
            others.push_back(file);
      return others;
    }
  } // namespace

  RunResult run(const Scene         &scene,
                const MPI_Comm       communicator,
                const FolderOptions &options)
  {
    report_size(scene, communicator);
    const AnalysisEntry &analysis            = analysis_of(scene);
    FolderOptions        with_others         = options;
    with_others.rules.results_of_other_kinds = files_of_others(analysis);
    return analysis.run(scene, communicator, with_others);
  }

  RunResult
  run(const Scene &scene, const MPI_Comm communicator, Recorder &recorder)
  {
    const AnalysisEntry &analysis = analysis_of(scene);
    if (analysis.observe == nullptr)
      throw InputError("Analysis = " + analysis.name +
                       ": has no rows to record, it writes files only");
    return analysis.observe(scene, communicator, recorder);
  }

  void check(const Scene &scene, const MPI_Comm communicator)
  {
    report_size(scene, communicator);
    analysis_of(scene).check(scene, communicator);
  }
} // namespace auxfem
