#include <auxfem/analysis/lattice_analysis.h>
#include <auxfem/analysis/small_motions/damped_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/mode_files.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/run_report.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/interruption.h>
#include <auxfem/time/static.h>

#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** What is told of modes, of whatever kind they are. */
    struct ToldModes
    {
      std::string              table, closing_words;
      std::vector<Finding>     findings;
      Json                     json;
      bool                     is_counted;
      std::vector<ModePicture> pictures;
    };

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

    /** Linear theory leaves out how far the lattice moves until it buckles. */
    std::vector<Finding> findings(const BucklingModes &found)
    {
      constexpr double small = 0.1;
      const double     motion =
        found.modes.empty() ? 0. : found.modes.front().factor * found.motion;
      if (motion <= small)
        return {};
      std::ostringstream text;
      text.precision(2);
      text << "Until the first factor struts turn by up to " << motion
           << " rad, or move by as much of their length, which linear theory "
              "leaves out. Raise the loads in steps with Analysis = simulation "
              "and Scheme = static, and see where stability is lost.";
      return {{Verdict::doubtful, text.str(), 0., ""}};
    }

    /** What the table does not tell.
     * @param if_not_counted what may be wrong then */
    std::string closing_words(const unsigned int n,
                              const bool         is_counted,
                              const std::string &if_not_counted,
                              const LatticeRun  &run)
    {
      std::ostringstream text;
      if (n < run.scene.modes.number)
        text << "  " << n << " of " << run.scene.modes.number
             << " modes: there are no more with this mesh. Raise "
                "Discretization/Order or Discretization/Global refinements.\n";
      text << "  "
           << (is_counted ? "None is missing below the last, by the inertia of "
                            "the stiffness."
                          : "Not counted: " + if_not_counted)
           << "\n  " << run.work().factorizations << " factorizations, "
           << run.work().linear_solutions << " solutions by "
           << run.work().linear_solver;
      return text.str();
    }

    ToldModes told(const NaturalModes &found, const LatticeRun &run)
    {
      ToldModes told{mode_table_text(found, run.lattice.dimension),
                     closing_words(found.modes.size(),
                                   found.is_counted,
                                   "equal frequencies may be missing.",
                                   run),
                     findings(found),
                     json_of(found),
                     found.is_counted,
                     {}};
      for (const NaturalMode &mode : found.modes)
        told.pictures.push_back({mode.shape, mode.angular_frequency()});
      return told;
    }

    ToldModes told(const BucklingModes &found, const LatticeRun &run)
    {
      ToldModes told{mode_table_text(found),
                     closing_words(found.modes.size(),
                                   found.is_counted,
                                   "equal factors may be missing.",
                                   run),
                     findings(found),
                     json_of(found),
                     found.is_counted,
                     {}};
      for (const BucklingMode &mode : found.modes)
        told.pictures.push_back({mode.shape});
      return told;
    }

    Json json_of(const Scene &scene, const ToldModes &told)
    {
      return {{"modes", told.json},
              {"are_counted", told.is_counted},
              {"about",
               scene.modes.about_equilibrium ? "static equilibrium" : "rest"}};
    }

    /**
     * Computes, prints and writes modes.
     * @param compute finds them in the state of a LatticeRun
     */
    template <class Compute>
    RunResult run_modes_by(const Compute   &compute,
                           const Scene     &scene,
                           const MPI_Comm   communicator,
                           const FileRules &rules)
    {
      LatticeRun run(scene, communicator);
      // Mistakes it finds must not cost the results of an earlier run.
      run.prepare();
      const SignalsWaitForStep signals;
      RunReport report(scene, run.equations, rules, mode_contents());
      if (scene.time.static_start)
        run.start();
      const auto      found      = compute(run);
      const ToldModes told_modes = told(found, run);
      RunResult       result;
      result.exit_state = "completed";
      result.work       = run.work();
      result.findings   = told_modes.findings;

      on_first_rank(communicator, [&]() {
        write_mode_table(found, scene.output.directory);
        report.print(told_modes.table);
        report.print(told_modes.closing_words);
      });
      if (scene.output.graphics)
        for (unsigned int i = 0; i < told_modes.pictures.size(); ++i)
          {
            end_if_interrupted(communicator);
            const auto series =
              write_mode_pictures(run, told_modes.pictures[i], i + 1);
            on_first_rank(communicator, [&]() { report.claim_series(series); });
          }
      on_first_rank(communicator, [&]() {
        report.finish(json_of(scene, told_modes), result.findings);
      });
      return result;
    }
  } // namespace

  Scene scene_of_modes(Scene scene)
  {
    scene.time.static_start = scene.modes.about_equilibrium;
    scene.initial_velocities.clear();
    if (scene.modes.damped)
      include_damping(scene);
    if (scene.analysis == Analysis::buckling)
      {
        scene.time.scheme             = std::make_shared<QuasiStatic>();
        scene.time.relative_tolerance = std::nullopt;
        scene.effects.inertia         = Switch::automatic;
        scene.effects.large_rotation  = Switch::on;
      }
    return scene;
  }

  BucklingModes buckling_modes_of(LatticeRun &run)
  {
    const ModesDefinition &modes = run.scene.modes;
    return buckling_modes(run.solver(),
                          run.solution.state,
                          {modes.load_time.value_or(run.scene.time.end_time),
                           modes.reversed_loads},
                          modes.number);
  }

  std::vector<std::string> modes_files()
  {
    return mode_contents().names();
  }

  RunResult run_modes(const Scene     &given,
                      const MPI_Comm   communicator,
                      const FileRules &rules)
  {
    const Scene scene = scene_of_modes(given);
    if (scene.analysis == Analysis::buckling)
      return run_modes_by(buckling_modes_of, scene, communicator, rules);
    return run_modes_by(
      [](LatticeRun &run) {
        NaturalModes found = natural_modes(run.solver(),
                                           run.solution.state,
                                           run.scene.modes.number);
        if (run.scene.modes.damped)
          add_damped_modes(run.solver(), run.solution.state, found);
        return found;
      },
      scene,
      communicator,
      rules);
  }

  void check_modes(const Scene &given, const MPI_Comm communicator)
  {
    const Scene scene = scene_of_modes(given);
    LatticeRun  run(scene, communicator);
    run.prepare();
    print_overview(scene, run.equations);
  }
} // namespace auxfem
