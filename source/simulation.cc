#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/small_motions/frequency_response.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/model/scene_size.h>
#include <auxfem/output/console.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/singular_point_files.h>
#include <auxfem/reduced_cell/cell_output.h>
#include <auxfem/reduced_cell/comparison.h>
#include <auxfem/simulation.h>
#include <auxfem/study/study.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace auxfem
{
  namespace
  {
    bool is_of_modes(const Scene &scene)
    {
      return scene.analysis == Analysis::modes ||
        scene.analysis == Analysis::buckling;
    }

    /** Says what a large scene takes, before it takes it. */
    void tell_size(const Scene &scene, const MPI_Comm communicator)
    {
      const std::string text = size_text(scene);
      if (!text.empty() &&
          dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        std::cout << indented(text) << '\n' << std::endl;
    }

    /** What runs of some kinds write beside the files of simulations. */
    std::vector<std::string> files_of_all_kinds()
    {
      std::vector<std::string> all;
      for (const auto &files : {study_files(),
                                modes_files(),
                                path_contents().names(),
                                frequency_response_contents().names()})
        all.insert(all.end(), files.begin(), files.end());
      return all;
    }
  } // namespace

  RunResult run(const Scene      &scene,
                const MPI_Comm    communicator,
                const StartTimes &start,
                const FileRules  &rules)
  {
    tell_size(scene, communicator);
    if (scene.analysis == Analysis::study)
      return run_study(scene, communicator, rules);
    FileRules with_others              = rules;
    with_others.results_of_other_kinds = files_of_all_kinds();
    if (is_of_modes(scene))
      return run_modes(scene, communicator, with_others);
    if (scene.analysis == Analysis::frequency_response)
      return run_frequency_response(scene, communicator, with_others);
    if (scene.context.model == Model::reduced_cell)
      return run(scene,
                 communicator,
                 *make_cell_output(scene, start, with_others));
    return run(scene,
               communicator,
               *make_run_output(scene, communicator, start, with_others));
  }

  RunResult resume(const Scene      &scene,
                   RunToResume       former,
                   const MPI_Comm    communicator,
                   const StartTimes &start,
                   const FileRules  &rules)
  {
    tell_size(scene, communicator);
    return run(scene,
               communicator,
               *make_run_output(scene,
                                communicator,
                                start,
                                rules,
                                std::move(former.records)));
  }

  RunResult
  run(const Scene &scene, const MPI_Comm communicator, Recorder &recorder)
  {
    return analysis_of(scene).run(scene, communicator, recorder);
  }

  void check(const Scene &scene, const MPI_Comm communicator)
  {
    tell_size(scene, communicator);
    if (is_of_modes(scene))
      return check_modes(scene, communicator);
    if (scene.analysis == Analysis::frequency_response)
      return check_frequency_response(scene, communicator);
    analysis_of(scene).check(scene, communicator);
    if (scene.analysis == Analysis::study)
      check_study(scene, communicator);
  }

  void compare(const std::vector<Scene> &scenes,
               const std::string        &folder,
               const FileRules          &rules,
               const MPI_Comm            communicator)
  {
    on_first_rank(communicator,
                  [&]() { run_comparison(scenes, folder, rules); });
  }
} // namespace auxfem
