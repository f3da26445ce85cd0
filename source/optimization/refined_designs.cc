#include <auxfem/optimization/refined_designs.h>
#include <auxfem/parameters/text.h>

namespace auxfem
{
  namespace
  {
    bool has_mesh(const Scene &scene)
    {
      return scene.context.model == Model::lattice;
    }

    bool has_time_steps(const Scene &scene)
    {
      return scene.context.model == Model::reduced_cell ||
        (scene.analysis == Analysis::simulation && !is_static(scene));
    }
  } // namespace

  std::vector<std::string> finer_discretization(const Scene &scene)
  {
    std::vector<std::string> overrides;
    if (has_mesh(scene))
      overrides.push_back("Discretization/Global refinements=" +
                          std::to_string(scene.discretization.refinements + 1));
    if (has_time_steps(scene))
      overrides.push_back("Time/Time step=" + number_text(scene.time.step / 2));
    if (has_time_steps(scene) && scene.time.relative_tolerance)
      overrides.push_back("Time/Relative tolerance=" +
                          number_text(*scene.time.relative_tolerance / 4));
    return overrides;
  }

  std::string refinement_text(const Scene &scene)
  {
    const std::string mesh = "a finer mesh", step = "half the step";
    if (!has_time_steps(scene))
      return mesh;
    return has_mesh(scene) ? mesh + " and " + step : step;
  }

  std::vector<std::optional<GoalValues>>
  refined_goals(const Scene               &scene,
                const std::vector<Design> &designs,
                Goals                     &goals,
                const MPI_Comm             communicator,
                const FileRules           &rules,
                const std::string         &parent)
  {
    const std::vector<std::string>         finer = finer_discretization(scene);
    std::vector<std::optional<GoalValues>> values(designs.size());
    if (finer.empty())
      return values;
    std::vector<SceneCase> cases;
    for (const Design &design : designs)
      {
        cases.push_back(
          case_of_design(scene,
                         design.point,
                         numbered_folder(parent, cases.size() + 1)));
        for (const std::string &assignment : finer)
          cases.back().overrides.push_back(assignment);
      }
    const std::vector<CaseEnd> ends =
      run_cases(scene,
                cases,
                communicator,
                rules,
                [](std::size_t, const CaseEnd &, int) {});
    for (std::size_t i = 0; i < cases.size(); ++i)
      {
        const CaseResults results =
          results_on_all_ranks(scene, cases[i], ends[i], communicator);
        if (results.exit_state == "completed")
          values[i] = goals.values(results.results);
      }
    return values;
  }
} // namespace auxfem
