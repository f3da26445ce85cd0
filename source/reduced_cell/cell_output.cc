#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/output/summary.h>
#include <auxfem/reduced_cell/cell_history.h>
#include <auxfem/reduced_cell/cell_output.h>
#include <auxfem/reduced_cell/cell_run.h>
#include <auxfem/reduced_cell/cell_scheme.h>
#include <auxfem/time/interruption.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    /** See make_cell_output(). */
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
        const std::string &folder = scene.output.directory;
        files.emplace(scene, rules);
        console.emplace(std::cout,
                        terminal_width(/*n_processes=*/1),
                        files->log());
        console->print(cell_overview_text(scene));
        const std::vector<Column> columns = cell_columns();
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
        replace_file(scene.output.directory + "/summary.json", summary(result));

        std::ostringstream text;
        text << (result.completed() ? "Completed" : "Stopped early");
        if (latest)
          text << " at t = " << latest->time << " s: theta "
               << degrees(latest->angle) << " deg, Y2 " << latest->lower_rise
               << " m, f2 " << latest->transmitted << " N (largest "
               << largest_transmitted << " N)";
        console->print(text.str());
        console->print(closing_energies_text(energies, scene.output.directory));
        console->print(verdict_text(result.findings));
        if (!result.completed())
          console->print_to_log("Reason: " + result.exit_state);
      }

    private:
      using Clock = std::chrono::steady_clock;

      void write_row(const CellSample &sample)
      {
        // What cannot be written is not tried again at the end of the run.
        latest_row = sample;
        table->append(cell_values(sample, energies));
      }

      std::string summary(const RunResult &result) const
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
        return json_text(json) + '\n';
      }

      const Scene            &scene;
      const StartTimes        start_times;
      const FileRules         rules;
      const Clock::time_point start;
      /** What was begun is closed, also if a signal asks for the end. */
      SignalsWaitForStep        signals;
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
} // namespace auxfem
