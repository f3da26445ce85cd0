#ifndef auxfem_reduced_cell_cell_output_h
#define auxfem_reduced_cell_cell_output_h

#include <auxfem/output/console.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/history.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/run_folder.h>
#include <auxfem/output/start_times.h>
#include <auxfem/reduced_cell/cell_scheme.h>
#include <auxfem/time/interruption.h>

#include <chrono>
#include <optional>

namespace auxfem
{
  /**
   * What a run of the reduced cell leaves behind, in one folder: original.prm,
   * parameters.prm, log.txt, history.csv with history.units.csv, summary.json;
   * and its lines on the screen. Made on all ranks, used on one.
   */
  class CellOutput : public Recorder
  {
  public:
    /**
     * @param scene must outlive the object.
     * @param start for the summary.
     * @param rules files that the scene was read from are always spared.
     */
    CellOutput(const Scene      &scene,
               const StartTimes &start,
               const FileRules  &rules);

    /**
     * Makes the folder, prints what is simulated, starts the history. Throws
     * InputError if the folder cannot be written to.
     */
    void begin_cell() override;

    /** A sample, in order, from the one at t = 0; a row when one is due. */
    void cell(const CellSample &sample) override;

    /** Closes the run: last row, summary.json. */
    void finish_cell(const RunResult &result) override;

  private:
    using Clock = std::chrono::steady_clock;

    void        write_row(const CellSample &sample);
    std::string summary(const RunResult &result) const;

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

  /** What CellOutput::begin() prints: the cell, what is simulated, the scheme.
   */
  std::string cell_overview_text(const Scene &scene);
} // namespace auxfem

#endif
