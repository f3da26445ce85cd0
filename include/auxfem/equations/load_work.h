#ifndef auxfem_equations_load_work_h
#define auxfem_equations_load_work_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/loads/time_function.h>

#include <array>

namespace auxfem
{
  /**
   * Load value at the start of a step. After an event the step starts with the
   * new value; without inertia it starts with the old one and raises the load.
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
   * Load value at evaluation.to; at an event on the side that the evaluation
   * selects.
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
   * Work along the equilibrium path of a static step beyond that of the mean
   * end forces. With forces F and displacements u on parabolas through the ends
   * of this step and the previous one,
   *
   *   F = F_n + a x + b x^2,   u = u_n + c x + d x^2,   0 <= x <= 1,
   *
   * the integral of F du is the mean force times the increment plus
   * (a d - b c) / 6. In linear scenes the sum vanishes by Betti's theorem. Not
   * applied after an event, nor with viscosity or struts that lose energy,
   * which are accounted for with mean forces.
   */
  class PathWork
  {
  public:
    explicit PathWork(const Evaluation &step)
    {
      if (step.kind != Evaluation::Kind::static_step || step.to.velocity ||
          step.to.has_mean_work || !step.from.before)
        return;
      before       = &*step.from.before;
      length_ratio = before->dt / step.dt;
    }

    /** Start of the previous step; nullptr if mean forces suffice. */
    const State::Before *state_before() const
    {
      return before;
    }

    /** Values at the start of the previous step, of this step, and at its
     * end. */
    using Values = std::array<double, 3>;

    /** Work beyond mean forces (J); requires state_before() != nullptr. */
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
