#ifndef auxfem_output_verdict_limits_h
#define auxfem_output_verdict_limits_h

namespace auxfem
{
  /**
   * Relative error above which a result is doubtful.
   * @tuned judgement: 8 steps a period with the trapezoidal rule
   */
  inline constexpr double doubtful_error = 0.05;

  /**
   * Relative error above which a result is not to be used.
   * @tuned judgement: 3.6 steps a period with the trapezoidal rule
   */
  inline constexpr double unusable_error = 0.25;
} // namespace auxfem

#endif
