#ifndef auxfem_output_recorder_h
#define auxfem_output_recorder_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/solution.h>
#include <auxfem/output/order_report.h>
#include <auxfem/output/singular_point.h>
#include <auxfem/output/verdict.h>
#include <auxfem/time/checkpoint_archive.h>
#include <auxfem/time/step_report.h>

#include <optional>
#include <string>
#include <utility>

namespace auxfem
{
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
    virtual const Records *goes_on_from() const
    {
      return nullptr;
    }

    /** The latest one. Collective. */
    virtual void take(Records /*checkpoint*/)
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
} // namespace auxfem

#endif
