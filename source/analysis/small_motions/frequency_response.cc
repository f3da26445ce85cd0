#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/small_motions/frequency_response.h>
#include <auxfem/analysis/small_motions/harmonic_response.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/first_rank.h>
#include <auxfem/output/history.h>
#include <auxfem/output/run_output.h>
#include <auxfem/output/run_report.h>
#include <auxfem/time/interruption.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

namespace auxfem
{
  namespace
  {
    const std::string table_name = "frequency_response.csv";

    /** @p scene at rest at t = 0, with all its damping. */
    Scene vibrating(Scene scene)
    {
      scene.time.static_start = scene.frequency_response.about_equilibrium;
      scene.initial_velocities.clear();
      include_damping(scene);
      return scene;
    }

    std::vector<Column> columns_of(const std::vector<Column> &quantities)
    {
      std::vector<Column> columns = {{"frequency", "Hz", "of the loads"}};
      for (const Column &quantity : quantities)
        {
          columns.push_back({quantity.name + ".amplitude",
                             quantity.unit,
                             quantity.meaning + ", amplitude"});
          columns.push_back({quantity.name + ".phase",
                             "rad",
                             "by which it is ahead of the loads"});
        }
      columns.push_back(
        {"residual", "1", "what is left of the equations of motion"});
      return columns;
    }

    /** Largest amplitudes so far, by quantity. */
    class Peaks
    {
    public:
      explicit Peaks(const std::vector<Column> &quantities)
        : quantities(quantities)
        , amplitudes(quantities.size(), 0.)
        , frequencies(quantities.size(), 0.)
      {}

      void add(const double frequency, const std::vector<double> &row)
      {
        for (unsigned int i = 0; i < amplitudes.size(); ++i)
          if (row[1 + 2 * i] > amplitudes[i])
            {
              amplitudes[i]  = row[1 + 2 * i];
              frequencies[i] = frequency;
            }
      }

      std::string text() const
      {
        std::ostringstream text;
        text << "  largest amplitudes";
        for (unsigned int i = 0; i < amplitudes.size(); ++i)
          text << '\n'
               << "  " << std::setw(20) << std::left << quantities[i].name
               << std::right << std::setprecision(5) << std::setw(14)
               << amplitudes[i] << ' ' << quantities[i].unit << " at "
               << frequencies[i] << " Hz";
        return text.str();
      }

      Json json() const
      {
        Json peaks = Json::array();
        for (unsigned int i = 0; i < amplitudes.size(); ++i)
          peaks.push_back({{"quantity", quantities[i].name},
                           {"amplitude", amplitudes[i]},
                           {"frequency_hertz", frequencies[i]}});
        return peaks;
      }

    private:
      const std::vector<Column> quantities;
      std::vector<double>       amplitudes, frequencies;
    };

    std::vector<double> row_of(const double             frequency,
                               const HarmonicVibration &vibration,
                               const History           &history)
    {
      const std::vector<double> real =
        history.sums(vibration.displacement.real, vibration.reaction.real);
      const std::vector<double> imaginary =
        history.sums(vibration.displacement.imaginary,
                     vibration.reaction.imaginary);
      std::vector<double> row = {frequency};
      for (unsigned int i = 0; i < real.size(); ++i)
        {
          row.push_back(std::hypot(real[i], imaginary[i]));
          row.push_back(std::atan2(imaginary[i], real[i]));
        }
      row.push_back(vibration.residual);
      return row;
    }
  } // namespace

  FolderContents frequency_response_contents()
  {
    return {{table_name, "frequency_response.units.csv"}, {}};
  }

  RunResult run_frequency_response(const Scene     &given,
                                   const MPI_Comm   communicator,
                                   const FileRules &rules)
  {
    const Scene scene = vibrating(given);
    LatticeRun  run(scene, communicator);
    // Mistakes it finds must not cost the results of an earlier run.
    refuse_columns_of_nothing(scene, run.lattice);
    run.prepare();
    if (scene.time.static_start)
      run.start();
    HarmonicResponse          response(run.solver(), run.solution.state);
    const History             history(scene, run.equations, communicator);
    const std::vector<Column> quantities = history.sum_columns();
    const SignalsWaitForStep  signals;
    RunReport                 report(scene,
                     run.equations,
                     rules,
                     frequency_response_contents());
    std::optional<CsvTable>   table;
    const std::string        &folder = scene.output.directory;
    on_first_rank(communicator, [&]() {
      table.emplace(folder + "/" + table_name, columns_of(quantities));
      write_column_reference(folder + "/frequency_response.units.csv",
                             columns_of(quantities));
    });

    Peaks peaks(quantities);
    for (const double frequency : scene.frequency_response.frequencies())
      {
        end_if_interrupted(communicator);
        const std::vector<double> row =
          row_of(frequency,
                 response.at(2 * dealii::numbers::PI * frequency),
                 history);
        peaks.add(frequency, row);
        on_first_rank(communicator, [&]() { table->append(row); });
      }

    RunResult result;
    result.exit_state = "completed";
    result.work       = run.work();
    on_first_rank(communicator, [&]() {
      report.print(peaks.text());
      std::ostringstream work;
      work << "  " << run.work().factorizations << " factorizations, "
           << run.work().linear_solutions << " solutions by "
           << run.work().linear_solver;
      report.print(work.str());
      report.finish({{"largest_amplitudes", peaks.json()}}, result.findings);
    });
    return result;
  }

  void check_frequency_response(const Scene &given, const MPI_Comm communicator)
  {
    const Scene scene = vibrating(given);
    LatticeRun  run(scene, communicator);
    refuse_columns_of_nothing(scene, run.lattice);
    run.prepare();
    print_overview(scene, run.equations);
  }
} // namespace auxfem
