#include <auxfem/analysis/lattice_analysis.h>
#include <auxfem/analysis/mode_files.h>
#include <auxfem/analysis/modes.h>
#include <auxfem/output/console.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/notes.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/interruption.h>

#include <iostream>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** The scene at t = 0 at rest, as it is looked at. */
    Scene still(Scene scene)
    {
      scene.time.static_start = scene.modes.about_equilibrium;
      scene.initial_velocities.clear();
      return scene;
    }

    std::vector<Finding> findings(const NaturalModes &found)
    {
      unsigned long n_unstable = found.n_further_negative;
      for (const NaturalMode &mode : found.modes)
        if (mode.growth_rate() > 0 && mode.eigenvalue < found.shift)
          ++n_unstable;
      if (n_unstable == 0)
        return {};
      std::ostringstream text;
      text << "The state is unstable: its stiffness has " << n_unstable
           << " negative mode" << (n_unstable == 1 ? "" : "s")
           << ". It does not vibrate but leaves this state.";
      return {{Verdict::doubtful, text.str(), 0., ""}};
    }

    /** What the table does not tell. */
    std::string closing_words(const NaturalModes &found,
                              const Scene        &scene,
                              const Work         &work)
    {
      std::ostringstream text;
      if (found.modes.size() < scene.modes.number)
        text << "  " << found.modes.size() << " of " << scene.modes.number
             << " modes: the mesh has too few unknowns for more. Raise "
                "Discretization/Order or Discretization/Global refinements.\n";
      text << "  "
           << (found.is_counted
                 ? "None is missing below the last, by the inertia of the "
                   "stiffness."
                 : "Not counted: equal frequencies may be missing.")
           << "\n  " << work.factorizations << " factorizations, "
           << work.linear_solutions << " solutions by " << work.linear_solver;
      return text.str();
    }

    std::string summary_text(const Scene                &scene,
                             const NaturalModes         &found,
                             const std::vector<Finding> &of_run,
                             const LatticeModel         &model)
    {
      Json json = json_of_run(scene, "completed", 0);
      add_verdict(json, of_run);
      json["modes"]       = json_of(found);
      json["are_counted"] = found.is_counted;
      json["about"] =
        scene.modes.about_equilibrium ? "static equilibrium" : "rest";
      const std::vector<std::string> notes = notes_on(scene, model);
      if (!notes.empty())
        json["notes"] = notes;
      return json.dump(2) + '\n';
    }
  } // namespace

  std::vector<std::string> modes_files()
  {
    const FolderContents     contents = mode_contents();
    std::vector<std::string> files    = contents.files;
    for (const std::string &series : contents.series)
      files.push_back(series + ".pvd");
    return files;
  }

  RunResult run_modes(const Scene     &given,
                      const MPI_Comm   communicator,
                      const FileRules &rules)
  {
    const Scene scene = still(given);
    LatticeRun  run(scene, communicator);
    // Mistakes it finds must not cost the results of an earlier run.
    run.prepare();
    const SignalsWaitForStep signals;
    std::optional<RunFolder> files;
    std::optional<Console>   console;
    const Counts             counts = count(run.equations);
    on_first_rank(communicator, [&]() {
      files.emplace(scene, rules, mode_contents());
      console.emplace(std::cout,
                      terminal_width(
                        dealii::Utilities::MPI::n_mpi_processes(communicator)),
                      files->log());
      console->print(overview_text(scene,
                                   counts,
                                   run.model.simulated.decisions,
                                   notes_on(scene, run.model)) +
                     '\n');
    });
    if (scene.time.static_start)
      run.start();
    const NaturalModes found =
      natural_modes(run.solver(), run.solution.state, scene.modes.number);
    RunResult result;
    result.exit_state = "completed";
    result.work       = run.work();
    result.findings   = findings(found);

    const std::string &folder = scene.output.directory;
    on_first_rank(communicator, [&]() {
      write_mode_table(found, folder);
      console->print(mode_table_text(found, scene.context.dimension));
      console->print(closing_words(found, scene, run.work()));
    });
    if (scene.output.graphics)
      for (unsigned int i = 0; i < found.modes.size(); ++i)
        {
          end_if_interrupted(communicator);
          const auto series = write_mode_pictures(run, found.modes[i], i + 1);
          on_first_rank(communicator, [&]() {
            for (const std::string &name : series)
              files->claim_series(name);
          });
        }
    on_first_rank(communicator, [&]() {
      replace_file(folder + "/summary.json",
                   summary_text(scene, found, result.findings, run.model));
      console->print("  Results are in " + folder);
      console->print(verdict_text(result.findings));
    });
    return result;
  }

  void check_modes(const Scene &given, const MPI_Comm communicator)
  {
    const Scene scene = still(given);
    LatticeRun  run(scene, communicator);
    run.prepare();
    print_overview(scene, run.equations);
  }
} // namespace auxfem
