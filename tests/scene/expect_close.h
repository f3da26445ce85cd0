#ifndef auxfem_tests_scene_expect_close_h
#define auxfem_tests_scene_expect_close_h

#include <gtest/gtest.h>

#include <cmath>

namespace auxfem::testing_support
{
  /** Equal but for the round-off of a handful of decimals. */
  inline void expect_close(const double value, const double expected)
  {
    EXPECT_NEAR(value, expected, 1e-14 * std::abs(expected));
  }
} // namespace auxfem::testing_support

#endif
