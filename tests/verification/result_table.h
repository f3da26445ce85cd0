#ifndef auxfem_tests_verification_result_table_h
#define auxfem_tests_verification_result_table_h

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace auxfem
{
  namespace testing_support
  {
    /** @p value as printf() writes it, e.g. with `%.2e`. */
    inline std::string formatted(const char *format, const double value)
    {
      char text[64];
      std::snprintf(text, sizeof text, format, value);
      return text;
    }

    /**
     * A table of results that goes to `verification/<name>.csv` in the working
     * directory for a test in `<name>_test.cc`, the tables of one file below
     * each other, each after a line `# title`. scripts/verification-tables
     * makes the data and pages of doc/ of these.
     */
    class ResultTable
    {
    public:
      using Cells = std::vector<std::string>;

      ResultTable(const std::string &title, const Cells &columns)
        : text("# " + title + '\n')
      {
        row(columns);
      }

      /** At the end, so that tables may grow side by side. */
      ~ResultTable()
      {
        namespace fs = std::filesystem;
        const fs::path source =
          testing::UnitTest::GetInstance()->current_test_info()->file();
        const std::string stem = source.stem().string();
        const fs::path    file =
          fs::path("verification") / (stem.substr(0, stem.rfind('_')) + ".csv");
        fs::create_directories("verification");
        // the first table of a process replaces those of the one before
        static std::set<fs::path> begun;
        const bool                is_first = begun.insert(file).second;
        std::ofstream(file, is_first ? std::ios::trunc : std::ios::app)
          << (is_first ? "" : "\n") << text;
      }

      ResultTable(const ResultTable &)            = delete;
      ResultTable &operator=(const ResultTable &) = delete;

      void row(const Cells &cells)
      {
        for (std::size_t i = 0; i < cells.size(); ++i)
          text += (i == 0 ? "" : ",") + quoted(cells[i]);
        text += '\n';
      }

    private:
      static std::string quoted(const std::string &cell)
      {
        return cell.find(',') == std::string::npos ? cell : '"' + cell + '"';
      }

      std::string text;
    };

    /** Computed and reference values. */
    class ComparisonTable
    {
    public:
      /** @p title names the problem and the source of the reference. */
      explicit ComparisonTable(const std::string &title)
        : table(title,
                {"quantity", "computed", "reference", "difference", "allowed"})
      {}

      /** Expects |computed - reference| <= allowed. */
      void row(const std::string &quantity,
               const double       computed,
               const double       reference,
               const double       allowed)
      {
        EXPECT_NEAR(computed, reference, allowed) << quantity;
        table.row({quantity,
                   formatted("%.10g", computed),
                   formatted("%.10g", reference),
                   formatted("%.2g", std::abs(computed - reference)),
                   formatted("%.2g", allowed)});
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
      ResultTable table;
    };
  } // namespace testing_support
} // namespace auxfem

#endif
