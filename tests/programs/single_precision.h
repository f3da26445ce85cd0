#ifndef auxfem_tests_programs_single_precision_h
#define auxfem_tests_programs_single_precision_h

namespace auxfem::testing_support
{
  /** Graphics hold single precision: 2^-24 = 6e-8 of a number. */
  constexpr double single_precision = 1e-7;
} // namespace auxfem::testing_support

#endif
