#ifndef auxfem_tests_analysis_expect_same_h
#define auxfem_tests_analysis_expect_same_h

#include <auxfem/algebra/vector.h>
#include <auxfem/state/step_report.h>

#include <gtest/gtest.h>

namespace auxfem::testing_support
{
  /** Expects equality to the last bit. */
  inline void expect_same(const Vector &a, const Vector &b)
  {
    ASSERT_EQ(a.size(), b.size());
    for (unsigned int i = 0; i < a.size(); ++i)
      EXPECT_EQ(a[i], b[i]);
  }

  /**
   * Compares the work of a whole run and a resumed one, which factorizes again
   * what linear equations reuse.
   */
  inline void expect_same_work(const Work &a, const Work &b)
  {
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_LE(a.factorizations, b.factorizations);
    EXPECT_LE(b.factorizations, a.factorizations + 1);
    EXPECT_EQ(a.retries, b.retries);
    EXPECT_EQ(a.shortened, b.shortened);
    EXPECT_EQ(a.linear_solutions, b.linear_solutions);
    EXPECT_EQ(a.linear_iterations, b.linear_iterations);
  }
} // namespace auxfem::testing_support

#endif
