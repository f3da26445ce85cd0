#include <auxfem/analysis/analysis.h>
#include <auxfem/optimization/optimization.h>
#include <auxfem/optimization/optimization_report.h>
#include <auxfem/optimization/refined_designs.h>
#include <auxfem/output/console.h>
#include <auxfem/output/overview.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <iostream>
#include <limits>

namespace auxfem
{
  namespace
  {
    const std::string designs_folder = "/designs";

    /** Throws InputError if a bound of a variable, or a value between them,
     * makes no valid scene. */
    void check_bounds(const Scene &scene, const DesignPoint &first)
    {
      for (std::size_t v = 0; v < first.size(); ++v)
        // The part between is no simple fraction: whole numbers do not vary.
        for (const double part : {0., 1., 0.618})
          {
            DesignPoint point(first);
            point[v] = part;
            try
              {
                scene_of_case(scene,
                              case_of_design(scene,
                                             point,
                                             scene.output.directory)
                                .overrides);
              }
            catch (const InputError &error)
              {
                const DesignVariable &variable =
                  scene.optimization.variables[v];
                throw InputError("Design variables/" + variable.path +
                                 ": a value within the bounds makes no valid "
                                 "scene, " +
                                 variable.text_at(part) + ":\n" + error.what());
              }
          }
    }

    /** Runs @p first, the design of the scene itself, whose goals are not known
     * yet. Throws InputError if its input is wrong, ComputationError if its run
     * fails. */
    CaseResults first_results(const Scene     &scene,
                              Design          &first,
                              const MPI_Comm   communicator,
                              const FileRules &rules)
    {
      const SceneCase one = case_of_design(scene, first.point, first.folder);
      const CaseEnd   end =
        run_cases(scene,
                  {one},
                  communicator,
                  rules,
                  [](std::size_t, const CaseEnd &, int) {})[0];
      const CaseResults results =
        results_on_all_ranks(scene, one, end, communicator);
      first.verdict    = results.verdict;
      first.exit_state = results.exit_state;
      first.is_reused  = end.is_reused;
      if (!results.results.empty() && results.exit_state == "completed")
        return results;
      const std::string text =
        "The run with the values of the scene, from which the search begins, "
        "fails:\n" +
        (end.failure.empty() ? results.exit_state : end.failure);
      if (end.is_mistake)
        throw InputError(text);
      throw ComputationError(text + "\nGive values with which it succeeds.");
    }

    /** Searches of @p optimization for objective @p objective. */
    void add_searches(const Scene             &scene,
                      const DesignPoint       &first,
                      const unsigned int       objective,
                      std::vector<SearchTask> &tasks)
    {
      const OptimizationDefinition &optimization = scene.optimization;
      std::vector<DesignPoint>      starts       = {first};
      for (DesignPoint &point : latin_hypercube(optimization.n_starts - 1,
                                                first.size(),
                                                optimization.seed))
        starts.push_back(std::move(point));
      for (DesignPoint &start : starts)
        {
          SearchTask task{std::move(start), objective};
          task.folder = numbered_folder(scene.output.directory + designs_folder,
                                        tasks.size() + 1);
          tasks.push_back(task);
        }
    }

    Design best_of(const std::vector<Design> &designs,
                   const Goals               &goals,
                   const double               tolerance,
                   const unsigned int         objective)
    {
      return *std::min_element(
        designs.begin(),
        designs.end(),
        [&](const Design &one, const Design &other) {
          return is_better(one, other, goals, tolerance, objective);
        });
    }

    /** Searches for the least first objective under limits of the second one,
     * equally spaced between the ends of the front (the method of the
     * epsilon constraint, Haimes, Lasdon and Wismer, 1971, IEEE Transactions on
     * Systems, Man, and Cybernetics 1, 296). */
    std::vector<SearchTask> inner_searches(const Scene               &scene,
                                           const std::vector<Design> &designs,
                                           const Goals               &goals,
                                           const std::size_t          n_before)
    {
      const double tolerance = scene.optimization.constraint_tolerance();
      const Design ends[2]   = {best_of(designs, goals, tolerance, 0),
                                best_of(designs, goals, tolerance, 1)};
      if (!ends[0].is_usable() || !ends[1].is_usable())
        return {};
      const double highest            = goals.merit(*ends[0].goals, 1),
                   lowest             = goals.merit(*ends[1].goals, 1);
      const unsigned int      n_parts = scene.optimization.n_front_points - 1;
      std::vector<SearchTask> tasks;
      for (unsigned int i = 1; i < n_parts; ++i)
        {
          SearchTask task;
          task.other_merit = highest + (lowest - highest) * i / n_parts;
          Design start     = ends[1];
          for (const Design &design : designs)
            if (design.is_usable() &&
                goals.merit(*design.goals, 1) <= *task.other_merit &&
                is_better(design, start, goals, tolerance))
              start = design;
          task.start  = start.point;
          task.folder = numbered_folder(scene.output.directory + designs_folder,
                                        n_before + i);
          tasks.push_back(task);
        }
      return tasks;
    }

