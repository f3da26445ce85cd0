#ifndef auxfem_tests_analysis_expect_same_h
#define auxfem_tests_analysis_expect_same_h

#include <auxfem/algebra/vector.h>

#include <gtest/gtest.h>

namespace auxfem::testing_support
{
  /** To the last bit. */
  inline void expect_same(const Vector &a, const Vector &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (unsigned int i = 0; i < a.size(); ++i)
      EXPECT_EQ(a[i], b[i]);
  }
} // namespace auxfem::testing_support

#endif
