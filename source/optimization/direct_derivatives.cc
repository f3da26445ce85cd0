#include <auxfem/analysis/infinite_lattice/effective_properties.h>
#include <auxfem/analysis/infinite_lattice/property_files.h>
#include <auxfem/analysis/simulation/nearby_run.h>
#include <auxfem/analysis/small_motions/modes.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/mathematics/voigt.h>
#include <auxfem/model/mass_and_size.h>
#include <auxfem/optimization/direct_derivatives.h>
#include <auxfem/output/figure_files.h>
#include <auxfem/output/history.h>
#include <auxfem/output/summary.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <memory>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    Scene scene_at(const Scene &scene, const DesignPoint &point)
    {
      return scene_of_case(
        scene,
        case_of_design(scene, point, scene.output.directory).overrides);
    }

    /** Mass and relative density, as in summary.json. */
    NamedResults mass_of(const LatticeRun &run)
    {
      return results_in(json_of(mass_and_size(run.scene, run.lattice)));
    }

    /** A scene near another one, with the rows of its history. */
    class NearbyScene
    {
    public:
      NearbyScene(const Scene      &varied,
                  const LatticeRun &run,
                  const MPI_Comm    communicator)
        : scene(varied)
        , nearby(RunPlan(scene), run, communicator)
        , history(scene, nearby.run.equations, communicator)
      {
        for (const Column &column : history.columns())
          table.names.push_back(column.name);
        table.columns.resize(table.names.size());
        record();
      }

      void follow(const Solution &base, TangentSolver &tangent)
      {
        nearby.follow(base, tangent);
        record();
      }

      /** As in summary.json, without what concerns the run itself. */
      NamedResults results() const
      {
        NamedResults      found      = mass_of(nearby.run);
        FiguresDefinition definition = scene.figures;
        definition.options.in_time   = false;
        CrushGeometry geometry;
        if (definition.crush)
          geometry = crush_geometry(nearby.run.equations);
        const Json figures = json_of(
          figures_of_run(definition, names_of_bodies(scene), geometry, table));
        for (const auto &result : results_in(Json{{"evaluation", figures}}))
          found.push_back(result);
        add_quantities(quantities_in(scene, table), found);
        return found;
      }

    private:
      void record()
      {
        const std::vector<double> &row = history.values(nearby.solution());
        for (std::size_t i = 0; i < row.size(); ++i)
          table.columns[i].push_back(row[i]);
      }

      const Scene   scene;
      NearbyRun     nearby;
      History       history;
      RecordedTable table;
    };

    /** Lets nearby scenes follow each equilibrium of a run. */
    class Follower : public Recorder
    {
    public:
      Follower(LatticeRun               &run,
               const std::vector<Scene> &scenes,
               const MPI_Comm            communicator)
        : run(run)
        , scenes(scenes)
        , communicator(communicator)
        , tangent(run)
      {}

      void start(const Solution & /*solution*/) override
      {
        for (const Scene &scene : scenes)
          nearby.push_back(
            std::make_unique<NearbyScene>(scene, run, communicator));
      }

      void step(const Solution &solution,
                const StepReport & /*report*/) override
      {
        is_independent =
          is_independent && has_independent_equilibria(run.equations);
        if (!is_independent)
          return;
        tangent.update();
        for (const auto &one : nearby)
          one->follow(solution, tangent.solver());
      }

      /** Results of the scenes; none if equilibria depend on the way to them.
       */
      std::optional<std::vector<NamedResults>> results() const
      {
        if (!is_independent)
          return {};
        std::vector<NamedResults> list;
        for (const auto &one : nearby)
          list.push_back(one->results());
        return list;
      }

    private:
      LatticeRun                               &run;
      const std::vector<Scene>                 &scenes;
      const MPI_Comm                            communicator;
      EquilibriumTangent                        tangent;
      std::vector<std::unique_ptr<NearbyScene>> nearby;
      bool                                      is_independent = true;
    };

    std::optional<std::vector<NamedResults>>
    static_results(const Scene              &scene,
                   const std::vector<Scene> &scenes,
                   const MPI_Comm            communicator)
    {
      if (!is_static(scene) || scene.discretization.tolerance)
        return {};
      LatticeRun run(RunPlan(scene), communicator);
      if (!has_independent_equilibria(run.equations))
        return {};
      Follower follower(run, scenes, communicator);
      run.run(follower);
      return follower.results();
    }

    /** Effective properties of a lattice near another one. */
    struct NearbyLattice
    {
      NearbyLattice(const Scene      &scene,
                    const LatticeRun &run,
                    const MPI_Comm    communicator)
        : nearby(plan_of_unit_strains(scene), run, communicator)
        , stiffness(n_strain_components(run.lattice.dimension),
                    n_strain_components(run.lattice.dimension))
      {}

      NamedResults results() const
      {
        NamedResults found = mass_of(nearby.run);
        for (const auto &result :
             results_in(json_of(properties_with(stiffness, nearby.run))))
          found.push_back(result);
        return found;
      }

      NearbyRun                  nearby;
      dealii::FullMatrix<double> stiffness; ///< Pa
    };

    std::vector<NamedResults>
    results_of_lattices(const Scene              &scene,
                        const std::vector<Scene> &scenes,
                        const MPI_Comm            communicator)
    {
      LatticeRun run(plan_of_unit_strains(scene), communicator);
      run.prepare();
      EquilibriumTangent                          tangent(run);
      std::vector<std::unique_ptr<NearbyLattice>> lattices;
      for (const Scene &one : scenes)
        lattices.push_back(
          std::make_unique<NearbyLattice>(one, run, communicator));
      Recorder           nobody;
      const unsigned int n = n_strain_components(run.lattice.dimension);
      for (unsigned int j = 0; j < n; ++j)
        {
          run.advance(nobody);
          tangent.update();
          for (const auto &one : lattices)
            {
              one->nearby.follow(run.solution, tangent.solver());
              const std::vector<double> stress = mean_stress(one->nearby.run);
              for (unsigned int i = 0; i < n; ++i)
                one->stiffness(i, j) = stress[i];
            }
        }
      std::vector<NamedResults> list;
      for (const auto &one : lattices)
        list.push_back(one->results());
      return list;
    }

    /** As in summary.json, without what the eigenvalues do not tell. */
    NamedResults results_of_modes(const LatticeRun          &run,
                                  const std::vector<double> &eigenvalues)
    {
      Json modes = Json::array();
      for (const double eigenvalue : eigenvalues)
        {
          NaturalMode mode{};
          mode.eigenvalue = eigenvalue;
          modes.push_back(
            {{"eigenvalue", eigenvalue},
             {"frequency_hertz",
              mode.angular_frequency() / (2 * dealii::numbers::PI)},
             {"growth_rate", mode.growth_rate()}});
        }
      NamedResults found = mass_of(run);
      for (const auto &result : results_in(Json{{"modes", modes}}))
        found.push_back(result);
      return found;
    }

    /** Sets up @p run and finds its state at rest or in equilibrium. */
    void begin_modes(LatticeRun &run)
    {
      run.prepare();
      if (run.model.plan.time.static_start)
        run.start();
    }

    /**
     * Eigenvalues by an inverse iteration of the modes of @p scene. Further
     * modes complete those of equal frequencies.
     */
    std::optional<std::vector<NamedResults>>
    results_of_frequencies(const Scene              &scene,
                           const std::vector<Scene> &scenes,
                           const MPI_Comm            communicator)
    {
      const RunPlan plan = plan_with_accepted_elements(scene, communicator);
      LatticeRun    run(plan, communicator);
      begin_modes(run);
      if (!has_natural_modes(run.solver(), run.solution.state))
        return {};
      const NaturalModes base =
        natural_modes(run.solver(),
                      run.solution.state,
                      scene.modes.number + n_guard_modes);
      std::vector<Vector> shapes;
      for (const NaturalMode &mode : base.modes)
        shapes.push_back(mode.shape);
      std::vector<NamedResults> list;
      for (const Scene &one : scenes)
        {
          RunPlan nearby_plan  = plan_of_modes(one);
          nearby_plan.division = plan.division;
          nearby_plan.elements = plan.elements;
          LatticeRun nearby(nearby_plan, communicator);
          begin_modes(nearby);
          expect_equal_unknowns(nearby, run);
          std::vector<double> values = nearby_eigenvalues(nearby.solver(),
                                                          nearby.solution.state,
                                                          base,
                                                          shapes)
                                         .values;
          values.resize(
            std::min<std::size_t>(values.size(), scene.modes.number));
          list.push_back(results_of_modes(nearby, values));
        }
      return list;
    }

    std::optional<std::vector<NamedResults>>
    nearby_results(const Scene              &scene,
                   const std::vector<Scene> &scenes,
                   const MPI_Comm            communicator)
    {
      if (scene.context.model != Model::lattice)
        return {};
      if (scene.analysis == Analysis::effective_properties)
        return results_of_lattices(scene, scenes, communicator);
      if (scene.analysis == Analysis::modes)
        return results_of_frequencies(scene, scenes, communicator);
      if (scene.analysis == Analysis::simulation)
        return static_results(scene, scenes, communicator);
      return {};
    }
  } // namespace

  std::optional<std::vector<std::optional<GoalValues>>>
  nearby_goals(const Scene                    &scene,
               const DesignPoint              &point,
               const std::vector<DesignPoint> &points,
               Goals                          &goals,
               const MPI_Comm                  communicator)
  {
    std::vector<Scene> scenes;
    try
      {
        for (const DesignPoint &one : points)
          scenes.push_back(scene_at(scene, one));
        const auto results =
          nearby_results(scene_at(scene, point), scenes, communicator);
        if (!results)
          return {};
        std::vector<std::optional<GoalValues>> values;
        for (const NamedResults &one : *results)
          {
            values.push_back(goals.values(one));
            if (!values.back())
              return {};
          }
        return values;
      }
    catch (const InputError &)
      {
        // A design beyond a bound, or with other unknowns.
        return {};
      }
  }

  Derivatives derivatives_at(DesignRuns        &runs,
                             const DesignPoint &point,
                             const double       step,
                             const unsigned int multiple)
  {
    const DifferenceFormulas formulas(point, multiple * direct_step);
    if (const auto values = nearby_goals(runs.scene(),
                                         point,
                                         formulas.points(),
                                         runs.goals(),
                                         runs.communicator()))
      return formulas.differences(*values);
    return derivatives_by_runs(runs, point, multiple * step);
  }
} // namespace auxfem