    /** Usable designs within constraints that no other one surpasses. */
    std::vector<Design> front_of(const std::vector<Design> &designs,
                                 const Goals               &goals)
    {
      std::vector<Design> front;
      for (const Design &design : designs)
        if (design.is_usable() && goals.meets_constraints(*design.goals))
          front.push_back(design);
      const auto merit = [&goals](const Design &design, const unsigned int i) {
        return goals.merit(*design.goals, i);
      };
      std::stable_sort(front.begin(),
                       front.end(),
                       [&](const Design &one, const Design &other) {
                         return std::make_pair(merit(one, 0), merit(one, 1)) <
                           std::make_pair(merit(other, 0), merit(other, 1));
                       });
      double least = std::numeric_limits<double>::infinity();
      front.erase(std::remove_if(front.begin(),
                                 front.end(),
                                 [&](const Design &design) {
                                   const bool is_surpassed =
                                     merit(design, 1) >= least;
                                   least = std::min(least, merit(design, 1));
                                   return is_surpassed;
                                 }),
                  front.end());
      return front;
    }

    /** The optimization of a scene while it runs. */
    class Optimization
    {
    public:
      Optimization(const Scene     &scene,
                   const MPI_Comm   communicator,
                   const FileRules &rules,
                   Console         *console)
        : scene(scene)
        , communicator(communicator)
        , rules(rules)
        , console(console)
      {
        result.first.point  = first_design(scene);
        result.first.folder = subfolder("/first");
        const CaseResults found =
          first_results(scene, result.first, communicator, rules);
        goals.emplace(scene, found.results);
        result.first.goals = goals->first();
        result.designs     = {result.first};
        print(result.first);
        if (console != nullptr)
          for (const std::string &note : notes_on_signs(*goals))
            console->print("  Note: " + note);
      }

      void run()
      {
        const unsigned int n_objectives = scene.optimization.objectives.size();
        std::vector<SearchTask> tasks;
        for (unsigned int i = 0; i < n_objectives; ++i)
          add_searches(scene, result.first.point, i, tasks);
        search(tasks);
        if (n_objectives == 2)
          {
            search(inner_searches(scene, result.designs, *goals, tasks.size()));
            result.front = front_of(result.designs, *goals);
          }
        choose_best();
        refine();
        differentiate();
      }

      /** On the first rank: takes its designs of a search that a signal has
       * ended. */
      void end_early()
      {
        result.designs.insert(result.designs.end(),
                              latest.begin(),
                              latest.end());
        choose_best();
      }

      OptimizationResult   result;
      std::optional<Goals> goals;

    private:
      std::string subfolder(const std::string &name) const
      {
        return scene.output.directory + designs_folder + name;
      }

      void print(const Design &design)
      {
        if (console != nullptr)
          console->print("  " + line_of(scene, *goals, design));
      }

      void choose_best()
      {
        result.best = best_of(result.designs,
                              *goals,
                              scene.optimization.constraint_tolerance(),
                              0);
      }

      void search(const std::vector<SearchTask> &tasks)
      {
        const auto listener = [this](const Design &design) {
          print(design);
          latest.push_back(design);
        };
        const std::vector<SearchResult> results = run_searches(scene,
                                                               tasks,
                                                               *goals,
                                                               communicator,
                                                               rules,
                                                               result.designs,
                                                               listener);
        latest.clear();
        for (const SearchResult &found : results)
          {
            result.is_cut_short = result.is_cut_short || found.is_cut_short;
            result.designs.insert(result.designs.end(),
                                  found.designs.begin(),
                                  found.designs.end());
          }
      }

      void refine()
      {
        std::vector<Design> designs = {result.first};
        if (result.best.point != result.first.point)
          designs.push_back(result.best);
        const auto refined   = refined_goals(scene,
                                           designs,
                                           *goals,
                                           communicator,
                                           rules,
                                           subfolder("/refined"));
        result.refined_first = refined.front();
        result.refined_best  = refined.back();
      }

