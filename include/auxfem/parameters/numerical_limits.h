#ifndef auxfem_parameters_numerical_limits_h
#define auxfem_parameters_numerical_limits_h

#include <limits>

// Sizes that double precision, scene files and engineering accuracy imply. Each
// is relative to what a value is compared with.

namespace auxfem
{
  /** Rounding of a few operations: smaller terms of a sum are none. */
  inline constexpr double few_round_offs =
    16 * std::numeric_limits<double>::epsilon();

  /** Rounding of a whole computation: smaller differences are none. */
  inline constexpr double round_off = 1e-12;

  /** What remains of a number when half of its digits cancel. */
  inline constexpr double sqrt_round_off = 1e-8;

  /** Agreement of numbers that a user writes, with six digits or more:
   * positions, velocities, times. */
  inline constexpr double given_digits = 1e-6;

  /**
   * Rotation (rad), or displacement over the length of struts, of states
   * whose forces are compared to find how these change.
   */
  inline constexpr double finite_difference_step = 1e-3;

  /**
   * Accuracy of a place along a line or an axis, over its length.
   */
  inline constexpr double accuracy_of_places = 1e-3;

  /**
   * Rotation, or strain, up to which linear theory holds.
   * @tuned [rad] theory: the cosine then differs from one by 0.5 %
   */
  inline constexpr double small_rotation = 0.1;

  /**
   * Part of a result, an energy or a force that an engineer notices.
   * @tuned judgement
   */
  inline constexpr double noticeable_part = 0.01;
} // namespace auxfem

#endif
