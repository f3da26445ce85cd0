#include <auxfem/output/csv_table.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::string path(const std::string &name)
  {
    return std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) + "/csv_table_" + name;
  }

} // namespace

TEST(CsvTable, RowsAreFlushed)
{
  const std::string file = path("rows.csv");
  CsvTable          table(file, {{"time", "s", "time"}, {"top.ux", "m", ""}});
  EXPECT_EQ(read_text(file), "time,top.ux\n");

  table.append({0, -0.25});
  EXPECT_EQ(read_text(file), "time,top.ux\n0,-0.25\n");
  table.append({1e-5, 3});
  EXPECT_EQ(read_text(file), "time,top.ux\n0,-0.25\n1e-05,3\n");
}

TEST(CsvTable, NumbersHave15Digits)
{
  const std::string         file   = path("digits.csv");
  const std::vector<double> values = {1. / 3,
                                      -2.3e-308,
                                      1.797e308,
                                      123456789.123456789,
                                      0.02};
  CsvTable(file, std::vector<Column>(values.size())).append(values);

  std::ifstream stream(file);
  std::string   header, number;
  std::getline(stream, header);
  for (const double &value : values)
    {
      char expected[40];
      std::snprintf(expected, sizeof(expected), "%.15g", value);
      std::getline(stream, number, &value == &values.back() ? '\n' : ',');
      EXPECT_EQ(number, expected);
    }
}

TEST(CsvTable, NumbersThatAreNotFiniteAreVisible)
{
  const std::string file = path("nan.csv");
  CsvTable(file, std::vector<Column>(2))
    .append({std::numeric_limits<double>::quiet_NaN(),
             -std::numeric_limits<double>::infinity()});
  EXPECT_EQ(read_text(file), ",\nnan,-inf\n");
}

TEST(CsvTable, NamesWithCommasAreQuoted)
{
  const std::string         file    = path("quoted.csv");
  const std::vector<Column> columns = {{"a, \"b\".ux", "m", "mean, of two"}};
  CsvTable(file, columns).append({1});
  EXPECT_EQ(read_text(file), "\"a, \"\"b\"\".ux\"\n1\n");

  write_column_reference(file, columns);
  EXPECT_EQ(read_text(file),
            "column,unit,meaning\n\"a, \"\"b\"\".ux\",m,\"mean, of two\"\n");
}

TEST(CsvTable, UnwritableFileIsRejected)
{
  const std::string file = path("no_such_folder/history.csv");
  try
    {
      CsvTable table(file, {{"time", "s", "time"}});
      FAIL();
    }
  catch (const InputError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find(file), std::string::npos);
      EXPECT_NE(message.find("No such file or directory"), std::string::npos);
      EXPECT_NE(message.find("--output DIR"), std::string::npos);
    }
}

TEST(CsvTable, FullDiskIsReported)
{
  // This device of Linux can be opened but refuses every byte.
  if (!std::ofstream("/dev/full"))
    GTEST_SKIP();
  const std::vector<Column> columns = {{"time", "s", "time"}};
  EXPECT_THROW(CsvTable("/dev/full", columns), ComputationError);
  EXPECT_THROW(write_column_reference("/dev/full", columns), ComputationError);
}
