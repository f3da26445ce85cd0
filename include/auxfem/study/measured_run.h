#ifndef auxfem_study_measured_run_h
#define auxfem_study_measured_run_h

#include <auxfem/output/recorder.h>
#include <auxfem/parameters/text.h>
#include <auxfem/scene/scene.h>
#include <auxfem/study/recorded_history.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace auxfem
{
  /** What of a simulation a study wants to know. */
  struct Selection
  {
    std::set<std::string> columns; ///< of history.csv
    /** Times of the scene's steps, for fields (s). */
    std::set<double> field_times;
  };

  /** One simulation of a study: what it gave and what it took. */
  struct MeasuredRun
  {
    /** `completed` or the reason it was not. */
    std::string   exit_state;
    Verdict       verdict  = Verdict::sound;
    unsigned long unknowns = 0; ///< 0: not known, as it failed at once
    unsigned long steps = 0, iterations = 0, factorizations = 0;
    /** Of all ranks together, without the start of the program (s); the least
     * of all repetitions. */
    double cpu_seconds  = 0;
    double wall_seconds = 0;
    /** The longest of all repetitions (s). */
    double       most_cpu_seconds = 0;
    unsigned int repetitions      = 1;
    /** Peak of the process, or sum over the ranks' (bytes). */
    unsigned long memory = 0;
    /** The columns of history.csv that were asked for, and `time`. */
    std::map<std::string, std::vector<double>> columns;
    /** The fields that were asked for, by time (s). */
    std::map<double, RecordedField> fields;

    bool completed() const
    {
      return exit_state == "completed";
    }

    /** Takes note of the times of the same simulation once more. */
    void add_repetition(const MeasuredRun &again);

    /** How much longer than the shortest the longest repetition took, relative;
     * none of a single one. */
    std::optional<double> spread() const;

    /** Whether all of @p selection is there. */
    bool has(const Selection &selection) const;

    /** One of the columns over time. */
    RecordedHistory history(const std::string &column) const;
  };

  Json        json_of(const MeasuredRun &run);
  MeasuredRun measured_run_of(const Json &json);

  /** How much of a run is done, in [0, 1]. */
  using FractionDone = std::function<void(double)>;

  /**
   * Computes @p scene and writes nothing. A computation that fails is noted in
   * the result. Throws InputError and Interrupted. Collective.
   * @param selection what is kept; of columns those that there are.
   */
  MeasuredRun measure_run(const Scene        &scene,
                          MPI_Comm            communicator,
                          const Selection    &selection,
                          const FractionDone &progress);

  /** The names of the columns that the history of @p scene has. Collective;
   * finds what the set-up shows to be wrong with the scene (InputError). */
  std::vector<std::string> history_columns(const Scene &scene,
                                           MPI_Comm     communicator);

  /**
   * All that the result of a simulation of @p scene on @p n_ranks ranks depends
   * on: program, parameters, files that are read. Output, Study and Quantities
   * do not belong to it.
   */
  std::string key_of(const Scene &scene, unsigned int n_ranks);

  /** The run of @p key in @p folder, unless it was never finished there or is
   * not readable. */
  std::optional<MeasuredRun> kept_run(const std::string &folder,
                                      const std::string &key);

  /**
   * Writes @p run, in one move, to where kept_run() finds it. Throws
   * ComputationError if it cannot.
   */
  void keep_run(const std::string &folder,
                const std::string &key,
                const MeasuredRun &run);
} // namespace auxfem

#endif
