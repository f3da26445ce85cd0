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
  /** What makes a point of a path of equilibria singular. */
  struct SingularPoint
  {
    enum class Kind
    {
      limit,      ///< the load factor turns round
      bifurcation ///< another branch crosses
    };
    Kind kind;
    /** What is known of the stiffness before and after it on the path. */
    PathPosition before, after;
    /** Of the stiffness there, of all local unknowns; its largest entry is
     * positive. */
    Vector null_vector;
    /** PathStepper::part_of_loads(). */
    std::optional<double> load_projection = {};

    /** How many directions become singular at once; 1 where that is not known.
     */
    unsigned long multiplicity() const
    {
      if (!before.n_negative || !after.n_negative)
        return 1;
      return *before.n_negative < *after.n_negative
        ? *after.n_negative - *before.n_negative
        : *before.n_negative - *after.n_negative;
    }

    /** Whether the equilibria after it are less stable than those before. */
    bool destabilizes() const
    {
      if (before.n_negative && after.n_negative)
        return *after.n_negative > *before.n_negative;
      return before.determinant_sign == 1 && after.determinant_sign == -1;
    }
  };

  /** A sentence on how the elements were found, without the last line break. */
  std::string order_search_text(const OrderReport &report);

  /** A sentence on what the run says of their error, without the last line
   * break. */
  std::string mesh_error_text(const OrderReport &report);

  /** All of it for summary.json. */
  Json json_of(const OrderReport &report);

  struct Column;
  struct Scene;

  /** How a run ended and what it took. */
  struct RunResult
  {
    /** `completed` or the reason it was not. */
    std::string exit_state;
    double      time = 0; ///< reached (s)
    Work        work;
    /** What the run found out about its own results, the worst first. */
    std::vector<Finding> findings;

    /** Estimated error of the time integration, relative to the largest
     * displacements, where steps follow it. */
    std::optional<double> time_error = {};

    /** With Discretization/Order = auto. */
    std::optional<OrderReport> orders = {};

    /** Largest penetration after a step or a part of one, over the thickness of
     * the strut; with contact. */
    std::optional<double> largest_penetration = {};

    /** Estimated error of small displacements that the run chose, relative to
     * the largest ones. */
    std::optional<double> small_displacement_error = {};

    bool completed() const
    {
      return exit_state == "completed";
    }
  };

  /**
   * Receives what an analysis computes, while it does: a folder of files, a
   * table in memory. Each recorder takes what it needs. Lattices call the first
   * group of functions, on all ranks together; other models record rows.
   */
  class Recorder
  {
  public:
    virtual ~Recorder() = default;

    /** @name Lattices. */
    ///@{
    /**
     * Before begin(), with Discretization/Order = auto: a step is done of the
     * run @p search, whose motion tells which elements to take.
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

    /** @name Checkpoints: what a run needs to go on from the middle. */
    ///@{
    /** The one that the run is to go on from, in place of its start; nullptr:
     * it starts. */
    virtual const CheckpointData *restart_checkpoint() const
    {
      return nullptr;
    }

    /** The latest one. Collective. */
    virtual void take(CheckpointData /*checkpoint*/)
    {}

    /** The run ends, or is interrupted: another one goes on from the checkpoint
     * taken last. Collective. */
    virtual void keep_checkpoint()
    {}

    /**
     * Saves what the recorder remembers of the solutions it has been told of,
     * @p solution the last; or restores it in place of start().
     */
    virtual void serialize(const Solution & /*solution*/,
                           CheckpointArchive & /*archive*/)
    {}
    ///@}

    /**
     * The first time after @p time (s) for which the recorder wants a solution
     * wherever steps end; nothing if there is none. The same on all ranks.
     */
    virtual std::optional<double> next_time(double /*time*/) const
    {
      return {};
    }

    /** The solution at such a time, before the step that it lies in, or that
     * ends there, is done. */
    virtual void between(const Solution & /*solution*/)
    {}

    /** On a path of equilibria a singular point was found at @p solution, which
     * lies between the last step and the next. */
    virtual void singular_point(const Solution & /*solution*/,
                                const SingularPoint & /*point*/)
    {}

    /** A step of the scene is done. */
    virtual void step(const Solution & /*solution*/,
                      const StepReport & /*report*/)
    {}

    /** @p last is the last accepted solution, also after a failure. */
    virtual void finish(const Solution & /*last*/, const RunResult & /*result*/)
    {}
    ///@}

    /** @name Analyses of another model than a lattice: rows of numbers. On the
     * first rank alone. */
    ///@{
    virtual void begin_rows(const std::vector<Column> & /*columns*/,
                            unsigned int /*n_unknowns*/)
    {}

    virtual void row(const std::vector<double> & /*values*/)
    {}
    ///@}
  };

  /** When to write something: at the multiples of an interval. */
  class OutputTimes
  {
  public:
    /**
     * @param interval (s); none: never.
     * @param nearness of times that are the same (s), much less
     */
    OutputTimes(std::optional<double> interval, double nearness);

    /** The first of them after @p time (s). */
    std::optional<double> after(double time) const;

    /** Whether @p time (s) is one of them. */
    bool has(double time) const;

  private:
    std::optional<double> interval;
    double                nearness;
  };

  /**
   * Keeps the history of a lattice in memory and writes nothing: the columns of
   * history.csv with a row for each step of the scene, or for each of the times
   * that Output/Time between rows asks for; of a resumed run for those that
   * follow. The same on all ranks.
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

    void between(const Solution &solution) override
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

    /** The numbers of a column, from t = 0 on. Throws InputError if there is no
     * such column. */
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
