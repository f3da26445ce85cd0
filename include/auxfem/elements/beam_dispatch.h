#ifndef auxfem_elements_beam_dispatch_h
#define auxfem_elements_beam_dispatch_h

#include <auxfem/elements/strut_order.h>

#include <deal.II/base/exceptions.h>

#include <type_traits>

namespace auxfem
{
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
} // namespace auxfem

#endif
