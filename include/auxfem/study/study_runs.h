#ifndef auxfem_study_study_runs_h
#define auxfem_study_study_runs_h

#include <auxfem/study/measured_run.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A simulation of a study. */
  struct PlannedRun
  {
    std::string name; ///< for display
    Scene       scene;
    /**
     * Number of computations, of which the fastest counts. Repeated simulations
     * run alone on all ranks.
     */
    unsigned int repetitions = 1;

    /** Estimated cost in arbitrary units. */
    double price() const;
  };

  /** Progress of the simulations of a study. */
  struct StudyProgress
  {
    std::size_t number = 0; ///< number of the current run, from 1
    std::size_t total  = 0;
    std::string name;
    double      fraction = 0; ///< completed fraction of the study, by cost

    /** Result of the run, once it has ended. */
    std::optional<MeasuredRun> result;
    /** Whether the run was loaded from the folder. */
    bool is_reused = false;
  };

  /**
   * Computes the simulations of studies and stores their results in a folder,
   * from which an interrupted or later study loads them.
   */
  class StudyRuns
  {
  public:
    using Listener = std::function<void(const StudyProgress &)>;

    /**
     * @param folder for stored runs; empty: none are stored
     * @param selection data to record
     * @param listener receives the progress on the first rank
     */
    StudyRuns(MPI_Comm           communicator,
              const std::string &folder,
              Selection          selection,
              Listener           listener);

    /**
     * Results of @p plan in its order, the same on all ranks. Without
     * repetitions and with at least as many runs as ranks, each run uses one
     * rank; otherwise runs use all ranks in turn. Throws InputError for an
     * invalid run, and Interrupted; results include failed computations.
     * Collective.
     */
    std::vector<MeasuredRun> compute(const std::vector<PlannedRun> &plan);

  private:
    struct Task;

    void load_stored_runs(std::vector<Task> &tasks) const;
    void compute_in_turn(std::vector<Task> &tasks);
    void compute_side_by_side(std::vector<Task> &tasks);
    void measure(Task &task, MPI_Comm on_ranks);
    void report(const Task &task, bool is_reused);

    const MPI_Comm    communicator;
    const std::string folder;
    const Selection   selection;
    const Listener    listener;
    StudyProgress     progress; ///< of this call of compute()
    double            price_done = 0, price_in_all = 0;
  };
} // namespace auxfem

#endif
