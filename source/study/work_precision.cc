#include <auxfem/study/refinement.h>
#include <auxfem/study/settings.h>
#include <auxfem/study/study.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    const std::string work_precision_picture = "work-precision";

    /** Compared settings and their references. */
    struct Grid
    {
      std::vector<Settings> runs; ///< the finest mesh and step last
      /**
       * Two references, the finest last; none if all exact values are known.
       */
      std::vector<Settings> references;
      /** The last run with a much smaller Newton tolerance. */
      Settings tightly_solved;

      const Settings &finest() const
      {
        return runs.back();
      }
    };

    std::vector<unsigned int> neighbouring_orders(const Scene &scene)
    {
      const unsigned int        own = scene.discretization.order;
      std::vector<unsigned int> orders;
      for (unsigned int order = std::max(own, 2u) - 1;
           order <= std::min(own + 1, highest_order(scene));
           ++order)
        orders.push_back(order);
      return orders;
    }

    Grid grid_of(const Scene &scene)
    {
      const Settings own = settings_of(scene);
      const auto     orders =
        values_or(tried_orders(scene, neighbouring_orders(scene)), own.order);
      const auto refinements =
        values_or(tried_refinements(scene, /*further=*/0), own.refinements);
      const auto steps =
        values_or(tried_time_steps(scene, {4, 2, 1, 0.5}), own.time_step);

      Grid grid;
      auto schemes = tried_schemes(scene);
      // The references use the first scheme, which must be that of the last
      // run.
      std::reverse(schemes.begin(), schemes.end());
      for (const std::string &scheme : schemes)
        for (const unsigned int order : orders)
          for (const unsigned int mesh : refinements)
            {
              Settings settings{order,
                                mesh,
                                own.time_step,
                                own.newton_tolerance,
                                scheme};
              for (const double tolerance : scene.study.time_tolerances)
                {
                  settings.time_tolerance = tolerance;
                  settings.newton_tolerance =
                    scene.newton.for_steps_within(tolerance).tolerance;
                  grid.runs.push_back(settings);
                }
              settings.time_tolerance   = {};
              settings.newton_tolerance = own.newton_tolerance;
              for (const double step : steps)
                {
                  settings.time_step = step;
                  grid.runs.push_back(settings);
                }
            }
      if (!scene.study.is_exact())
        grid.references =
          finer_meshes(scene, grid.finest(), /*raises_order=*/true);
      halve_time_steps(grid.references);
      constexpr double much = 1000;
      grid.tightly_solved   = grid.finest();
      grid.tightly_solved.newton_tolerance /= much;
      return grid;
    }

    SettingsList settings_in_grid(const Grid        &grid,
                                  const unsigned int repetitions)
    {
      SettingsList list;
      list.add(grid.runs, repetitions);
      list.add(grid.references, 1);
      list.add({grid.tightly_solved}, 1);
      return list;
    }

    std::vector<PlannedRun> plan_work_precision(const StudyTask &task)
    {
      return settings_in_grid(grid_of(task.scene), task.scene.study.repetitions)
        .planned_runs(task.scene);
    }

    /**
     * One run with its error and the parts of mesh and time step, each the
     * largest over all quantities; empty if a required run failed.
     */
    struct GridRun
    {
      Settings              settings;
      MeasuredRun           run;
      std::optional<double> error, by_mesh, by_step;
      /** Whether no cheaper run has a smaller error. */
      bool is_best = false;
    };

    /** All quantities of one run; empty if it failed. */
    using AllValues = std::optional<std::vector<QuantityValues>>;

    /** Results of the runs of a grid. */
    struct WorkPrecision
    {
      std::vector<GridRun>  runs; ///< by processor time
      std::optional<double> reference_error, by_newton;
      /** Quantities that do not count in errors. */
      std::vector<QuantityDefinition> unresolved;
      /** Finest reference; none if all values are exact. */
      std::optional<MeasuredRun> reference;
    };

    class GridComparison
    {
    public:
      GridComparison(const StudyTask &task, const std::vector<MeasuredRun> &all)
        : task(task)
        , grid(grid_of(task.scene))
        , list(settings_in_grid(grid, 1))
        , all(all)
        , comparison(comparison_of(all))
      {
        for (std::size_t q = 0; q < task.quantities.size(); ++q)
          resolved.push_back(is_resolved(q));
      }

      WorkPrecision result() const
      {
        WorkPrecision   found;
        const AllValues finest = reference();
        for (std::size_t q = 0; q < task.quantities.size(); ++q)
          if (!resolved[q])
            found.unresolved.push_back(task.quantities[q]);
        for (const Settings &settings : grid.runs)
          found.runs.push_back(compared(settings, finest));
        std::stable_sort(found.runs.begin(),
                         found.runs.end(),
                         [](const GridRun &one, const GridRun &other) {
                           return one.run.cpu_seconds < other.run.cpu_seconds;
                         });
        mark_best(found.runs);
        found.by_newton = largest_difference(values(grid.tightly_solved),
                                             values(grid.finest()));
        if (grid.references.empty())
          return found;
        found.reference_error =
          largest_difference(values(grid.references[0]), finest);
        found.reference = list.results_for({grid.references[1]}, all).front();
        return found;
      }

    private:
      /**
       * Whether the references agree on the quantity or its exact value is
       * known.
       */
      bool is_resolved(const std::size_t quantity) const
      {
        if (task.quantities[quantity].exact)
          return true;
        const AllValues finer  = values(grid.references[0]),
                        finest = values(grid.references[1]);
        return !finer || !finest ||
          relative_difference((*finer)[quantity], (*finest)[quantity]) <
          unresolved_error;
      }

      /** Largest relative difference of the resolved quantities. */
      std::optional<double> largest_difference(const AllValues &one,
                                               const AllValues &other) const
      {
        if (!one || !other)
          return {};
        double largest = 0;
        for (std::size_t q = 0; q < one->size(); ++q)
          if (resolved[q])
            {
              const double difference =
                relative_difference((*one)[q], (*other)[q]);
              if (!std::isfinite(difference))
                return {};
              largest = std::max(largest, difference);
            }
        return largest;
      }

      AllValues values(const Settings &settings) const
      {
        const MeasuredRun run = list.results_for({settings}, all).front();
        if (!run.completed())
          return {};
        std::vector<QuantityValues> result;
        for (const QuantityDefinition &quantity : task.quantities)
          result.push_back(value_of(quantity, run, comparison));
        return result;
      }

      /** Reference values, exact ones where known. */
      AllValues reference() const
      {
        AllValues result = grid.references.empty()
          ? std::vector<QuantityValues>(task.quantities.size())
          : values(grid.references[1]);
        for (std::size_t q = 0; result && q < task.quantities.size(); ++q)
          if (const auto exact = exact_value_of(task.quantities[q],
                                                task.scene.time.end_time,
                                                comparison))
            (*result)[q] = *exact;
        return result;
      }

      GridRun compared(const Settings &settings, const AllValues &finest) const
      {
        Settings on_finest_mesh    = settings;
        on_finest_mesh.order       = grid.finest().order;
        on_finest_mesh.refinements = grid.finest().refinements;
        const AllValues own        = values(settings);
        const AllValues fine_mesh  = values(on_finest_mesh);
        return {settings,
                list.results_for({settings}, all).front(),
                largest_difference(own, finest),
                largest_difference(own, fine_mesh),
                largest_difference(fine_mesh, finest)};
      }

      static void mark_best(std::vector<GridRun> &by_price)
      {
        std::optional<double> smallest;
        for (GridRun &one : by_price)
          if (one.error && (!smallest || *one.error < *smallest))
            {
              one.is_best = true;
              smallest    = one.error;
            }
      }

      const StudyTask                &task;
      const Grid                      grid;
      const SettingsList              list;
      const std::vector<MeasuredRun> &all;
      const Comparison                comparison;
      std::vector<bool>               resolved; ///< by quantity
    };

    std::vector<std::string> table_header(const bool with_mesh)
    {
      std::vector<std::string> header = {"best"};
      if (with_mesh)
        header.insert(header.end(), {"order", "elements a strut"});
      header.insert(header.end(),
                    {"scheme",
                     "step (s)",
                     "tolerance",
                     "unknowns",
                     "iterations",
                     "CPU s",
                     "spread",
                     "error"});
      if (with_mesh)
        header.insert(header.end(), {"by mesh", "by step"});
      return header;
    }

    std::vector<std::string> table_row(const GridRun &one, const bool with_mesh)
    {
      const Settings          &settings = one.settings;
      std::vector<std::string> row      = {one.is_best ? "*" : ""};
      if (with_mesh)
        row.insert(row.end(),
                   {std::to_string(settings.order),
                    std::to_string(settings.elements())});
      row.insert(row.end(),
                 {settings.scheme,
                  number_text(settings.time_step),
                  settings.time_tolerance
                    ? number_text(*settings.time_tolerance)
                    : "-",
                  std::to_string(one.run.unknowns),
                  std::to_string(one.run.iterations),
                  seconds_text(one.run.cpu_seconds),
                  percent_text(one.run.spread()),
                  one.run.completed() ? error_text(one.error) : "failed"});
      if (with_mesh)
        row.insert(row.end(),
                   {error_text(one.by_mesh), error_text(one.by_step)});
      return row;
    }

    std::string table_text(const WorkPrecision &found, const bool with_mesh)
    {
      TextTable table;
      table.header = table_header(with_mesh);
      for (const GridRun &one : found.runs)
        table.rows.push_back(table_row(one, with_mesh));
      return table.markdown();
    }

    LogPicture picture_of(const WorkPrecision &found, const bool with_mesh)
    {
      LogPicture picture{work_precision_picture,
                         "What accuracy costs",
                         "processor time (s)",
                         "relative error",
                         {}};
      const auto title_of = [with_mesh](const Settings &settings) {
        const std::string scheme =
          settings.scheme + (settings.time_tolerance ? " by tolerance" : "");
        return with_mesh
          ? scheme + ", order " + std::to_string(settings.order) + ", " +
            std::to_string(settings.elements()) + " a strut"
          : scheme;
      };
      const auto style_of = [with_mesh](const Settings &settings) -> LineStyle {
        const unsigned int by_tolerance = settings.time_tolerance ? 1 : 0;
        if (!with_mesh)
          return {colour_of_scheme(settings.scheme),
                  by_tolerance,
                  by_tolerance};
        return {colour_of_order(settings.order),
                settings.refinements,
                2 * colour_of_scheme(settings.scheme) + by_tolerance};
      };
      Curve best{"best", {}};
      for (const GridRun &one : found.runs)
        {
          if (!one.error || *one.error <= 0)
            continue;
          const std::string title = title_of(one.settings);
          auto              curve = std::find_if(picture.curves.begin(),
                                    picture.curves.end(),
                                    [&title](const Curve &candidate) {
                                      return candidate.title == title;
                                    });
          if (curve == picture.curves.end())
            curve =
              picture.curves.insert(curve,
                                    Curve{title, {}, style_of(one.settings)});
          curve->points.emplace_back(one.run.cpu_seconds, *one.error);
          if (one.is_best)
            best.points.emplace_back(one.run.cpu_seconds, *one.error);
        }
      best.is_beneath = true;
      picture.curves.insert(picture.curves.begin(), best);
      return picture;
    }

    std::optional<Recommendation> recommend_run(const WorkPrecision &found,
                                                const bool           with_mesh,
                                                const double         target)
    {
      std::vector<GridRun> good;
      for (const GridRun &one : found.runs)
        if (found.reference_error.value_or(0) <= target && one.error &&
            *one.error <= target && one.run.verdict == Verdict::sound)
          good.push_back(one);
      const auto best = cheapest_of(
        good,
        [](const GridRun &one) { return one.run.cpu_seconds; },
        [](const GridRun &one) { return *one.error; });
      if (!best)
        return {};
      const std::string parts = ": by mesh " + error_text(best->by_mesh) +
        ", by step " + error_text(best->by_step);
      return Recommendation{best->settings,
                            seconds_text(best->run.cpu_seconds) +
                              " CPU s, error " + error_text(best->error) +
                              (with_mesh ? parts : "")};
    }

    std::vector<Column> work_precision_columns(const Scene &scene)
    {
      std::vector<Column> columns = columns_of_settings(scene);
      for (const Column &column : columns_of_run())
        columns.push_back(column);
      columns.insert(
        columns.end(),
        {{"spread", "1", "longest over shortest repetition, less 1"},
         {"error", "1", "largest relative error of all quantities"}});
      if (has_mesh(scene))
        columns.insert(
          columns.end(),
          {{"error_by_mesh", "1", "difference from the finest mesh"},
           {"error_by_step", "1", "error with the finest mesh"}});
      columns.push_back(
        {"best", "", "1 if no cheaper run has a smaller error"});
      return columns;
    }

    std::vector<std::string> row_of(const GridRun &one, const Scene &scene)
    {
      std::vector<std::string> row = cells_of(one.settings, scene);
      for (const std::string &cell : cells_of(one.run))
        row.push_back(cell);
      row.push_back(number_text(one.run.spread()));
      row.push_back(number_text(one.error));
      if (has_mesh(scene))
        row.insert(row.end(),
                   {number_text(one.by_mesh), number_text(one.by_step)});
      row.emplace_back(one.is_best ? "1" : "0");
      return row;
    }

    StudyReport report_work_precision(const StudyTask                &task,
                                      const std::vector<MeasuredRun> &runs,
                                      StudyRuns & /*further*/)
    {
      const WorkPrecision found     = GridComparison(task, runs).result();
      const bool          with_mesh = has_mesh(task.scene);
      StudyReport         report;
      report.text = "## Error and price\n\n" + table_text(found, with_mesh) +
        "\nErrors are the largest of all quantities" +
        (found.reference ? ". The reference's own error, estimated: " +
             error_text(found.reference_error)
                         : ", against exact values") +
        ". Newton's tolerance contributes " + error_text(found.by_newton) +
        ".\n\n## What to take\n\n" +
        recommendations_text(task.scene, [&](const double target) {
                      return recommend_run(found, with_mesh, target);
                    });
      report.columns = work_precision_columns(task.scene);
      for (const GridRun &one : found.runs)
        report.rows.push_back(row_of(one, task.scene));
      report.pictures.push_back(picture_of(found, with_mesh));
      for (const QuantityDefinition &quantity : found.unresolved)
        add_finding(unresolved_finding(quantity), report.findings);
      if (found.reference)
        add_finding_on_reference(*found.reference,
                                 "The reference",
                                 report.findings);
      return report;
    }
  } // namespace

  StudyKind work_precision_study()
  {
    return {"work-precision",
            {work_precision_picture},
            plan_work_precision,
            report_work_precision};
  }
} // namespace auxfem
