#include <auxfem/figures/derived_columns.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  DerivedColumn column(const std::string &name, const std::string &expression)
  {
    return {name, expression, "", {{"A", 2}}, "Columns/" + name};
  }

  const std::vector<std::string> names = {"time",
                                          "upper plate.fy",
                                          "plate.fy",
                                          "top.ux"};

  std::vector<double> values_of(const std::vector<DerivedColumn> &columns)
  {
    std::vector<double> row = {0.5, 8, 3, -1};
    DerivedValues(columns, names).append_to(row);
    return {row.begin() + names.size(), row.end()};
  }

  std::string error_of(const std::vector<DerivedColumn> &columns)
  {
    return input_error_of([&]() { DerivedValues values(columns, names); });
  }
} // namespace

TEST(DerivedColumns, UseOthersAndConstants)
{
  EXPECT_EQ(values_of({column("stress", "upper plate.fy / A"),
                       column("both", "stress + plate.fy * 1.5"),
                       column("late", "if(time > 0.4, abs(top.ux), 0)")}),
            (std::vector<double>{4, 8.5, 1}));
}

TEST(DerivedColumns, RefuseUnknownAndTakenNames)
{
  EXPECT_TRUE(contains(error_of({column("a", "top.uy + 1")}), "top.ux"));
  EXPECT_TRUE(contains(error_of({column("a", "b"), column("b", "1")}), "b"));
  EXPECT_TRUE(contains(error_of({column("time", "1")}), "there is a column"));
  EXPECT_TRUE(contains(error_of({column("a", "1 +")}), "Columns/a = 1 +"));
}

TEST(DerivedColumns, AnUnknownNameIsNamed)
{
  expect_parts(error_of({column("a", "2 * top.uy + abs(A)")}),
               {"there is no \"top.uy\"", "did you mean \"top.ux\""});
  // A column without name is none that others may use.
  const std::string message =
    error_of({column("", "time"), column("b", "force")});
  EXPECT_TRUE(contains(message, "\"force\"")) << message;
}

TEST(ExpressionNames, AreKnownOrUnknownButNoFunctionsAndConstants)
{
  const ExpressionNames found =
    names_in(column("a", "max(upper plate.fy, A) + 1e5 * late.uy - pi"), names);
  EXPECT_EQ(found.known, (std::vector<std::string>{"upper plate.fy"}));
  EXPECT_EQ(found.unknown, (std::vector<std::string>{"late.uy"}));
}
