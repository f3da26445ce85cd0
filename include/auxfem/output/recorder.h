#ifndef auxfem_output_recorder_h
#define auxfem_output_recorder_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/history.h>
#include <auxfem/output/verdict.h>
#include <auxfem/scene/run_plan.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/state.h>
#include <auxfem/state/step_report.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** A singular point of a path of equilibria. */
  struct SingularPoint
  {
    enum class Kind
    {
      limit,      ///< the load factor has an extremum
      bifurcation ///< another branch crosses
    };
    Kind kind;
    /** Stiffness data before and after the point on the path. */
    PathPosition before, after;
    /**
     * Null vector of the stiffness, values of all local unknowns; its largest
     * entry is positive.
     */
    Vector null_vector;
    /** See PathStepper::load_projection(). */
    std::optional<double> load_projection = {};

    /** Number of eigenvalues that change sign at once; 1 if unknown. */
    unsigned long multiplicity() const
    {
      if (!before.n_negative || !after.n_negative)
        return 1;
      return *before.n_negative < *after.n_negative
        ? *after.n_negative - *before.n_negative
        : *before.n_negative - *after.n_negative;
    }

    /**
     * Whether the equilibria after the point are less stable than those before.
     */
    bool destabilizes() const
    {
      if (before.n_negative && after.n_negative)
        return *after.n_negative > *before.n_negative;
      return before.determinant_sign == 1 && after.determinant_sign == -1;
    }
  };

  /** Sentence on the choice of the elements, without the final line break. */
  std::string order_search_text(const OrderReport &report);

  /**
   * Sentence on the estimated discretization error, without the final line
   * break.
   */
  std::string mesh_error_text(const OrderReport &report);

  /** Report on the choice of elements for summary.json. */
  Json json_of(const OrderReport &report);

  struct Scene;

  /** Outcome and effort of a run. */
  struct RunResult
  {
    /** `completed`, or the reason of an early end. */
    std::string exit_state;
    double      time = 0; ///< final time (s)
    Work        work;
    /** Findings on the results, the worst first. */
    std::vector<Finding> findings;

    /**
     * Estimated error of the time integration over the largest displacements,
     * if it controls the steps.
     */
    std::optional<double> time_error = {};

    /** Report on the choice of elements; with Discretization/Order = auto. */
    std::optional<OrderReport> orders = {};

    /**
     * Largest penetration after a step or substep over the strut thickness;
     * with contact.
     */
    std::optional<double> largest_penetration = {};

    /**
     * Estimated error of the chosen small-displacement kinematics over the
     * largest displacements.
     */
    std::optional<double> small_displacement_error = {};

    bool completed() const
    {
      return exit_state == "completed";
    }
  };

  /**
   * Receives the results of an analysis while it runs, for example to write
   * files. Lattices call the first group of functions on all ranks; other
   * models record rows.
   */
  class Recorder
  {
  public:
    virtual ~Recorder() = default;

    /** @name Lattices. */
    ///@{
    /**
     * Called before begin() with Discretization/Order = auto, after a step of
     * the run @p search, which determines the elements.
     */
    virtual void search_step(const RunPlan & /*search*/,
                             const State & /*state*/,
                             const StepReport & /*report*/)
    {}

    /** The set-up is complete. @p equations outlive the recording. */
    virtual void begin(const Equations & /*equations*/)
    {}

    /** The solution at t = 0. */
    virtual void start(const Solution & /*solution*/)
    {}

    /** @name Checkpoints, from which a run can continue. */
    ///@{
    /**
     * Checkpoint from which the run continues; nullptr: it starts at the
     * beginning.
     */
    virtual const CheckpointData *restart_checkpoint() const
    {
      return nullptr;
    }

    /** Stores the latest checkpoint. Collective. */
    virtual void store_checkpoint(CheckpointData /*checkpoint*/)
    {}

    /**
     * Writes the latest checkpoint, because the run ends or is interrupted.
     * Collective.
     */
    virtual void keep_checkpoint()
    {}

    /**
     * Saves the state of the recorder after @p solution, the last one received;
     * or restores it instead of start().
     */
    virtual void serialize(const Solution & /*solution*/,
                           CheckpointArchive & /*archive*/)
    {}
    ///@}

    /**
     * First time after @p time (s) at which the recorder needs an interpolated
     * solution; empty if there is none. The same on all ranks.
     */
    virtual std::optional<double> next_time(double /*time*/) const
    {
      return {};
    }

    /**
     * Receives the solution at a time of next_time(), before step() for the
     * step that contains it.
     */
    virtual void row(const Solution & /*solution*/)
    {}

    /**
     * Receives a singular point of a path, at @p solution between the last step
     * and the next.
     */
    virtual void singular_point(const Solution & /*solution*/,
                                const SingularPoint & /*point*/)
    {}

    /** Called after each step of the scene. */
    virtual void step(const Solution & /*solution*/,
                      const StepReport & /*report*/)
    {}

    /**
     * Called at the end with the last accepted solution, also after a failure.
     */
    virtual void finish(const Solution & /*last*/, const RunResult & /*result*/)
    {}
    ///@}

    /**
     * @name Models other than lattices: rows of numbers, on the first rank
     * only.
     */
    ///@{
    virtual void begin_rows(const std::vector<Column> & /*columns*/,
                            unsigned int /*n_unknowns*/)
    {}

    virtual void row(const std::vector<double> & /*values*/)
    {}
    ///@}
  };

  /** Sampling times: multiples of an interval. */
  class OutputTimes
  {
  public:
    /**
     * @param interval sampling interval (s); none: never
     * @param nearness tolerance for equal times (s), much less
     */
    OutputTimes(std::optional<double> interval, double nearness);

    /** First sampling time after @p time (s). */
    std::optional<double> after(double time) const;

    /** Whether @p time (s) is a sampling time. */
    bool has(double time) const;

  private:
    std::optional<double> interval;
    double                nearness;
  };

  /**
   * Stores the history of a lattice in memory: the columns of history.csv with
   * a row for each step, or for each time of Output/Time between rows. A
   * resumed run has only later rows. The same on all ranks.
   */
  class MemoryRecorder : public Recorder
  {
  public:
    /** @param scene must outlive the recording. */
    MemoryRecorder(const Scene &scene, MPI_Comm communicator);

    void begin(const Equations &equations) override;

    void start(const Solution &solution) override
    {
      row_list.push_back(history->values(solution));
    }

    void serialize(const Solution    &solution,
                   CheckpointArchive &archive) override
    {
      history->serialize(solution.state, archive);
    }

    std::optional<double> next_time(const double time) const override
    {
      return row_times.after(time);
    }

    void row(const Solution &solution) override
    {
      row_list.push_back(history->values(solution));
    }

    void step(const Solution &solution, const StepReport &report) override;

    const std::vector<Column> &columns() const
    {
      return column_list;
    }

    const std::vector<std::vector<double>> &rows() const
    {
      return row_list;
    }

    /**
     * Values of a column from t = 0 on. Throws InputError if the column does
     * not exist.
     */
    std::vector<double> column(const std::string &name) const;

  private:
    const Scene                     &scene;
    const MPI_Comm                   communicator;
    const OutputTimes                row_times;
    std::optional<History>           history; ///< from begin() on
    std::vector<Column>              column_list;
    std::vector<std::vector<double>> row_list;
  };
} // namespace auxfem

#endif
