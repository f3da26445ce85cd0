#ifndef auxfem_tests_verification_comparison_table_h
#define auxfem_tests_verification_comparison_table_h

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /**
     * Compares computed with reference values and prints them, in Markdown, for
     * the verification pages.
     */
    class ComparisonTable
    {
    public:
      /** @p title names the problem and the source of the reference. */
      explicit ComparisonTable(const std::string &title)
      {
        text << "\n**" << title << "**\n\n"
             << "| quantity | computed | reference | difference | allowed |\n"
             << "|---|---|---|---|---|\n";
      }

      ~ComparisonTable()
      {
        std::cout << text.str() << std::endl;
      }

      ComparisonTable(const ComparisonTable &)            = delete;
      ComparisonTable &operator=(const ComparisonTable &) = delete;

      /** Expects |computed - reference| <= allowed. */
      void row(const std::string &quantity,
               const double       computed,
               const double       reference,
               const double       allowed)
      {
        EXPECT_NEAR(computed, reference, allowed) << quantity;
        text << "| " << quantity << " | " << std::setprecision(10) << computed
             << " | " << reference << " | " << std::setprecision(2)
             << std::abs(computed - reference) << " | " << allowed << " |\n";
      }

      /** Expects |computed - reference| <= allowed |reference|. */
      void relative(const std::string &quantity,
                    const double       computed,
                    const double       reference,
                    const double       allowed)
      {
        row(quantity, computed, reference, allowed * std::abs(reference));
      }

    private:
      std::ostringstream text;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
