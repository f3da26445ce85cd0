#ifndef auxfem_scene_step_ends_h
#define auxfem_scene_step_ends_h

#include <auxfem/scene/run_plan.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** Kinks that follow each other as those of a pulse or two may do. */
  constexpr std::size_t most_kinks_of_pulses = 8;

  /** A time at which a step has to end. */
  struct StepEnd
  {
    /** What of the lattice's motion jumps there; each includes those before.
     * Without inertia accelerations stand for loads, velocities for supports
     * that jump. */
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
   * The times of a run up to its end, rising, at which loads and motions of
   * supports have kinks or jump, so that a step has to end there: the time
   * schemes take forces and motions for smooth over a step. With inertia also
   * those at which accelerations of supports jump, without it t = 0 if anything
   * begins suddenly.
   *
   * More than eight kinks of a load, without inertia of a motion too, that
   * follow each other within a time step are left out: such a function, a
   * measured one, say, is sampled by the steps. Fewer, as those of a pulse, are
   * not; jumps never are, nor what strikes. The times of `Time/Events` are
   * among them.
   */
  std::vector<StepEnd> step_ends(const RunPlan &plan);

  /** Those of a plan, as its steps ask for them. */
  class StepEnds
  {
  public:
    explicit StepEnds(const RunPlan &plan);

    /** Where a step from @p time (s) ends at the latest: at the next of them,
     * if that comes before @p end_of_scene_step. */
    double next(double time, double end_of_scene_step) const;

    /** What jumps at @p time (s), if it is one of them. */
    std::optional<StepEnd::Jump> jump_at(double time) const;

    /** Where a step that begins at @p time (s) takes the functions of time. */
    std::optional<double> event_at_begin(double time) const;

    /** Where one that ends there does. */
    std::optional<TimeLimit> event_at_end(double time) const;

  private:
    using Iterator = std::vector<StepEnd>::const_iterator;

    /** Those at @p time (s), which is one time for a step. */
    std::pair<Iterator, Iterator> at(double time) const;

    const double               near;
    const std::vector<StepEnd> ends;
  };

  /** Times that are closer (s) are one to the steps. */
  double nearness_of_step_ends(const TimeParameters &time);

  /** All functions of time that act on the lattice. */
  std::vector<TimeFunction> functions_of_time(const RunPlan &plan);

  /**
   * What the user should know of loads and motions of supports: tables that end
   * before the run, with the time from which on their last value is held,
   * splines that overshoot, tables of motions that strike at many rows, and
   * functions that the steps do not resolve, with the step in which most is
   * missed. Of the latter, such as change by more than a quarter of their
   * largest value between what the ends of a step show; looked for at up to 64
   * times a step, 2^18 in all, and at kinks and jumps, in runs of fewer than
   * 2^18 steps.
   */
  std::vector<std::string> time_function_notes(const RunPlan &plan);

  /**
   * The loads and motions of supports that are not zero at @p time (s), with
   * their values, in words, e.g. `Loads/press/Force x: '-40 * t' = -4.9`; three
   * at most.
   */
  std::string load_values_text(const RunPlan &plan, double time);
} // namespace auxfem

#endif
