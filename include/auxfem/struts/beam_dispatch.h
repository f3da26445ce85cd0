#ifndef auxfem_struts_beam_dispatch_h
#define auxfem_struts_beam_dispatch_h

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <type_traits>

namespace auxfem
{
  /** Largest polynomial order of struts in the plane and in space. */
  constexpr int largest_plane_order = 6, largest_space_order = 4;

  /** Largest polynomial order by dimension. */
  constexpr unsigned int highest_strut_order(const unsigned int dimension)
  {
    return dimension == 2 ? largest_plane_order : largest_space_order;
  }

  /**
   * Smallest order with Order = auto; linear elements are never the cheapest.
   */
  constexpr unsigned int lowest_chosen_order = 2;

  /** Calls @p make with the polynomial order as a compile-time constant
   * (std::integral_constant<int, order>), order in 1..largest. */
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

  /** Element at rest, as beam kernels need it; of several elements with Lanes
   * for numbers. */
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
 * Damping of the highest frequencies for mean forces over steps; it never
 * creates energy. With the strain increments delta E of this step and the
 * previous one, steps of equal length add the stress
 * @code
 * chi / 2 C (delta E_n - delta E_{n-1})
 * @endcode
 * With |E|^2 = E . C E its work is
 * @code
 * chi / 4 (|delta E_n|^2 - |delta E_{n-1}|^2 + |delta E_n - delta E_{n-1}|^2)
 * @endcode
 * so the energy plus chi / 4 |delta E_n|^2 never grows. With q, the previous
 * step length over this one, and m = min(q, 1),
 * @code
 * chi / 4 C ((1 + m^2) delta E_n - 2 min(q, 1 / q) delta E_{n-1})
 * @endcode
 * has the same property. In the first step q = 0.
 */
namespace auxfem
{
  /** Stand-in for mean forces without this damping. */
  struct NoIncrementDamping
  {
    static constexpr bool is_used = false;
  };

  /** Damping of the strain increments of one element or, with Lanes, of
   * several. */
  template <class Number>
  struct IncrementDampingOf
  {
    static constexpr bool is_used = true;

    /** The added stress is C times current_factor delta E_n - previous_factor
     * delta E_{n-1}. */
    double current_factor, previous_factor;
    /** current_factor for steps of equal length. A reused tangent keeps it,
     * since it is close to the others. */
    double tangent_factor;
    /** delta E_{n-1}, and storage for delta E_n; point by point. */
    const Number *previous_increments;
    Number       *current_increments;

    /**
     * @param chi damping parameter
     * @param dt, dt_before lengths of this step and the previous one (s);
     *   dt_before is 0 if there is none
     */
    IncrementDampingOf(const double chi,
                       const double dt,
                       const double dt_before)
      : tangent_factor(chi / 2)
      , previous_increments(nullptr)
      , current_increments(nullptr)
    {
      const double q = dt_before / dt, m = std::min(q, 1.);
      current_factor  = chi / 4 * (1 + m * m);
      previous_factor = q > 0 ? chi / 2 * std::min(q, 1 / q) : 0.;
    }

    /** Returns the addition to mean strain @p i of an element and stores @p
     * increment, its delta E_n. */
    Number operator()(const int i, const Number &increment) const
    {
      current_increments[i] = increment;
      return current_factor * increment -
        previous_factor * previous_increments[i];
    }
  };
  using IncrementDamping = IncrementDampingOf<double>;
} // namespace auxfem

#endif
