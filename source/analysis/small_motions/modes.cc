#include <auxfem/analysis/analysis.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/mode_errors.h>
#include <auxfem/analysis/small_motions/mode_files.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/output/console.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/run_output.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/parameters/text.h>
#include <auxfem/state/interruption.h>
#include <auxfem/time/schemes/static.h>

#include <deal.II/base/numbers.h>

#include <sstream>
#include <variant>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

    /** Report on modes of any kind. */
    struct ReportedModes
    {
      std::string              table, closing_text;
      std::vector<Finding>     findings;
      Json                     json;
      bool                     is_counted;
      std::vector<ModePicture> pictures;
    };

    std::vector<Finding> findings(const NaturalModes &found)
    {
      std::vector<Finding> all;
      if (found.count_differs)
        all.push_back({Verdict::doubtful,
                       "The inertia of the stiffness counts another number of "
                       "modes than were found: some may be missing. Set "
                       "Modes/Number to another value.",
                       0.,
                       ""});
      unsigned long n_unstable = found.n_further_negative;
      for (const NaturalMode &mode : found.modes)
        if (mode.growth_rate() > 0 && mode.eigenvalue < found.shift)
          ++n_unstable;
      if (n_unstable == 0)
        return all;
      std::ostringstream text;
      text << "The state is unstable: its stiffness has " << n_unstable
           << " negative mode" << (n_unstable == 1 ? "" : "s")
           << ". The lattice leaves this state instead of vibrating about it.";
      all.push_back({Verdict::doubtful, text.str(), 0., ""});
      return all;
    }

    /** Text on damped modes that are not in the table. */
    std::string damped_modes_text(const NaturalModes &found)
    {
      std::ostringstream text;
      text.precision(6);
      for (const NaturalMode::Damped &damped : found.further_damped)
        text << "  Also damped: " << damped.angular_frequency / (2 * PI)
             << " Hz, ratio " << rounded_text(damped.ratio(), 6) << '\n';
      text.precision(4);
      if (found.damped_limit)
        text << "  The Krylov space contains no further damped modes below "
             << *found.damped_limit / (2 * PI)
             << " Hz; these are not counted.\n";
      else
        text << "  Damped modes may be missing: the Krylov space did not "
                "converge.\n";
      return text.str();
    }

    /** Finding on growing modes, with their numbers. */
    std::vector<Finding> findings(const ComplexModes &found)
    {
      std::ostringstream text;
      text.precision(4);
      for (unsigned int i = 0; i < found.modes.size(); ++i)
        if (const ComplexMode &mode = found.modes[i]; mode.grows())
          {
            text << (text.tellp() > 0 ? "; mode " : "mode ") << i + 1
                 << " grows with a rate of " << mode.s.real() << " 1/s";
            if (mode.swings())
              text << " at " << mode.s.imag() / (2 * PI) << " Hz, flutter";
            else
              text << ", divergence";
          }
      if (text.tellp() == 0)
        return {};
      return {{Verdict::doubtful,
               "The state is not stable: " + text.str() + '.',
               0.,
               ""}};
    }

    /** Linear theory neglects the motion before buckling. */
    std::vector<Finding> findings(const BucklingModes &found)
    {
      const double motion =
        found.modes.empty() ? 0. : found.modes.front().factor * found.motion;
      if (motion <= small_rotation)
        return {};
      std::ostringstream text;
      text.precision(2);
      text << "Before the first buckling load struts rotate by up to " << motion
           << " rad, or move by that multiple of their length, which linear "
              "theory neglects. Raise the loads in steps with Analysis = "
              "simulation and Scheme = static to find the loss of stability.";
      return {{Verdict::doubtful, text.str(), 0., ""}};
    }

    /**
     * Closing lines below the table.
     * @param if_not_counted possible defect without a count
     */
    std::string modes_closing_text(const unsigned int n,
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

    ReportedModes report_on(const NaturalModes &found, const LatticeRun &run)
    {
      ReportedModes reported{
        mode_table_text(found, run.lattice.dimension),
        modes_closing_text(found.modes.size(),
                           found.is_counted,
                           "equal frequencies may be missing.",
                           run),
        findings(found),
        json_of(found),
        found.is_counted,
        {}};
      if (run.scene.modes.damped)
        reported.closing_text =
          damped_modes_text(found) + reported.closing_text;
      for (const NaturalMode &mode : found.modes)
        reported.pictures.push_back({mode.shape, mode.angular_frequency()});
      return reported;
    }

    ReportedModes report_on(const ComplexModes &found, const LatticeRun &run)
    {
      std::ostringstream closing;
      closing
        << "  Loads follow their joints, so the stiffness is not symmetric and "
           "modes are complex, "
        << (run.scene.modes.damped ? "with all damping" : "without damping")
        << ".\n  Not counted: modes may be missing.\n  "
        << run.work().factorizations << " factorizations, "
        << run.work().linear_solutions << " solutions by "
        << run.work().linear_solver;
      ReportedModes reported{mode_table_text(found),
                             closing.str(),
                             findings(found),
                             json_of(found),
                             /*is_counted=*/false,
                             {}};
      for (const ComplexMode &mode : found.modes)
        reported.pictures.push_back(
          {mode.real, mode.s.imag(), &mode.imaginary});
      return reported;
    }

    ReportedModes report_on(const BucklingModes &found, const LatticeRun &run)
    {
      ReportedModes reported{mode_table_text(found),
                             modes_closing_text(found.modes.size(),
                                                found.is_counted,
                                                "equal factors may be missing.",
                                                run),
                             findings(found),
                             json_of(found),
                             found.is_counted,
                             {}};
      for (const BucklingMode &mode : found.modes)
        reported.pictures.push_back({mode.shape});
      return reported;
    }

    std::string relaxations_text(const Relaxations &found,
                                 const unsigned int n_requested)
    {
      std::ostringstream text;
      if (found.size() < n_requested)
        text
          << found.size() << " of " << n_requested
          << " relaxations: there are no more, or too many cluster near the "
             "time of Stiffness-proportional damping or of struts that relax.\n"
             "  ";
      text << "Relaxations are not counted.";
      return text.str();
    }

    Json json_of(const Scene                      &scene,
                 const ReportedModes              &reported,
                 const std::optional<Relaxations> &relaxing)
    {
      Json summary = {{"modes", reported.json},
                      {"are_counted", reported.is_counted},
                      {"about",
                       scene.modes.about_equilibrium ? "static equilibrium"
                                                     : "rest"}};
      if (relaxing)
        {
          summary["relaxations"]             = json_of(*relaxing);
          summary["relaxations_are_counted"] = false;
        }
      return summary;
    }

    using FoundModes = std::variant<NaturalModes, ComplexModes, BucklingModes>;

    FoundModes modes_of(LatticeRun &run)
    {
      const ModesDefinition &request = run.scene.modes;
      if (run.scene.analysis == Analysis::buckling)
        return buckling_modes_of(run, request.number, "Analysis = buckling");
      if (!has_natural_modes(run.solver(), run.solution.state))
        return complex_modes(run.solver(),
                             run.solution.state,
                             request.number,
                             request.damped ? Damping::all : Damping::none);
      NaturalModes found =
        natural_modes(run.solver(), run.solution.state, request.number);
      if (request.damped)
        add_damped_modes(run.solver(), run.solution.state, found);
      return found;
    }

    const char *values_name(const FoundModes &found)
    {
      return std::holds_alternative<BucklingModes>(found)
        ? "buckling factors"
        : "natural frequencies";
    }

    /**
     * Plan of the modes. If the scene requests it, elements are chosen for the
     * waves of the modes.
     */
    RunPlan plan_with_elements(const Scene &scene)
    {
      RunPlan plan = plan_of_modes(scene);
      if (scene.discretization.tolerance)
        choose_elements(scene.analysis == Analysis::buckling
                          ? phase_of_buckling(scene, scene.modes.number)
                          : phase_of_modes(scene, scene.modes.number),
                        noticeable_fraction,
                        plan);
      return plan;
    }

    /** Modes on the elements of a plan. */
    struct ModeComputation
    {
      /** Sets up the run. Throws InputError for errors of the scene. */
      ModeComputation(const RunPlan &plan, const MPI_Comm communicator)
        : run(plan, communicator)
      {
        run.prepare();
      }

      void find_modes()
      {
        if (run.model.plan.time.static_start)
          run.start();
        found = modes_of(run);
        errors =
          std::visit([this](
                       auto &modes) { return estimate_errors(run, modes); },
                     found);
      }

      LatticeRun run;
      FoundModes found;
      MeshErrors errors;
    };

    /** Finds the modes of @p computation, which has the elements of @p first;
     * again on finer elements until their errors meet the tolerance. */
    void
    find_on_accepted_elements(const RunPlan                    &first,
                              const MPI_Comm                    communicator,
                              std::unique_ptr<ModeComputation> &computation)
    {
      computation->find_modes();
      for (RunPlan plan = first;
           !elements_accepted(first.scene, computation->errors) &&
           refine_elements(first, computation->errors, plan);)
        {
          const Work before = computation->run.work();
          computation.reset();
          computation = std::make_unique<ModeComputation>(plan, communicator);
          computation->run.add_effort(before);
          computation->find_modes();
        }
    }
  } // namespace

  RunPlan plan_of_modes(const Scene   &scene,
                        const Analysis analysis,
                        const bool     about_equilibrium)
  {
    RunPlan plan(scene);
    plan.analysis               = analysis;
    plan.time.static_start      = about_equilibrium;
    plan.has_initial_velocities = false;
    // At rest no load acts and none changes the stiffness.
    plan.has_joint_loads = analysis == Analysis::buckling || about_equilibrium;
    if (scene.modes.damped || scene.modes.relaxations > 0)
      include_damping(plan.effects);
    if (analysis == Analysis::buckling)
      {
        plan.time.scheme             = std::make_shared<QuasiStatic>();
        plan.time.relative_tolerance = std::nullopt;
        plan.effects.inertia         = Switch::automatic;
        plan.effects.large_rotation  = Switch::on;
      }
    return plan;
  }

  RunPlan plan_of_modes(const Scene &scene)
  {
    return plan_of_modes(scene, scene.analysis, scene.modes.about_equilibrium);
  }

  RunPlan plan_with_accepted_elements(const Scene   &scene,
                                      const MPI_Comm communicator)
  {
    RunPlan plan = plan_with_elements(scene);
    if (!scene.discretization.tolerance)
      return plan;
    auto computation = std::make_unique<ModeComputation>(plan, communicator);
    find_on_accepted_elements(plan, communicator, computation);
    plan.division = computation->run.model.plan.division;
    plan.elements = computation->run.model.plan.elements;
    return plan;
  }

  BucklingLoads buckling_loads(const Scene &scene)
  {
    return {scene.modes.load_time.value_or(scene.time.end_time),
            scene.modes.reversed_loads};
  }

  BucklingModes buckling_modes_of(LatticeRun        &run,
                                  const unsigned int n,
                                  const std::string &purpose)
  {
    try
      {
        return buckling_modes(run.solver(),
                              run.solution.state,
                              buckling_loads(run.scene),
                              n);
      }
    catch (const InputError &error)
      {
        throw InputError(purpose + ": " + error.what());
      }
    catch (const Interrupted &)
      {
        throw;
      }
    catch (const ComputationError &error)
      {
        throw ComputationError(purpose + ": " + error.what());
      }
  }

  std::vector<std::string> modes_files()
  {
    return mode_contents().names();
  }

  RunResult run_modes(const Scene         &scene,
                      const MPI_Comm       communicator,
                      const FolderOptions &options)
  {
    const RunPlan first = plan_with_elements(scene);
    // Errors of the scene must not destroy the results of an earlier run.
    auto computation = std::make_unique<ModeComputation>(first, communicator);
    const DeferredSignals signals;
    RunReport             report(scene,
                     computation->run.equations,
                     options.rules,
                     mode_contents());
    find_on_accepted_elements(first, communicator, computation);
    LatticeRun         &run   = computation->run;
    const RunPlan      &plan  = run.model.plan;
    const FoundModes   &found = computation->found;
    const MeshErrors   &mesh  = computation->errors;
    const ReportedModes mode_report =
      std::visit([&](const auto &modes) { return report_on(modes, run); },
                 found);
    std::optional<Relaxations> relaxing;
    if (scene.analysis == Analysis::modes && scene.modes.relaxations > 0)
      relaxing =
        relaxations(run.solver(), run.solution.state, scene.modes.relaxations);
    RunResult result;
    result.exit_state = "completed";
    result.work       = run.work();
    result.findings   = mode_report.findings;
    for (Finding &finding : mesh_findings(plan, mesh, values_name(found)))
      result.findings.push_back(std::move(finding));

    on_first_rank(communicator, [&]() {
      std::visit(
        [&](const auto &modes) {
          write_mode_table(modes, scene.output.directory);
        },
        found);
      report.print(mode_report.table);
      report.print(mesh_text(plan, mesh));
      report.print(mode_report.closing_text);
      if (relaxing)
        {
          write_mode_table(*relaxing, scene.output.directory);
          report.print(mode_table_text(*relaxing));
          report.print("  " +
                       relaxations_text(*relaxing, scene.modes.relaxations));
        }
    });
    if (scene.output.graphics)
      for (unsigned int i = 0; i < mode_report.pictures.size(); ++i)
        {
          end_if_interrupted(communicator);
          const auto series =
            write_mode_pictures(run, mode_report.pictures[i], i + 1);
          on_first_rank(communicator, [&]() { report.claim_series(series); });
        }
    on_first_rank(communicator, [&]() {
      Json summary        = json_of(scene, mode_report, relaxing);
      summary["elements"] = json_of(plan, mesh);
      report.finish(summary, result.findings);
    });
    return result;
  }

  void check_modes(const Scene &scene, const MPI_Comm communicator)
  {
    LatticeRun run(plan_with_elements(scene), communicator);
    run.prepare();
    show_lattice(scene, run.equations);
  }

  AnalysisEntry modes_entry()
  {
    return {"modes",
            "Natural frequencies and modes of a lattice, at rest or about an "
            "equilibrium.",
            [](const Scene &scene) {
              return scene.analysis == Analysis::modes;
            },
            run_modes,
            nullptr,
            check_modes,
            modes_files()};
  }

  AnalysisEntry buckling_entry()
  {
    return {
      "buckling",
      "Load factors at which a lattice buckles, by linear theory, and buckling "
      "modes.",
      [](const Scene &scene) { return scene.analysis == Analysis::buckling; },
      run_modes,
      nullptr,
      check_modes,
      modes_files()};
  }
} // namespace auxfem
