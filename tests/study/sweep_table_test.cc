#include <auxfem/study/sweep_table.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

using namespace auxfem;

namespace
{
  const Json summary_of_case = Json::parse(
    R"({"program": "auxfem", "counts": {"joints": 3}, "wall_seconds": 1,
        "effective_properties": {"constants": {"E1": 2, "nu12": -1},
                                 "stiffness": [[5, 6]]},
        "energies": {"strain": 4}, "other": {"strain": 8}, "verdict": "sound"})");
} // namespace

TEST(SweepResults, AreTheNumbersOfTheAnalysis)
{
  const NamedResults expected = {{"effective_properties.constants.E1", 2},
                                 {"effective_properties.constants.nu12", -1},
                                 {"effective_properties.stiffness.1.1", 5},
                                 {"effective_properties.stiffness.1.2", 6},
                                 {"energies.strain", 4},
                                 {"other.strain", 8}};
  EXPECT_EQ(results_in(summary_of_case), expected);
}

TEST(SweepResults, NamesAreShortWhereTheyAreUnique)
{
  std::vector<std::string> paths;
  for (const auto &result : results_in(summary_of_case))
    paths.push_back(result.first);
  const std::vector<std::string> expected = {
    "E1",
    "nu12",
    "effective_properties.stiffness.1.1",
    "effective_properties.stiffness.1.2",
    "energies.strain",
    "other.strain"};
  EXPECT_EQ(short_names(paths), expected);
}
