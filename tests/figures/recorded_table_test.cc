#include <auxfem/figures/recorded_table.h>
#include <auxfem/output/csv_table.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::string file_named(const std::string &name)
  {
    return ::testing::TempDir() + "/" + name;
  }
} // namespace

TEST(RecordedTable, ReadsWhatATableHasWritten)
{
  const std::string file = file_named("recorded_table.csv");
  {
    CsvTable table(file, {{"time", "s", ""}, {"a, \"b\".ux", "m", ""}});
    table.append({0, 1. / 3});
    table.append({1e-3, NAN});
  }
  const RecordedTable table = read_table(file);
  EXPECT_EQ(table.names, (std::vector<std::string>{"time", "a, \"b\".ux"}));
  ASSERT_EQ(table.n_rows(), 2);
  EXPECT_NEAR(table.columns[1][0], 1. / 3, 1e-15);
  EXPECT_TRUE(std::isnan(table.columns[1][1]));
  EXPECT_EQ(table.history("a, \"b\".ux").times[1], 1e-3);
  EXPECT_EQ(table.find("b"), nullptr);
  EXPECT_TRUE(contains(input_error_of([&]() { table.history("b"); }), "time"));
}

TEST(RecordedTable, LeavesOutALineThatIsNotComplete)
{
  const std::string file = file_named("cut_table.csv");
  write_text(file, "time,x\n0,1\n1,2\n2,3");
  EXPECT_EQ(read_table(file).n_rows(), 2);
  EXPECT_EQ(read_table(file_named("no such table.csv")).n_rows(), 0);
}