      void differentiate()
      {
        if (!scene.optimization.has_sensitivities || !result.best.is_usable())
          return;
        DesignRuns runs(scene,
                        *goals,
                        communicator,
                        rules,
                        subfolder("/differences"),
                        {result.best},
                        [](const Design &) {});
        result.sensitivities =
          sensitivities_at(runs, scene.optimization, result.best);
        result.neighbours = runs.designs();
      }

      const Scene     &scene;
      const MPI_Comm   communicator;
      const FileRules &rules;
      Console *const   console;
      /** Designs of the present searches on the first rank. */
      std::vector<Design> latest;
    };

    std::string overview(const Scene &scene)
    {
      std::string text = heading_text(scene) + "\n\n  Optimization of " +
        std::to_string(scene.optimization.variables.size()) +
        " design variables, Analysis = " + name_of(scene.analysis) + '\n';
      for (const DesignVariable &variable : scene.optimization.variables)
        text += "    " + variable.path + " from " + variable.text_at(0) +
          " to " + variable.text_at(1) +
          (variable.is_logarithmic ? ", logarithmic\n" : "\n");
      for (const Objective &objective : scene.optimization.objectives)
        text += "    " + objective.text() + '\n';
      for (const ResultLimit &limit : scene.optimization.limits)
        text += "    with " + limit.text +
          (limit.unit.empty() ? "" : " (" + limit.limit + " in SI)") + '\n';
      text += "    by";
      for (const SearchMethod &method :
           chosen_methods(scene.optimization,
                          !scene.optimization.limits.empty()))
        text += " " + method.name;
      return text + '\n';
    }

    /** Mistakes that need no run. */
    void check_input(const Scene &scene)
    {
      chosen_methods(scene.optimization, !scene.optimization.limits.empty());
      check_bounds(scene, first_design(scene));
    }
  } // namespace

  RunResult run_optimization(const Scene         &scene,
                             const MPI_Comm       communicator,
                             const FolderOptions &options)
  {
    // Errors of the scene must not destroy the results of an earlier run.
    check_input(scene);
    const DeferredSignals    signals;
    std::optional<RunFolder> files;
    std::optional<Console>   console;
    on_first_rank(communicator, [&]() {
      files.emplace(scene,
                    options.rules,
                    FolderContents{optimization_files(), {}});
      console.emplace(std::cout,
                      terminal_width(
                        dealii::Utilities::MPI::n_mpi_processes(communicator)),
                      files->log());
      console->print(overview(scene));
      make_output_subfolder(scene.output.directory + designs_folder);
    });
    RunResult                   result;
    std::optional<Optimization> optimization;
    try
      {
        optimization.emplace(scene,
                             communicator,
                             options.rules,
                             console ? &*console : nullptr);
        optimization->run();
        result.findings =
          findings_of(scene, optimization->result, *optimization->goals);
        on_first_rank(communicator, [&]() {
          write_optimization(scene,
                             optimization->result,
                             *optimization->goals,
                             result.findings);
          console->print(
            closing_text(scene, optimization->result, *optimization->goals));
          console->print(verdict_text(result.findings));
        });
      }
    catch (const Interrupted &)
      {
        if (console && optimization)
          {
            optimization->end_early();
            write_designs(scene, optimization->result, *optimization->goals);
          }
        if (console)
          console->print(std::string("Interrupted.") +
                         (optimization ? " The designs so far are in " +
                              scene.output.directory + "/" + design_table_file +
                              ", the best of them " + best_scene_file + "."
                                       : "") +
                         " Run the same optimization again to continue.");
        throw;
      }
    result.exit_state = "completed";
    return result;
  }

  AnalysisEntry optimization_entry()
  {
    return {"optimization",
            "Parameters at which the results of any analysis are best.",
            [](const Scene &scene) { return scene.optimization.is_given(); },
            run_optimization,
            nullptr,
            [](const Scene &scene, const MPI_Comm communicator) {
              check_input(scene);
              const Scene first =
                scene_of_case(scene,
                              case_of_design(scene,
                                             first_design(scene),
                                             scene.output.directory)
                                .overrides);
              analysis_of(first).check(first, communicator);
              on_first_rank(communicator, [&]() {
                std::cout << '\n' << overview(scene) << std::flush;
              });
            },
            optimization_files()};
  }
} // namespace auxfem
