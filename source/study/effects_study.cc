#include <auxfem/model/build_lattice.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/study/quantities.h>
#include <auxfem/study/settings.h>
#include <auxfem/study/study.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const std::string nothing_omitted = "nothing";

    /** The study itself decides whether an effect matters. */
    const std::string keep_all_effects = "Effects/Tolerance=0";

    /** The scene without some of its effects. */
    struct Simplification
    {
      /** Name of the omitted effect, for display. */
      std::string              name;
      std::vector<std::string> overrides;
      /** Reason why the effect cannot be omitted; empty if it can. */
      std::string obstacle;
    };

    std::string obstacle_to(const Scene                    &scene,
                            const std::vector<std::string> &overrides)
    {
      try
        {
          read_scene_from_text(scene.all_parameters, scene.file, overrides);
          return "";
        }
      catch (const InputError &error)
        {
          return first_line(error.what());
        }
    }

    /**
     * Assignment that omits an effect; without inertia the analysis is static.
     */
    std::string assignment_without(const std::string &effect)
    {
      return effect == "Inertia" ? "Time/Scheme=static"
                                 : "Effects/" + effect + "=off";
    }

    /** Names of the switches of the simulated effects. */
    std::vector<std::string> simulated_effects(const Scene &scene)
    {
      std::vector<std::string> names;
      for (const EffectDecision &decision :
           decide_effects(scene, build_lattice(scene)).decisions)
        for (const Parameter &parameter : effects_schema().parameters)
          if (decision.on && boost::iequals(decision.name, parameter.name))
            names.push_back(parameter.name);
      return names;
    }

    /**
     * The complete scene, then the scene without each of its effects in turn.
     */
    std::vector<Simplification> simplifications(const Scene &scene)
    {
      if (scene.context.model != Model::lattice)
        throw InputError(scene.file +
                         ": Study/Kind = effects is for Model = lattice, which "
                         "has effects to leave out");
      std::vector<Simplification> all = {{nothing_omitted, {}, ""}};
      for (const std::string &effect :
           simulated_effects(scene_with(scene, {keep_all_effects})))
        {
          const std::vector<std::string> without = {assignment_without(effect)};
          all.push_back({effect, without, obstacle_to(scene, without)});
        }
      return all;
    }

    /**
     * Run with all effects, also those that `auto` would omit, except the
     * effects of @p simplification.
     */
    PlannedRun planned_run(const Scene          &scene,
                           const Simplification &simplification)
    {
      const bool               is_whole  = simplification.overrides.empty();
      std::vector<std::string> overrides = simplification.overrides;
      overrides.push_back(keep_all_effects);
      return {is_whole ? "as it is" : "without " + simplification.name,
              scene_with(scene, overrides),
              scene.study.repetitions};
    }

    std::vector<PlannedRun> plan_effects(const StudyTask &task)
    {
      std::vector<PlannedRun> planned;
      for (const Simplification &one : simplifications(task.scene))
        if (one.obstacle.empty())
          planned.push_back(planned_run(task.scene, one));
      return planned;
    }

    /** Change of the results by a simplification. */
    struct EffectChange
    {
      Simplification simplification;
      /** Relative change of each quantity; empty if the run failed. */
      std::vector<double>   changes;
      std::optional<double> cpu_seconds, spread;

      bool is_below(const double tolerance) const
      {
        return !changes.empty() &&
          std::all_of(changes.begin(), changes.end(), [&](const double change) {
            return change <= tolerance;
          });
      }
    };

    EffectChange change_by(const Simplification &simplification,
                           const MeasuredRun    &without,
                           const MeasuredRun    &with_all,
                           const std::vector<QuantityDefinition> &quantities)
    {
      EffectChange change{simplification,
                          {},
                          without.cpu_seconds,
                          without.spread()};
      std::string &obstacle = change.simplification.obstacle;
      if (!without.completed())
        obstacle = first_line(without.exit_state);
      for (const QuantityDefinition &quantity : quantities)
        for (const std::string &column : quantity.columns)
          if (without.columns.count(column) == 0)
            obstacle = "there is no " + column;
      if (!obstacle.empty())
        return change;
      const Comparison comparison = comparison_of({without, with_all});
      for (const QuantityDefinition &quantity : quantities)
        change.changes.push_back(
          relative_difference(value_of(quantity, without, comparison),
                              value_of(quantity, with_all, comparison)));
      return change;
    }

    /**
     * Whether @p one is faster than @p whole by more than the spread of both.
     */
    bool saves_time(const EffectChange &one, const EffectChange &whole)
    {
      const double noise =
        1 + std::max(one.spread.value_or(0), whole.spread.value_or(0));
      return one.cpu_seconds && *one.cpu_seconds * noise < *whole.cpu_seconds;
    }

    /** Omits all effects together that can each be omitted alone. */
    Simplification omit_together(const std::vector<EffectChange> &changes,
                                 const double                     tolerance)
    {
      Simplification together;
      for (const EffectChange &one : changes)
        if (one.is_below(tolerance) && !one.simplification.overrides.empty())
          {
            together.name +=
              (together.name.empty() ? "" : ", ") + one.simplification.name;
            together.overrides.push_back(one.simplification.overrides.front());
          }
      return together;
    }

    std::string verdict_on(const EffectChange &change, const double tolerance)
    {
      if (change.simplification.overrides.empty())
        return "";
      if (!change.simplification.obstacle.empty())
        return "cannot be left out";
      return change.is_below(tolerance) ? "not called for" : "called for";
    }

    TextTable table_of_effects(const StudyTask                 &task,
                               const std::vector<EffectChange> &changes,
                               const double                     price)
    {
      TextTable table;
      table.header = {"left out"};
      for (const QuantityDefinition &quantity : task.quantities)
        table.header.push_back("change of " + quantity.name);
      for (const char *const heading : {"CPU s", "spread", "saved", "verdict"})
        table.header.emplace_back(heading);
      for (const EffectChange &one : changes)
        {
          std::vector<std::string> row = {one.simplification.name};
          for (std::size_t q = 0; q < task.quantities.size(); ++q)
            row.push_back(one.changes.empty() ? "-"
                                              : error_text(one.changes[q]));
          row.push_back(one.cpu_seconds ? seconds_text(*one.cpu_seconds) : "-");
          row.push_back(percent_text(one.spread));
          row.push_back(one.cpu_seconds && price > 0
                          ? percent_text(1 - *one.cpu_seconds / price)
                          : "-");
          row.push_back(verdict_on(one, task.scene.study.tolerance));
          table.rows.push_back(row);
        }
      return table;
    }

    std::vector<EffectChange> changes_of(const StudyTask                &task,
                                         const std::vector<MeasuredRun> &runs)
    {
      std::vector<EffectChange> changes;
      auto                      run = runs.begin();
      for (const Simplification &one : simplifications(task.scene))
        if (one.obstacle.empty())
          changes.push_back(
            change_by(one, *run++, runs.front(), task.quantities));
        else
          changes.push_back({one, {}, {}, {}});
      return changes;
    }

    std::string obstacles_text(const std::vector<EffectChange> &changes)
    {
      std::string text;
      for (const EffectChange &one : changes)
        if (!one.simplification.obstacle.empty())
          text += "\nWithout " + one.simplification.name + ": " +
            one.simplification.obstacle + '\n';
      return text;
    }

    /**
     * Recommendation on the effects.
     * @param changes by nothing, by each effect alone and, if several can be
     *   omitted, by @p together
     */
    std::string advice(const std::vector<EffectChange> &changes,
                       const Simplification            &together,
                       const double                     tolerance)
    {
      const std::string allowed =
        "a change of " + number_text(100 * tolerance) + " %";
      if (together.overrides.empty())
        return "All effects of the scene are called for at " + allowed + ".\n";
      const auto change =
        std::find_if(changes.begin(), changes.end(), [&](const auto &one) {
          return one.simplification.overrides == together.overrides;
        });
      const std::string line =
        "\n\n   " + command_line_text(together.overrides) + '\n';
      if (!change->is_below(tolerance))
        return "Each of them alone could be left out at " + allowed +
          ", but not all together:" + line;
      const std::string times = seconds_text(*change->cpu_seconds) +
        " CPU s in place of " + seconds_text(*changes.front().cpu_seconds);
      if (!saves_time(*change, changes.front()))
        return "Not called for at " + allowed + ", but without a gain, " +
          times + ":" + line;
      return "Not called for at " + allowed + ", and " + times +
        " without:" + line;
    }

    std::vector<Column> effects_columns(const StudyTask &task)
    {
      std::vector<Column> columns = {
        {"left_out", "", "effects that the scene is computed without"},
        {"cpu", "s", "processor time, the least of all repetitions"},
        {"spread", "1", "longest over shortest repetition, less 1"},
        {"verdict", "", "whether the effect is called for"}};
      for (const QuantityDefinition &quantity : task.quantities)
        columns.push_back({quantity.name + ".change", "1", "relative change"});
      return columns;
    }

    std::vector<std::string> row_of(const EffectChange &one,
                                    const StudyTask    &task)
    {
      std::vector<std::string> row = {one.simplification.name,
                                      number_text(one.cpu_seconds),
                                      number_text(one.spread),
                                      verdict_on(one,
                                                 task.scene.study.tolerance)};
      for (std::size_t q = 0; q < task.quantities.size(); ++q)
        row.push_back(one.changes.empty() ? "" : number_text(one.changes[q]));
      return row;
    }

    StudyReport report_effects(const StudyTask                &task,
                               const std::vector<MeasuredRun> &runs,
                               StudyRuns                      &further)
    {
      const double       tolerance = task.scene.study.tolerance;
      const MeasuredRun &as_it_is  = runs.front();
      StudyReport        report;
      add_finding_on_reference(as_it_is, "The scene as it is", report.findings);
      report.columns = effects_columns(task);
      if (!as_it_is.completed())
        return report;

      std::vector<EffectChange> changes  = changes_of(task, runs);
      const Simplification      together = omit_together(changes, tolerance);
      if (together.overrides.size() > 1)
        changes.push_back(change_by(
          together,
          further.compute({planned_run(task.scene, together)}).front(),
          as_it_is,
          task.quantities));
      report.text = "## Effects left out\n\n" +
        table_of_effects(task, changes, as_it_is.cpu_seconds).markdown() +
        obstacles_text(changes) + "\n## What to take\n\n" +
        advice(changes, together, tolerance);
      for (const EffectChange &one : changes)
        report.rows.push_back(row_of(one, task));
      return report;
    }
  } // namespace

  StudyKind effects_study()
  {
    return {"effects", {}, plan_effects, report_effects};
  }
} // namespace auxfem
