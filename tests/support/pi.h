#ifndef auxfem_tests_support_pi_h
#define auxfem_tests_support_pi_h

#include <deal.II/base/numbers.h>

namespace auxfem::testing_support
{
  constexpr double pi = dealii::numbers::PI;
} // namespace auxfem::testing_support

#endif
