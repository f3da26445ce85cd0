#ifndef auxfem_parameters_numerical_limits_h
#define auxfem_parameters_numerical_limits_h

#include <limits>

// Relative tolerances that follow from double precision, the digits in scene
// files and engineering accuracy.

namespace auxfem
{
  /** Round-off of a few operations; smaller terms of a sum are negligible. */
  inline constexpr double few_round_offs =
    16 * std::numeric_limits<double>::epsilon();

  /** Round-off of a whole computation; smaller differences are negligible. */
  inline constexpr double round_off = 1e-12;

  /** Relative accuracy of a number after half of its digits cancel. */
  inline constexpr double sqrt_round_off = 1e-8;

  /**
   * Accuracy of numbers written by a user with six digits or more: positions,
   * velocities, times.
   */
  inline constexpr double input_precision = 1e-6;

  /**
   * Perturbation of states for finite differences of forces: rotation (rad), or
   * displacement over strut length.
   */
  inline constexpr double finite_difference_step = 1e-3;

  /** Accuracy of a position along a line or an axis, relative to its length. */
  inline constexpr double position_tolerance = 1e-3;

  /**
   * Rotation or strain up to which linear theory holds.
   * @tuned [rad] theory: the cosine then differs from one by 0.5 %
   */
  inline constexpr double small_rotation = 0.1;

  /**
   * Fraction of a result, an energy or a force that matters to an engineer.
   * @tuned judgement
   */
  inline constexpr double noticeable_fraction = 0.01;
} // namespace auxfem

#endif
