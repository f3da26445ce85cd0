#include <auxfem/parameters/errors.h>
#include <auxfem/study/refinement.h>
#include <auxfem/study/settings.h>
#include <auxfem/study/study.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    SettingsList settings_in(const std::vector<Refinement> &refinements)
    {
      SettingsList list;
      for (const Refinement &refinement : refinements)
        {
          list.add(refinement.runs, 1);
          list.add(refinement.references, 1);
        }
      return list;
    }

    std::vector<PlannedRun> plan(const StudyTask &task)
    {
      const std::vector<Refinement> refinements = refinements_of(task.scene);
      if (refinements.empty())
        throw InputError(task.scene.file +
                         ": the study refines nothing. Give Refinements, Time "
                         "steps, Relative tolerances or Newton tolerances in "
                         "the subsection Study");
      return settings_in(refinements).planned_runs(task.scene);
    }

    /** A refinement with all its errors. */
    struct Family
    {
      const Refinement             *refinement;
      std::vector<MeasuredRun>      runs;   ///< references at the end
      std::vector<RefinementErrors> errors; ///< for each quantity

      /** Largest error of run @p i in any quantity; none if it failed. */
      std::optional<double> largest_error(const std::size_t i) const
      {
        std::optional<double> largest;
        for (const RefinementErrors &quantity : errors)
          {
            if (!quantity.is_resolved())
              continue;
            const std::optional<double> error = quantity.runs[i].error;
            if (!error)
              return {};
            largest = std::max(largest.value_or(0), *error);
          }
        return largest;
      }

      /** Largest error of the reference in any resolved quantity. */
      double largest_reference_error() const
      {
        double largest = 0;
        for (const RefinementErrors &quantity : errors)
          if (quantity.is_resolved())
            largest = std::max(largest, quantity.reference_error.value_or(0));
        return largest;
      }

      /** Largest convergence index of run @p i in any quantity. */
      std::optional<double> largest_index(const std::size_t i) const
      {
        std::optional<double> largest;
        for (const RefinementErrors &quantity : errors)
          if (const auto index = quantity.runs[i].convergence_index)
            largest = std::max(largest.value_or(0), *index);
        return largest;
      }
    };

    std::vector<Family> families_of(const StudyTask                &task,
                                    const std::vector<Refinement>  &refinements,
                                    const std::vector<MeasuredRun> &runs)
    {
      const SettingsList  settings = settings_in(refinements);
      std::vector<Family> families;
      for (const Refinement &refinement : refinements)
        {
          Family family{&refinement,
                        settings.results_for(refinement.runs, runs),
                        {}};
          for (const MeasuredRun &run :
               settings.results_for(refinement.references, runs))
            family.runs.push_back(run);
          for (const QuantityDefinition &quantity : task.quantities)
            family.errors.push_back(errors_of(refinement,
                                              quantity,
                                              family.runs,
                                              task.scene.time.end_time,
                                              task.scene.study.extrapolates));
          families.push_back(family);
        }
      return families;
    }

    /** Refined parameters in the order of the families, without duplicates. */
    std::vector<RefinedParameter>
    refined_in(const std::vector<Family> &families)
    {
      std::vector<RefinedParameter> refined;
      for (const Family &family : families)
        if (refined.empty() || refined.back() != family.refinement->refined)
          refined.push_back(family.refinement->refined);
      return refined;
    }

    std::string coarseness_text(const RefinedParameter refined,
                                const Settings        &settings)
    {
      return refined == RefinedParameter::mesh
        ? std::to_string(settings.elements())
        : refined == RefinedParameter::mesh_and_time_step
        ? std::to_string(settings.elements()) + ", " +
          number_text(settings.time_step)
        : number_text(coarseness(refined, settings));
    }

    std::string heading_of(const RefinedParameter refined)
    {
      return refined == RefinedParameter::mesh ? "elements a strut"
        : refined == RefinedParameter::mesh_and_time_step
        ? "elements a strut, step (s)"
        : refined == RefinedParameter::time_step      ? "step (s)"
        : refined == RefinedParameter::time_tolerance ? "relative tolerance"
                                                      : "Newton tolerance";
    }

    TextTable table_of(const Family &family, const StudyTask &task)
    {
      TextTable              table;
      const RefinedParameter refined = family.refinement->refined;
      table.header                   = {heading_of(refined),
                                        "unknowns",
                                        "steps",
                                        "iterations",
                                        "CPU s"};
      for (const QuantityDefinition &quantity : task.quantities)
        {
          table.header.push_back("error of " + quantity.name);
          table.header.emplace_back("order");
        }
      for (std::size_t i = 0; i < family.refinement->runs.size(); ++i)
        {
          const MeasuredRun &run = family.runs[i];
          table.rows.push_back(
            {coarseness_text(refined, family.refinement->runs[i]),
             std::to_string(run.unknowns),
             std::to_string(run.steps),
             std::to_string(run.iterations),
             seconds_text(run.cpu_seconds)});
          for (const RefinementErrors &errors : family.errors)
            {
              const RunError &one = errors.runs[i];
              table.rows.back().push_back(
                run.completed() ? error_text(one.error) : "failed");
              table.rows.back().push_back(decimal_text(one.order, 2));
            }
        }
      return table;
    }

    std::string reference_text(const Family &family, const StudyTask &task)
    {
      if (family.refinement->references.empty())
        return "Reference: exact values.\n";
      std::string text;
      for (std::size_t q = 0; q < task.quantities.size(); ++q)
        {
          const QuantityDefinition &quantity = task.quantities[q];
          text += (text.empty() ? "" : ", ") + quantity.name + " " +
            (quantity.exact ? "0 (exact value)"
                            : error_text(family.errors[q].reference_error));
        }
      const Settings &finest = family.refinement->references.back();
      return "Reference: " + name_of_run(task.scene, finest) + ", " +
        seconds_text(family.runs.back().cpu_seconds) +
        " CPU s. Its own error, estimated: " + text + ".\n";
    }

    /** Reasons of runs that failed, one line each. */
    std::string failures_text(const Family &family)
    {
      std::string text;
      for (std::size_t i = 0; i < family.refinement->runs.size(); ++i)
        if (!family.runs[i].completed())
          text += "Failed at " +
            coarseness_text(family.refinement->refined,
                            family.refinement->runs[i]) +
            ": " + first_line(family.runs[i].exit_state) + "\n";
        else if (family.runs[i].verdict != Verdict::sound)
          text += "The verdict on " +
            coarseness_text(family.refinement->refined,
                            family.refinement->runs[i]) +
            " is: " + name_of(family.runs[i].verdict) + ".\n";
      return text;
    }

    std::string picture_name(const RefinedParameter refined)
    {
      std::string name = "error-" + name_of(refined);
      std::replace(name.begin(), name.end(), ' ', '-');
      std::replace(name.begin(), name.end(), 'N', 'n');
      return name;
    }

    unsigned int colour_of(const Refinement &refinement)
    {
      const Settings        &one     = refinement.runs.front();
      const RefinedParameter refined = refinement.refined;
      return refined == RefinedParameter::mesh ||
          refined == RefinedParameter::mesh_and_time_step
        ? colour_of_order(one.order)
        : colour_of_scheme(one.scheme);
    }

    LogPicture picture_of(const std::vector<Family> &families,
                          const RefinedParameter     refined,
                          const StudyTask           &task)
    {
      LogPicture picture;
      picture.name         = picture_name(refined);
      picture.title        = "Error by " + name_of(refined);
      picture.x_label      = refined == RefinedParameter::mesh
             ? "length of an element / length of the strut"
             : refined == RefinedParameter::time_tolerance ? "relative tolerance"
             : refined == RefinedParameter::newton_tolerance ? "Newton tolerance"
                                                             : "time step (s)";
      picture.y_label      = "relative error";
      picture.marks_slopes = refined != RefinedParameter::time_tolerance &&
        refined != RefinedParameter::newton_tolerance;
      for (const Family &family : families)
        if (family.refinement->refined == refined)
          for (std::size_t q = 0; q < task.quantities.size(); ++q)
            {
              Curve curve;
              curve.title =
                family.refinement->title + ": " + task.quantities[q].name;
              curve.style.colour = colour_of(*family.refinement);
              curve.style.dashes = q;
              curve.style.marks  = q;
              for (std::size_t i = 0; i < family.refinement->runs.size(); ++i)
                {
                  const auto &error = family.errors[q].runs[i].error;
                  if (error && *error > 0)
                    curve.points.emplace_back(
                      coarseness(refined, family.refinement->runs[i]),
                      *error);
                }
              if (!curve.points.empty())
                picture.curves.push_back(curve);
            }
      return picture;
    }

    std::vector<Column> csv_columns(const StudyTask &task)
    {
      std::vector<Column> columns = {{"refined",
                                      "",
                                      "parameter that is refined in this row"},
                                     {"role", "", "run, or reference"}};
      for (const std::vector<Column> &some :
           {columns_of_settings(task.scene), columns_of_run()})
        columns.insert(columns.end(), some.begin(), some.end());
      for (const QuantityDefinition &quantity : task.quantities)
        {
          columns.push_back(
            {quantity.name + ".value", "", "value of a scalar quantity"});
          columns.push_back({quantity.name + ".error", "1", "relative error"});
          columns.push_back({quantity.name + ".observed_order",
                             "1",
                             "order relative to the previous run"});
          columns.push_back(
            {quantity.name + ".convergence_index",
             "1",
             "error bound from three runs, without a reference"});
        }
      return columns;
    }

    void add_csv_rows(const Family                          &family,
                      const Scene                           &scene,
                      std::vector<std::vector<std::string>> &rows)
    {
      const Refinement &refinement = *family.refinement;
      for (std::size_t i = 0; i < family.runs.size(); ++i)
        {
          const bool         is_run   = i < refinement.runs.size();
          const Settings    &settings = is_run
               ? refinement.runs[i]
               : refinement.references[i - refinement.runs.size()];
          const MeasuredRun &run      = family.runs[i];
          rows.push_back(
            {name_of(refinement.refined), is_run ? "run" : "reference"});
          for (const std::vector<std::string> &cells :
               {cells_of(settings, scene), cells_of(run)})
            rows.back().insert(rows.back().end(), cells.begin(), cells.end());
          for (const RefinementErrors &errors : family.errors)
            {
              const RunError one = is_run ? errors.runs[i] : RunError();
              for (const auto &number :
                   {one.value, one.error, one.order, one.convergence_index})
                rows.back().push_back(number_text(number));
            }
        }
    }

    /** Cheapest run of a family for an error. */
    struct CheapestRun
    {
      const Family *family;
      std::size_t   number;

      const Settings &settings() const
      {
        return family->refinement->runs[number];
      }

      double price() const
      {
        return family->runs[number].cpu_seconds;
      }
    };

    /**
     * Cheapest run that refines @p refined and has an error of at most @p
     * allowed; empty if there is none.
     */
    std::optional<CheapestRun> cheapest(const std::vector<Family> &families,
                                        const RefinedParameter     refined,
                                        const double               allowed)
    {
      std::vector<CheapestRun> runs;
      for (const Family &family : families)
        if (family.refinement->refined == refined)
          for (std::size_t i = 0; i < family.refinement->runs.size(); ++i)
            {
              const auto error = family.largest_error(i);
              if (error && *error <= allowed &&
                  family.largest_reference_error() <= allowed &&
                  family.runs[i].verdict == Verdict::sound)
                runs.push_back({&family, i});
            }
      return cheapest_of(
        runs,
        [](const CheapestRun &run) { return run.price(); },
        [](const CheapestRun &run) {
          return *run.family->largest_error(run.number);
        });
    }

    /** Copies the refined parameter of @p run to @p settings. */
    void copy_refined_value(const CheapestRun &run, Settings &settings)
    {
      const RefinedParameter refined      = run.family->refinement->refined;
      const Settings        &run_settings = run.settings();
      if (refined == RefinedParameter::time_tolerance)
        settings.time_tolerance = run_settings.time_tolerance;
      if (refined == RefinedParameter::newton_tolerance)
        settings.newton_tolerance = run_settings.newton_tolerance;
      if (refined == RefinedParameter::mesh ||
          refined == RefinedParameter::mesh_and_time_step)
        {
          settings.order       = run_settings.order;
          settings.refinements = run_settings.refinements;
        }
      if (refined == RefinedParameter::time_step ||
          refined == RefinedParameter::mesh_and_time_step)
        {
          settings.time_step = run_settings.time_step;
          settings.scheme    = run_settings.scheme;
        }
    }

    /** For an error of at most @p target, to which all that is refined has an
     * equal part. */
    std::optional<Recommendation> recommend(const std::vector<Family> &families,
                                            const Settings &scene_settings,
                                            const double    target)
    {
      std::vector<RefinedParameter> refined = refined_in(families);
      // Two ways to one end.
      if (std::find(refined.begin(),
                    refined.end(),
                    RefinedParameter::time_step) != refined.end())
        refined.erase(std::remove(refined.begin(),
                                  refined.end(),
                                  RefinedParameter::time_tolerance),
                      refined.end());
      Recommendation recommended{scene_settings, "errors by"};
      for (const RefinedParameter one : refined)
        {
          const auto run = cheapest(families, one, target / refined.size());
          if (!run)
            return {};
          copy_refined_value(*run, recommended.settings);
          recommended.remark += (one == refined.front() ? " " : ", ") +
            name_of(one) + " " +
            error_text(run->family->largest_error(run->number));
          if (const auto index = run->family->largest_index(run->number))
            recommended.remark +=
              " (convergence index " + error_text(index) + ")";
        }
      return recommended;
    }

    StudyReport report(const StudyTask                &task,
                       const std::vector<MeasuredRun> &runs,
                       StudyRuns & /*further*/)
    {
      const std::vector<Refinement> refinements = refinements_of(task.scene);
      const std::vector<Family> families = families_of(task, refinements, runs);
      StudyReport               report;
      report.columns = csv_columns(task);
      for (const Family &family : families)
        {
          report.text += "## Error by " + name_of(family.refinement->refined) +
            ": " + family.refinement->title + "\n\n" +
            table_of(family, task).markdown() + '\n' +
            reference_text(family, task) + failures_text(family) + '\n';
          add_csv_rows(family, task.scene, report.rows);
          for (std::size_t q = 0; q < family.errors.size(); ++q)
            if (!family.errors[q].is_resolved())
              add_finding(unresolved_finding(task.quantities[q]),
                          report.findings);
          if (!family.refinement->references.empty())
            add_finding_on_reference(family.runs.back(),
                                     "The reference for the " +
                                       name_of(family.refinement->refined),
                                     report.findings);
        }
      for (const RefinedParameter one : refined_in(families))
        report.pictures.push_back(picture_of(families, one, task));
      report.text +=
        "## What to take\n\nThe cheapest settings for an error, each refined "
        "alone:\n\n" +
        recommendations_text(task.scene, [&](const double target) {
          return recommend(families, settings_of(task.scene), target);
        });
      return report;
    }
  } // namespace

  StudyKind convergence_study()
  {
    std::vector<std::string> pictures;
    for (const RefinedParameter refined :
         {RefinedParameter::mesh,
          RefinedParameter::time_step,
          RefinedParameter::time_tolerance,
          RefinedParameter::newton_tolerance,
          RefinedParameter::mesh_and_time_step})
      pictures.push_back(picture_name(refined));
    return {"convergence", pictures, plan, report};
  }
} // namespace auxfem
