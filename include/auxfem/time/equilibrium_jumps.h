#ifndef auxfem_time_equilibrium_jumps_h
#define auxfem_time_equilibrium_jumps_h

#include <auxfem/equations/node_rotations.h>
#include <auxfem/time/watch.h>

namespace auxfem
{
  /**
   * Detects static steps that jump to an equilibrium not connected with their
   * start. The motion then differs strongly from the first Newton increment,
   * which follows the tangent, and from the previous step. TimeStepper repeats
   * such steps in halves: on a connected path the motion shrinks with the
   * step. If it does not, the path has a limit point, and the jump is
   * reported.
   */
  class EquilibriumJumps : public Watch
  {
  public:
    /** @p model must outlive the object. */
    explicit EquilibriumJumps(const LatticeModel &model);

    /** Begins a step of the scene, before any attempt at it. */
    void begin_step()
    {
      largest_rejected.reset();
      last_rejected.reset();
      rejected_end.reset();
      allows_jumps = false;
    }

    /**
     * Why a solved step must be repeated in shorter ones; empty if it may be
     * accepted. Collective.
     * @param predicted the first increment of Newton's method (m, rad)
     * @param changes_stability the ends of the step have different numbers of
     *   negative modes
     */
    std::string rejection_reason(const Evaluation &step,
                                 const Vector     &predicted,
                                 bool              changes_stability);

    /**
     * Called when shorter steps have failed. Returns whether longer ones were
     * rejected for their jump alone; from now on these are accepted.
     */
    bool allow_jumps();

    /** End of the next step (s), at most @p time: that of the rejected one. */
    double target(double time) const;

    /**
     * Whether @p step ends at the time of a rejected jump; then @p increment
     * leads there from step.to.
     */
    bool extrapolate(const Evaluation    &step,
                     const NodeRotations &rotations,
                     Vector              &increment) const;

    /** Whether the last checked step jumps. */
    bool is_jump() const
    {
      return candidate.has_value();
    }

    /** Accepts the last checked step. */
    void step(const Evaluation        &step,
              const EvaluationResults &results,
              TangentSolver           &solver) override;

    std::vector<Finding> findings() const override;

    void serialize(CheckpointArchive &archive) override;

  private:
    /** A jump, reported once its step is accepted. */
    struct Jump
    {
      double      time = 0, end = 0; ///< of its step (s)
      double      size = 0;          ///< m
      std::string location;
    };

    /** Length of a rejected step (s) and its largest translation (m). */
    struct RejectedMotion
    {
      double dt, size;
    };

    /** A rejected step. */
    struct RejectedStep
    {
      double time;      ///< at its start (s)
      double predicted; ///< largest translation (m)
    };

    const LatticeModel &model;
    /** The rejected attempt at this step with the largest motion. */
    std::optional<RejectedMotion> largest_rejected;
    std::optional<RejectedStep>   last_rejected;
    /** End state of the last step that was rejected for a jump. */
    std::optional<State> rejected_end;
    bool                 allows_jumps = false;
    std::optional<Jump>  candidate, first;
    unsigned long        n_jumps = 0;
  };
} // namespace auxfem

#endif
