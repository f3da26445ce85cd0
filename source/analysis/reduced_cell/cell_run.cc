#include <auxfem/analysis/reduced_cell/cell_run.h>
#include <auxfem/analysis/reduced_cell/cell_scheme.h>
#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/history.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/overview.h>
#include <auxfem/output/summary.h>
#include <auxfem/output/verdict.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/interruption.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  std::vector<Column> cell_columns()
  {
    std::vector<Column> columns = {
      {"time", "s", "time"},
      {"theta", "rad", "angle of the bars against the horizontal"},
      {"Y1", "m", "rise of the upper part, extension of the connector"},
      {"Y2", "m", "rise of the lower part"},
      {"f1", "N", "load on the upper part, positive downwards"},
      {"f2", "N", "force on the foundation, positive in compression"}};
    for (const Column &column : energy_columns(cell_energies().ledger()))
      columns.push_back(column);
    return columns;
  }

  std::vector<double> cell_values(const CellSample   &sample,
                                  const EnergyRecord &energies)
  {
    std::vector<double> row = {sample.time,
                               sample.angle,
                               sample.upper_rise,
                               sample.lower_rise,
                               sample.load,
                               sample.transmitted};
    for (const double energy : energy_values(energies))
      row.push_back(energy);
    return row;
  }

  namespace
  {
    /** Output folder and console of a run of the reduced cell. */
    class CellOutput : public CellRecorder
    {
    public:
      CellOutput(const Scene &scene, const FolderOptions &options)
        : scene(scene)
        , start_times(options.start)
        , rules(options.rules)
        , start(Clock::now())
      {}

      void begin() override
      {
        const std::string        &folder  = scene.output.directory;
        const std::vector<Column> columns = cell_columns();
        // A mistake must not destroy the results of an earlier run.
        require_quantities(scene, names_of(columns));
        files.emplace(scene, rules);
        console.emplace(std::cout,
                        terminal_width(/*n_processes=*/1),
                        files->log());
        console->print(cell_overview_text(scene));
        table.emplace(folder + "/history.csv", columns);
        write_column_reference(folder + "/history.units.csv", columns);
      }

      void sample(const CellSample &sample) override
      {
        energies.add(sample.energies);
        largest_transmitted =
          std::max(largest_transmitted, std::abs(sample.transmitted));
        latest = sample;
        if (n_samples++ % scene.output.history_interval == 0)
          write_row(sample);
      }

      void finish(const RunResult &result) override
      {
        if (latest && latest->time != latest_row->time)
          write_row(*latest);
        const NamedResults quantities =
          quantities_in(scene,
                        read_table(scene.output.directory + "/history.csv"));
        replace_file(scene.output.directory + "/summary.json",
                     summary(result, quantities));

        std::ostringstream text;
        text << (result.completed() ? "Completed" : "Stopped early");
        if (latest)
          text << " at t = " << latest->time << " s: theta "
               << degrees(latest->angle) << " deg, Y2 " << latest->lower_rise
               << " m, f2 " << latest->transmitted << " N (largest "
               << largest_transmitted << " N)";
        console->print(text.str());
        console->print(text_of_quantities(quantities, scene, cell_columns()) +
                       closing_energies_text(energies, scene.output.directory));
        console->print(verdict_text(result.findings));
        if (!result.completed())
          console->print_to_log("Reason: " + result.exit_state);
      }

    private:
      using Clock = std::chrono::steady_clock;

      void write_row(const CellSample &sample)
      {
        // A row that cannot be written is not retried at the end of the run.
        latest_row = sample;
        table->append(cell_values(sample, energies));
      }

      std::string summary(const RunResult    &result,
                          const NamedResults &quantities) const
      {
        Json json = json_of_run(scene, result.exit_state, result.time);
        add_verdict(json, result.findings);
        json["model"]            = "reduced cell";
        json["scheme"]           = scene.time.scheme->name();
        json["connector_groups"] = names_of_groups(scene.connectors);
        json["work"]             = {{"steps", result.work.steps},
                                    {"iterations_or_evaluations", result.work.iterations}};
        json["wall_seconds"]     = {
              {"program_start", start_times.program},
              {"mpi_start", start_times.mpi},
              {"total",
               std::chrono::duration<double>(Clock::now() - start).count()}};
        json["energies_joule"] = json_of_energies(energies);
        if (latest)
          {
            json["theta_radian"] = latest->angle;
            json["Y1_metre"]     = latest->upper_rise;
            json["Y2_metre"]     = latest->lower_rise;
            json["f2_newton"]    = latest->transmitted;
          }
        json["largest_f2_newton"] = largest_transmitted;
        if (!quantities.empty())
          json["quantities"] = json_of_quantities(quantities);
        return json_text(json) + '\n';
      }

      const Scene            &scene;
      const StartTimes        start_times;
      const FileRules         rules;
      const Clock::time_point start;
      /** Delays signals so that open files are completed. */
      DeferredSignals           signals;
      std::optional<RunFolder>  files;
      std::optional<Console>    console;
      std::optional<CsvTable>   table;
      EnergyRecord              energies;
      std::optional<CellSample> latest, latest_row;
      unsigned long             n_samples           = 0;
      double                    largest_transmitted = 0; ///< N
    };
  } // namespace

  std::string cell_overview_text(const Scene &scene)
  {
    const ReducedCellDefinition &cell = *scene.reduced_cell;
    const TimeSchemeEntry &entry = time_scheme_entry(scene.time.scheme->name());
    std::ostringstream     text;
    text
      << heading_text(scene) << "\n\n"
      << "  Reduced cell: bars of " << cell.bar_length << " m and "
      << cell.bar_mass << " kg at " << degrees(cell.angle) << " deg, parts of "
      << cell.part_mass << " kg\n"
      << "  Scheme: " << entry.name << ", " << entry.description << '\n'
      << "  Steps: " << scene.time.n_steps() << " of " << scene.time.step
      << " s\n\n"
      << "Simulated\n"
      << "  large rotations and inertia of the six rigid parts, the load, "
         "the connector \""
      << scene.connectors.front().name << "\"\n\n"
      << "Left out\n"
      << "  deformation of the parts, friction, weight, contact, the springs "
         "that set the angle at rest\n";
    return text.str();
  }

  RunResult run_reduced_cell(const Scene &scene, const FolderOptions &options)
  {
    CellOutput output(scene, options);
    return run_reduced_cell(scene, output);
  }

  RunResult run_reduced_cell(const Scene &scene, CellRecorder &recorder)
  {
    const std::unique_ptr<CellScheme> scheme = make_cell_scheme(scene);
    RunResult                         result;
    EnergyJudgement judgement(EnergyJudgement::Kind::reduced_cell);
    const auto      record = [&](const CellSample &sample) {
      result.time = sample.time;
      judgement.add(sample.energies, sample.time);
      recorder.sample(sample);
    };
    const auto finish = [&](const std::string &exit_state) {
      result.exit_state      = exit_state;
      result.work.iterations = scheme->work();
      for (const Finding &finding : judgement.findings())
        result.findings.push_back(finding);
      recorder.finish(result);
    };
    recorder.begin();
    try
      {
        const CellSample at_start = scheme->start();
        judgement.start(at_start.energies);
        record(at_start);
        for (; result.work.steps < scene.time.n_steps(); ++result.work.steps)
          {
            end_if_interrupted(MPI_COMM_SELF);
            record(scheme->advance());
          }
      }
    catch (const std::exception &failure)
      {
        result.findings = {result.work.steps == 0
                             ? nothing_computed(result.time)
                             : incomplete(result.time)};
        finish(failure.what());
        throw;
      }
    finish("completed");
    return result;
  }

  void check_reduced_cell(const Scene &scene)
  {
    // The first sample detects loads that are not finite.
    make_cell_scheme(scene)->start();
    std::cout << cell_overview_text(scene) << std::flush;
  }

  CellHistory compute_history(const Scene &scene)
  {
    CellHistory history;
    try
      {
        run_reduced_cell(scene, history);
      }
    catch (const InputError &error)
      {
        history.exit_state = error.what();
      }
    catch (const ComputationError &)
      {
        // The exit state of the history contains the reason.
      }
    return history;
  }

  namespace
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    double largest(const CellHistory &history, double CellSample::*quantity)
    {
      double result = 0;
      for (const CellSample &sample : history.samples)
        result = std::max(result, std::abs(sample.*quantity));
      return result;
    }

    /**
     * Largest difference over the largest value of the reference; NaN unless
     * both runs have completed.
     */
    double difference(const CellHistory &history,
                      const CellHistory &reference,
                      double CellSample::*quantity)
    {
      if (history.exit_state != "completed" ||
          reference.exit_state != "completed")
        return unknown;
      double result = 0;
      for (std::size_t i = 0; i < reference.samples.size(); ++i)
        {
          const double deviation = std::abs(history.samples[i].*quantity -
                                            reference.samples[i].*quantity);
          if (std::isnan(deviation))
            return unknown;
          result = std::max(result, deviation);
        }
      const double scale = largest(reference, quantity);
      return scale > 0 ? result / scale : unknown;
    }

    double relative_balance(const CellHistory &history)
    {
      EnergyRecord record;
      for (const CellSample &sample : history.samples)
        record.add(sample.energies);
      return record.relative(record.largest_balance);
    }

    /** Time history of @p scene computed with the scheme @p name. */
    CellHistory history_with(const std::string &name, const Scene &scene)
    {
      try
        {
          return compute_history(read_scene_from_text(scene.all_parameters,
                                                      scene.file,
                                                      {"Time/Scheme=" + name}));
        }
      catch (const InputError &error)
        {
          CellHistory none;
          none.exit_state = error.what();
          return none;
        }
    }

    /** All schemes for reduced cells, the reference first. */
    std::vector<std::string> compared_schemes()
    {
      std::vector<std::string> names = {arkode_entry().name};
      for (const TimeSchemeEntry &entry : time_scheme_registry())
        if (entry.serves(Model::reduced_cell) && entry.name != names.front())
          names.push_back(entry.name);
      return names;
    }

    ComparisonRow make_row(const Scene       &scene,
                           const std::string &scheme,
                           const CellHistory &history,
                           const CellHistory &reference)
    {
      ComparisonRow row;
      row.name               = std::filesystem::path(scene.file).stem();
      row.scheme             = scheme;
      row.exit_state         = history.exit_state;
      const bool has_samples = !history.samples.empty();
      row.angle = has_samples ? history.samples.back().angle : unknown;
      row.lower_rise =
        has_samples ? history.samples.back().lower_rise : unknown;
      row.transmitted =
        has_samples ? history.samples.back().transmitted : unknown;
      row.largest_transmitted =
        has_samples ? largest(history, &CellSample::transmitted) : unknown;
      row.relative_balance = has_samples ? relative_balance(history) : unknown;
      row.angle_difference = difference(history, reference, &CellSample::angle);
      row.transmitted_difference =
        difference(history, reference, &CellSample::transmitted);
      return row;
    }

    const std::vector<Column> columns = {
      {"case", "", "parameter file"},
      {"scheme", "", "Time/Scheme"},
      {"theta_end", "deg", "angle at the end"},
      {"Y2_end", "m", "rise of the lower part at the end"},
      {"f2_end", "N", "force on the foundation at the end"},
      {"f2_largest", "N", "its largest size"},
      {"relative_balance", "1", "error of the energy balance"},
      {"theta_difference", "1", "largest difference from arkode"},
      {"f2_difference", "1", "largest difference from arkode"},
      {"exit", "", "completed, or why it ended early"}};

    std::vector<std::string> cells_of(const ComparisonRow &row)
    {
      const auto number = [](const char *pattern, const double value) {
        char text[40];
        std::snprintf(text, sizeof(text), pattern, value);
        return std::string(std::isnan(value) ? "nan" : text);
      };
      return {row.name,
              row.scheme,
              number("%.9g", degrees(row.angle)),
              number("%.9g", row.lower_rise),
              number("%.9g", row.transmitted),
              number("%.9g", row.largest_transmitted),
              number("%.2e", row.relative_balance),
              number("%.2e", row.angle_difference),
              number("%.2e", row.transmitted_difference),
              row.exit_state};
    }

    /** One line of the table on the screen. */
    void print(const std::vector<std::string> &cells)
    {
      static const std::vector<int> widths =
        {-16, -19, 14, 15, 14, 14, 17, 17, 14};
      for (unsigned int i = 0; i < widths.size(); ++i)
        std::cout << (widths[i] < 0 ? std::left : std::right)
                  << std::setw(std::abs(widths[i])) << cells[i] << ' ';
      // Only the first line of a reason fits the table.
      const std::string &last = cells.back();
      std::cout << ' ' << last.substr(0, last.find('\n')) << '\n' << std::right;
    }
  } // namespace

  std::vector<ComparisonRow> compare_schemes(const Scene &scene)
  {
    std::vector<ComparisonRow> rows;
    CellHistory                reference;
    for (const std::string &scheme : compared_schemes())
      {
        const CellHistory history = history_with(scheme, scene);
        if (rows.empty())
          reference = history;
        rows.push_back(make_row(scene, scheme, history, reference));
      }
    return rows;
  }

  void run_comparison(const std::vector<Scene> &scenes,
                      const std::string        &folder,
                      const FileRules          &rules)
  {
    for (const Scene &scene : scenes)
      if (scene.context.model != Model::reduced_cell)
        throw InputError(scene.file +
                         ": --compare is for scenes with Model = reduced cell");
    FileRules with_inputs = rules;
    for (const Scene &scene : scenes)
      with_inputs = with_inputs_of(scene, with_inputs);
    const OutputFolder claim(folder,
                             {{"comparison.csv", "comparison.units.csv"}, {}},
                             with_inputs);
    const std::string  file = folder + "/comparison.csv";
    CsvTable           table(file, columns);
    write_column_reference(folder + "/comparison.units.csv", columns);

    std::vector<std::string> names;
    names.reserve(columns.size());
    for (const Column &column : columns)
      names.push_back(column.name +
                      (column.unit.empty() ? "" : " (" + column.unit + ")"));
    print(names);
    for (const Scene &scene : scenes)
      for (const ComparisonRow &row : compare_schemes(scene))
        {
          const std::vector<std::string> cells = cells_of(row);
          print(cells);
          table.append_text(cells);
        }
    std::cout << "The table is in " << file << std::endl;
  }
} // namespace auxfem
