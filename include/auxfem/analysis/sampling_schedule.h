#ifndef auxfem_analysis_sampling_schedule_h
#define auxfem_analysis_sampling_schedule_h

#include <auxfem/equations/equations.h>

#include <algorithm>

namespace auxfem
{
  /** Which steps a watch checks. Without inertia each of them checks all. */
  enum class SamplingRate
  {
    every_step,
    /** Some in a row, now and then, in linear scenes, whose steps cost little
     * more than a check of every unknown. */
    bursts,
    /** The first of each burst, in nonlinear scenes too: for checks that cost
     * as much as an evaluation. */
    single_steps
  };

  /** The steps that are sampled: a function of their number alone, so that runs
   * that are resumed sample the same ones. The last steps always are. */
  class SamplingSchedule
  {
  public:
    /**
     * Steps from one sample to the next, at most.
     * @tuned [steps] measured: samples cost a few per cent of linear steps; a
     * prime number lets no vibration hide between samples
     */
    static constexpr unsigned long longest_period = 13;

    /**
     * Smallest number of samples in a run that has more steps.
     * @tuned judgement
     */
    static constexpr unsigned long least_number = 20;

    explicit SamplingSchedule(const Equations &equations)
      : has_inertia(equations.model().plan.simulated.inertia)
      , is_linear(equations.is_linear())
      , n_steps(equations.model().plan.time.n_steps())
      , period(
          std::min(longest_period, (n_steps + least_number - 1) / least_number))
    {}

    /** @param number of the step, from 0 */
    bool is_sampled(const SamplingRate rate, const unsigned long number) const
    {
      if (rate == SamplingRate::every_step || !has_inertia)
        return true;
      if (rate == SamplingRate::single_steps)
        return number % period == 0 || number + 1 >= n_steps;
      return !is_linear || number % period < burst || number + burst >= n_steps;
    }

  private:
    /** Steps that a third difference takes. */
    static constexpr unsigned long burst = 3;

    const bool          has_inertia, is_linear;
    const unsigned long n_steps, period;
  };
} // namespace auxfem

#endif
