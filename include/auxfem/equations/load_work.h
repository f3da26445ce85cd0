#ifndef auxfem_equations_load_work_h
#define auxfem_equations_load_work_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/loads/time_function.h>

#include <array>

namespace auxfem
{
  /**
   * Value with which a step begins: where there is an event that just after;
   * without inertia that just before, from which the step raises the load.
   */
  inline double value_at_start(const TimeFunction &load, const Evaluation &step)
  {
    if (!step.event_at_from)
      return load.value(time_of_loads(step.from));
    const double event = *step.event_at_from;
    const bool   is_raised =
      step.kind == Evaluation::Kind::static_step && step.from.time > 0;
    return is_raised ? load.value_before(event) : load.value_after(event);
  }

  /**
   * Value at evaluation.to, where there is an event on the side that the
   * evaluation asks for.
   */
  inline double value_at_end(const TimeFunction &load,
                             const Evaluation   &evaluation)
  {
    if (!evaluation.event_at_to)
      return load.value(time_of_loads(evaluation.to));
    const auto &[time, side] = *evaluation.event_at_to;
    return side == TimeSide::before ? load.value_before(time)
                                    : load.value_after(time);
  }

  /**
   * Work along the path of equilibria in a static step, beyond that of the mean
   * of the forces at both ends: with forces F and displacements u on the
   * parabolas through the ends of this step and the one before,
   *
   *   F = F_n + a x + b x^2,   u = u_n + c x + d x^2,   0 <= x <= 1,
   *
   * the integral of F du is the mean force times the increment and (a d - b c)
   * /
   * 6. In sum zero in linear scenes, by Betti's theorem. None after an event,
   * and none with viscosity, whose own accounts are by mean forces.
   */
  class PathWork
  {
  public:
    explicit PathWork(const Evaluation &step)
    {
      if (step.kind != Evaluation::Kind::static_step || step.to.velocity ||
          !step.from.before)
        return;
      before       = &*step.from.before;
      length_ratio = before->dt / step.dt;
    }

    /** The state that the step before began with; nullptr: there is no more
     * work than by mean forces. */
    const State::Before *state_before() const
    {
      return before;
    }

    /** Of values at the start of the step before, of this one, at its end. */
    using Values = std::array<double, 3>;

    /** Where state_before() is not nullptr (J). */
    double beyond_mean(const Values &force, const Values &displacement) const
    {
      const auto [a, b] = slope_and_bend(force);
      const auto [c, d] = slope_and_bend(displacement);
      return (a * d - b * c) / 6;
    }

  private:
    std::pair<double, double> slope_and_bend(const Values &values) const
    {
      const double before = values[1] - values[0], now = values[2] - values[1],
                   bend = (now - before / length_ratio) / (1 + length_ratio);
      return {now - bend, bend};
    }

    const State::Before *before       = nullptr;
    double               length_ratio = 1;
  };
} // namespace auxfem

#endif
