#ifndef auxfem_struts_beam_dispatch_h
#define auxfem_struts_beam_dispatch_h

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <type_traits>

namespace auxfem
{
  /** Largest polynomial order of struts in the plane, and in space. */
  constexpr int largest_plane_order = 6, largest_space_order = 4;

  /** The same by the dimension. */
  constexpr unsigned int highest_strut_order(const unsigned int dimension)
  {
    return dimension == 2 ? largest_plane_order : largest_space_order;
  }

  /** With Order = auto: linear elements never pay. */
  constexpr unsigned int lowest_chosen_order = 2;

  /**
   * Calls @p make with the polynomial order as a compile-time constant
   * (std::integral_constant<int, order>), order in 1..largest.
   */
  template <int largest = largest_plane_order, class Make>
  auto dispatch_order(const unsigned int order, const Make &make)
  {
    if constexpr (largest > 1)
      if (order < largest)
        return dispatch_order<largest - 1>(order, make);
    AssertThrow(order == largest,
                dealii::ExcMessage("Polynomial order out of range."));
    return make(std::integral_constant<int, largest>());
  }

  /**
   * What the kernels of beams know of an element at rest; of several elements
   * with Lanes for numbers.
   */
  template <int order, class Frame, class Stiffness, class Number>
  struct BeamAtRest
  {
    Frame     frames[order]; ///< at the Gauss points
    Number    jacobian;      ///< half the element's length (m)
    Stiffness stiffness;
  };
} // namespace auxfem

/**
 * @file
 * Damping of the highest frequencies that never creates energy, for mean forces
 * over steps. In steps of equal length it adds to the stress
 * @code
 * chi / 2 C (delta E_n - delta E_{n-1})
 * @endcode
 * of the increments delta E of the strains in this step and the one before,
 * which goes with the square of the step. With |E|^2 = E . C E its work is
 * @code
 * chi / 4 (|delta E_n|^2 - |delta E_{n-1}|^2 + |delta E_n - delta E_{n-1}|^2)
 * @endcode
 * so that the energy and chi / 4 |delta E_n|^2 together never grow. With q, the
 * length of the step before over that of this one, and m = min(q, 1),
 * @code
 * chi / 4 C ((1 + m^2) delta E_n - 2 min(q, 1 / q) delta E_{n-1})
 * @endcode
 * does the same: the rates delta E / dt take the place of the increments, with
 * the smaller one of the two steps; what a longer step adds to chi / 4 |delta
 * E|^2 is paid for at once. In the first step q = 0.
 */
namespace auxfem
{
  /** Mean forces without this damping. */
  struct NoIncrementDamping
  {
    static constexpr bool is_used = false;
  };

  /** The damping in an element, or with Lanes for numbers in several, of which
   * the increments are remembered. */
  template <class Number>
  struct IncrementDampingOf
  {
    static constexpr bool is_used = true;

    /** The added stress is C times present delta E_n - before delta E_{n-1}. */
    double present, before;
    /** `present` between steps of equal length. A tangent with it is kept where
     * they begin, and is near enough to the others. */
    double in_tangent;
    /** delta E_{n-1}, and where delta E_n is put; point by point. */
    const Number *last;
    Number       *now;

    /**
     * @param chi the damping
     * @param dt, dt_before lengths of this step and the one before (s); of the
     *   latter 0 if there is none
     */
    IncrementDampingOf(const double chi,
                       const double dt,
                       const double dt_before)
      : in_tangent(chi / 2)
      , last(nullptr)
      , now(nullptr)
    {
      const double q = dt_before / dt, m = std::min(q, 1.);
      present = chi / 4 * (1 + m * m);
      before  = q > 0 ? chi / 2 * std::min(q, 1 / q) : 0.;
    }

    /** What is added to mean strain @p i of an element, @p increment being its
     * delta E_n, which is remembered. */
    Number operator()(const int i, const Number &increment) const
    {
      now[i] = increment;
      return present * increment - before * last[i];
    }
  };
  using IncrementDamping = IncrementDampingOf<double>;
} // namespace auxfem

#endif
