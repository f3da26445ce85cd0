#ifndef auxfem_scene_step_ends_h
#define auxfem_scene_step_ends_h

#include <auxfem/scene/run_plan.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Largest number of kinks in close succession that count as pulses, not as
   * samples of a measured function: those of two trapezoids. */
  constexpr std::size_t max_pulse_kinks = 8;

  /** A time at which a step must end. */
  struct StepEnd
  {
    /** Highest-ranking part of the motion that jumps there. In statics,
     * `accelerations` means that loads jump, `velocities` that supports do. */
    enum class Jump
    {
      none,
      accelerations,
      velocities
    };

    double time; ///< s
    Jump   jump;
  };

  /**
   * The times of a run at which a step must end, in ascending order, because
   * time schemes take loads and motions for smooth within a step:
   * - kinks and jumps of loads and of support motions;
   * - in dynamics, jumps of support accelerations;
   * - in statics, t = 0 if anything begins suddenly;
   * - the times of `Time/Events`.
   *
   * Steps sample functions with many kinks, such as measured ones: more than
   * max_pulse_kinks kinks, each within a time step of the one before, are
   * dropped. Jumps and, in dynamics, kinks of support motions always count.
   */
  std::vector<StepEnd> step_ends(const RunPlan &plan);

  /** The step_ends() of a plan, for queries by its steps. */
  class StepEnds
  {
  public:
    explicit StepEnds(const RunPlan &plan);

    /** Latest end of a step from @p time (s): the next step end or
     * @p end_of_scene_step. */
    double next(double time, double end_of_scene_step) const;

    /** The jump at @p time (s); none if no step must end there. */
    std::optional<StepEnd::Jump> jump_at(double time) const;

    /** Time (s) at which a step that begins at @p time evaluates functions of
     * time, if it begins at an event. */
    std::optional<double> event_at_begin(double time) const;

    /** The same for a step that ends at @p time, as a limit from before. */
    std::optional<TimeLimit> event_at_end(double time) const;

  private:
    using Iterator = std::vector<StepEnd>::const_iterator;

    /** Range of step ends within the tolerance around @p time (s). */
    std::pair<Iterator, Iterator> at(double time) const;

    const double               tolerance; ///< s
    const std::vector<StepEnd> ends;
  };

  /** Distance (s) below which two times are the same for the steps. */
  double step_end_tolerance(const TimeParameters &time);

  /** All functions of time that act on the lattice. */
  std::vector<TimeFunction> functions_of_time(const RunPlan &plan);

  /**
   * Notes to the user on loads and support motions: tables that end before the
   * run, splines that overshoot, motions with many velocity jumps, and
   * functions that the steps do not resolve. The last are those that change
   * within a step by more than a quarter of their largest value; only runs of
   * fewer than 2^18 steps are searched for them.
   */
  std::vector<std::string> time_function_notes(const RunPlan &plan);

  /** Text of up to three loads and support motions that are not zero at @p time
   * (s), e.g. `Loads/press/Force x: '-40 * t' = -4.9`. */
  std::string load_values_text(const RunPlan &plan, double time);
} // namespace auxfem

#endif
