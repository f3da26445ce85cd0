#ifndef auxfem_study_study_runs_h
#define auxfem_study_study_runs_h

#include <auxfem/study/measured_run.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A simulation that a study wants. */
  struct PlannedRun
  {
    std::string name; ///< for people
    Scene       scene;
    /** How often it is done, for its time; the least counts. With more than one
     * it is given all ranks, and no other beside it. */
    unsigned int repetitions = 1;

    /** What it will take, about, in arbitrary units. */
    double price() const;
  };

  /** How far the simulations of a study have come. */
  struct StudyProgress
  {
    std::size_t number = 0; ///< of the run that has begun, from 1
    std::size_t total  = 0;
    std::string name;
    double      fraction = 0; ///< of the whole study, by prices

    /** Of the run, once it has ended. */
    std::optional<MeasuredRun> result;
    /** It was in the folder already. */
    bool is_reused = false;
  };

  /**
   * Does the simulations of studies, each one once. Those that are done are
   * kept in a folder, where a later study finds them: so an interrupted one
   * goes on.
   */
  class StudyRuns
  {
  public:
    using Listener = std::function<void(const StudyProgress &)>;

    /**
     * @param folder where runs are kept; empty: nowhere.
     * @param selection what of them is kept.
     * @param listener is told of runs on the first rank.
     */
    StudyRuns(MPI_Comm           communicator,
              const std::string &folder,
              Selection          selection,
              Listener           listener);

    /**
     * The results of @p plan, in its order, the same on all ranks. With several
     * ranks, at least as many runs and no repetitions these go side by side,
     * each on a rank;
     * else one after the other, each on all ranks. Throws InputError for a run
     * that cannot be done, Interrupted; failed computations are among the
     * results. Collective.
     */
    std::vector<MeasuredRun> compute(const std::vector<PlannedRun> &plan);

  private:
    struct Task;

    void find_kept(std::vector<Task> &tasks) const;
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
