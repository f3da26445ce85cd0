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

  /** The numbers in these columns, @p energies those up to @p sample. */
  std::vector<double> cell_values(const CellSample   &sample,
                                  const EnergyRecord &energies);

  /**
   * Computes the reduced cell on the calling rank and leaves one folder:
   * original.prm, parameters.prm, log.txt, history.csv with history.units.csv,
   * summary.json; and lines on the screen. Throws InputError, also if the
   * folder cannot be written to, and ComputationError.
   * @param options files that the scene was read from are always spared
   */
  RunResult run_reduced_cell(const Scene &scene, const FolderOptions &options);

  /** The first lines of a run: the cell, what is simulated, the scheme. */
  std::string cell_overview_text(const Scene &scene);

  /** Receives the samples of a run of the reduced cell. */
  class CellRecorder
  {
  public:
    virtual ~CellRecorder() = default;

    /** Before the first sample. */
    virtual void begin()
    {}

    /** Samples in order, from the one at t = 0. */
    virtual void sample(const CellSample &sample) = 0;

    /** After the last sample, also after a failure. */
    virtual void finish(const RunResult & /*result*/)
    {}
  };

  /**
   * Computes the reduced cell on the calling rank. Throws InputError or
   * ComputationError; @p recorder has then received all samples.
   */
  RunResult run_reduced_cell(const Scene &scene, CellRecorder &recorder);

  /** The dry run of --check: prints what is simulated, writes nothing. */
  void check_reduced_cell(const Scene &scene);

  /** Keeps the time history of a cell in memory. */
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
    /** `completed`, or why it ended early. */
    std::string exit_state;
  };

  /** Computes @p scene and writes nothing; failures are in the exit state. */
  CellHistory compute_history(const Scene &scene);

  /** One scheme on one scene, beside the reference. */
  struct ComparisonRow
  {
    std::string name;   ///< of the scene's file, without folder and ending
    std::string scheme; ///< as in Time/Scheme
    /** At the end, or where the scheme failed; no numbers if it never began. */
    double angle               = 0; ///< theta (rad)
    double lower_rise          = 0; ///< Y2 (m)
    double transmitted         = 0; ///< f2 (N)
    double largest_transmitted = 0; ///< |f2| (N)
    /** Largest error of the energy balance, of the largest energy. */
    double relative_balance = 0;
    /** Largest differences from the reference, of its largest values. */
    double      angle_difference = 0, transmitted_difference = 0;
    std::string exit_state;
  };

  /**
   * Computes @p scene with every scheme of the table; the first one, arkode, is
   * the reference. Failures are in the rows.
   */
  std::vector<ComparisonRow> compare_schemes(const Scene &scene);

  /**
   * Compares the schemes on every one of @p scenes, prints a table and writes
   * it to @p folder/comparison.csv. On the calling rank. Throws InputError for
   * scenes of other models and for a folder that cannot be used, see
   * OutputFolder.
   */
  void run_comparison(const std::vector<Scene> &scenes,
                      const std::string        &folder,
                      const FileRules          &rules);
} // namespace auxfem

#endif
