#ifndef auxfem_system_effects_beam_dispatch_h
#define auxfem_system_effects_beam_dispatch_h

#include <deal.II/base/exceptions.h>

#include <type_traits>

namespace auxfem
{
  /**
   * Calls @p make with the polynomial order as a compile-time constant
   * (std::integral_constant<int, order>), order in 1..6.
   */
  template <class Make>
  auto dispatch_order(const unsigned int order, const Make &make)
  {
    switch (order)
      {
        case 1:
          return make(std::integral_constant<int, 1>());
        case 2:
          return make(std::integral_constant<int, 2>());
        case 3:
          return make(std::integral_constant<int, 3>());
        case 4:
          return make(std::integral_constant<int, 4>());
        case 5:
          return make(std::integral_constant<int, 5>());
        case 6:
          return make(std::integral_constant<int, 6>());
        default:
          AssertThrow(false,
                      dealii::ExcMessage("Polynomial order must be 1..6."));
          return make(std::integral_constant<int, 1>());
      }
  }
} // namespace auxfem

#endif
