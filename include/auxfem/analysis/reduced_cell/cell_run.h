#ifndef auxfem_analysis_reduced_cell_cell_run_h
#define auxfem_analysis_reduced_cell_cell_run_h

#include <auxfem/analysis/reduced_cell/cell_scheme.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/output/output_folder.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** Columns of history.csv for the reduced cell: its CellSample and its
   * energies. */
  std::vector<Column> cell_columns();

  /**
   * The numbers in these columns; @p energies covers all samples up to @p
   * sample.
   */
  std::vector<double> cell_values(const CellSample   &sample,
                                  const EnergyRecord &energies);

  /**
   * Computes the reduced cell on the calling rank and writes one folder:
   * original.prm, parameters.prm, log.txt, history.csv with history.units.csv,
   * summary.json. Throws InputError, also if the folder is not writable, and
   * ComputationError.
   * @param options files that the scene was read from are always kept
   */
  RunResult run_reduced_cell(const Scene &scene, const FolderOptions &options);

  /** First lines of a run: cell, simulated effects, scheme. */
  std::string cell_overview_text(const Scene &scene);

  /** Receives the samples of a reduced-cell run. */
  class CellRecorder
  {
  public:
    virtual ~CellRecorder() = default;

    /** Called before the first sample. */
    virtual void begin()
    {}

    /** Called for each sample in order, from t = 0. */
    virtual void sample(const CellSample &sample) = 0;

    /** Called after the last sample, also after a failure. */
    virtual void finish(const RunResult & /*result*/)
    {}
  };

  /**
   * Computes the reduced cell on the calling rank. Throws InputError or
   * ComputationError; @p recorder has then received all samples.
   */
  RunResult run_reduced_cell(const Scene &scene, CellRecorder &recorder);

  /** Dry run of --check: prints the overview and writes nothing. */
  void check_reduced_cell(const Scene &scene);

  /** Stores the time history of a cell in memory. */
  struct CellHistory : public CellRecorder
  {
    void sample(const CellSample &sample) override
    {
      samples.push_back(sample);
    }

    void finish(const RunResult &result) override
    {
      exit_state = result.exit_state;
    }

    std::vector<CellSample> samples;
    /** `completed`, or the reason of an early end. */
    std::string exit_state;
  };

  /** Computes @p scene without output; the exit state reports failures. */
  CellHistory compute_history(const Scene &scene);

  /** Result of one scheme on one scene, compared with the reference. */
  struct ComparisonRow
  {
    std::string name;   ///< of the scene's file, without folder and ending
    std::string scheme; ///< as in Time/Scheme
    /** Values at the end or at a failure; NaN if the scheme did not start. */
    double angle               = 0; ///< theta (rad)
    double lower_rise          = 0; ///< Y2 (m)
    double transmitted         = 0; ///< f2 (N)
    double largest_transmitted = 0; ///< |f2| (N)
    /** Largest error of the energy balance over the largest energy. */
    double relative_balance = 0;
    /** Largest differences from the reference over its largest values. */
    double      angle_difference = 0, transmitted_difference = 0;
    std::string exit_state;
  };

  /**
   * Computes @p scene with every registered scheme; the first one, arkode, is
   * the reference. The rows report failures.
   */
  std::vector<ComparisonRow> compare_schemes(const Scene &scene);

  /**
   * Compares the schemes on each of @p scenes, prints a table and writes it to
   * @p folder/comparison.csv. Called on one rank. Throws InputError for scenes
   * of other models and for an unusable folder (OutputFolder).
   */
  void run_comparison(const std::vector<Scene> &scenes,
                      const std::string        &folder,
                      const FileRules          &rules);
} // namespace auxfem

#endif
