#ifndef auxfem_study_measured_run_h
#define auxfem_study_measured_run_h

#include <auxfem/figures/recorded_history.h>
#include <auxfem/output/recorder.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>
#include <auxfem/study/recorded_field.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace auxfem
{
  /** Columns and fields of a simulation that a study records. */
  struct Selection
  {
    std::set<std::string> columns; ///< of history.csv
    /** Times of the scene's steps, for fields (s). */
    std::set<double> field_times;
  };

  /** Results and cost of one simulation of a study. */
  struct MeasuredRun
  {
    /** `completed`, or the reason of the failure. */
    std::string   exit_state;
    Verdict       verdict  = Verdict::sound;
    unsigned long unknowns = 0; ///< 0: unknown after an early failure
    unsigned long steps = 0, iterations = 0, factorizations = 0;
    /**
     * Processor time summed over ranks (s), without program start; minimum of
     * all repetitions.
     */
    double cpu_seconds  = 0;
    double wall_seconds = 0;
    /** Maximum of all repetitions (s). */
    double       max_cpu_seconds = 0;
    unsigned int repetitions     = 1;
    /** Peak memory, summed over ranks (bytes). */
    unsigned long memory = 0;
    /** Selected columns of history.csv, and `time`. */
    std::map<std::string, std::vector<double>> columns;
    /** Selected fields, by time (s). */
    std::map<double, RecordedField> fields;

    bool completed() const
    {
      return exit_state == "completed";
    }

    /** Merges the times of a repetition. */
    void add_repetition(const MeasuredRun &repetition);

    /**
     * Relative excess of the longest over the shortest repetition; empty for a
     * single one.
     */
    std::optional<double> spread() const;

    /** Whether all of @p selection is recorded. */
    bool has(const Selection &selection) const;

    /** History of one column. */
    RecordedHistory history(const std::string &column) const;
  };

  Json        json_of(const MeasuredRun &run);
  MeasuredRun measured_run_of(const Json &json);

  /** Receives the completed fraction of a run, in [0, 1]. */
  using FractionDone = std::function<void(double)>;

  /**
   * Computes @p scene without output. The result reports a failed computation.
   * Throws InputError and Interrupted. Collective.
   * @param selection data to record; missing columns are ignored
   */
  MeasuredRun measure_run(const Scene        &scene,
                          MPI_Comm            communicator,
                          const Selection    &selection,
                          const FractionDone &progress);

  /**
   * Names of the history columns of @p scene. Throws InputError for errors
   * found during set-up. Collective.
   */
  std::vector<std::string> history_columns(const Scene &scene,
                                           MPI_Comm     communicator);

  /** Contents of @p file; empty if it cannot be read. */
  std::string contents(const std::string &file);

  /**
   * Key of a simulation of @p scene on @p n_ranks ranks: program version,
   * parameters and input files. Output, Study and Quantities have no influence.
   */
  std::string key_of(const Scene &scene, unsigned int n_ranks);

  /**
   * Loads the run of @p key from @p folder; empty if it is missing or
   * unreadable.
   */
  std::optional<MeasuredRun> load_run(const std::string &folder,
                                      const std::string &key);

  /**
   * Stores @p run atomically for load_run(). Throws ComputationError on
   * failure.
   */
  void store_run(const std::string &folder,
                 const std::string &key,
                 const MeasuredRun &run);
} // namespace auxfem

#endif
