#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText swept_cantilever()
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .section({1, 1, 1})
      .support("clamp", "0", "clamp");
    return scene.time(1, 0.1, "static");
  }

  Scene sweep_of(const std::vector<std::string> &overrides)
  {
    return read_scene_from_text(swept_cantilever().str(),
                                "test.prm",
                                overrides);
  }

  std::vector<std::string> values_of_sweep(const std::string &values)
  {
    return sweep_of({"Sweep/Time/End time=" + values})
      .sweep.parameters.at(0)
      .values;
  }

  std::string refused_sweep(const std::vector<std::string> &overrides)
  {
    return input_error_of([&]() { cases_of(sweep_of(overrides).sweep); });
  }

  using Values = std::vector<std::string>;
} // namespace

TEST(SweepDefinition, RangesAndLists)
{
  EXPECT_EQ(values_of_sweep("1:2:0.5 ms"), (Values{"1 ms", "1.5 ms", "2 ms"}));
  EXPECT_EQ(values_of_sweep("0.1:0.3:0.1"), (Values{"0.1", "0.2", "0.3"}));
  EXPECT_EQ(values_of_sweep("3:1:-1"), (Values{"3", "2", "1"}));
  EXPECT_EQ(values_of_sweep("1, 2, 4 ms"), (Values{"1 ms", "2 ms", "4 ms"}));
  EXPECT_EQ(values_of_sweep("1 ms, 2 s"), (Values{"1 ms", "2 s"}));
  EXPECT_EQ(values_of_sweep("1, 0, 0; 0, 1, 0"),
            (Values{"1, 0, 0", "0, 1, 0"}));
  EXPECT_EQ(values_of_sweep("star, re-entrant"),
            (Values{"star", "re-entrant"}));
}

TEST(SweepDefinition, NamesArePathsOfParameters)
{
  const SweptParameter swept =
    sweep_of({"Sweep/Sections/all/Height=1, 2"}).sweep.parameters.at(0);
  EXPECT_EQ(swept.path, "Sections/all/Height");
  EXPECT_EQ(swept.name(), "Height");
}

TEST(SweepDefinition, AllCombinationsOfAGrid)
{
  const auto cases =
    cases_of(sweep_of({"Sweep/A=1, 2", "Sweep/B=x, y, z"}).sweep);
  ASSERT_EQ(cases.size(), 6u);
  EXPECT_EQ(cases[0], (Values{"1", "x"}));
  EXPECT_EQ(cases[1], (Values{"1", "y"}));
  EXPECT_EQ(cases[5], (Values{"2", "z"}));
}

// Each tenth of each range has one case; a seed repeats them.
TEST(SweepDefinition, LatinHypercube)
{
  const auto cases_with_seed = [](const std::string &seed) {
    return cases_of(sweep_of({"Sweep/A=0:10 mm",
                              "Sweep/B=5, 6",
                              "Sampling/Samples=10",
                              "Sampling/Seed=" + seed})
                      .sweep);
  };
  const auto cases = cases_with_seed("3");
  ASSERT_EQ(cases.size(), 10u);
  std::set<int> parts;
  unsigned int  n_fives = 0;
  for (const auto &values : cases)
    {
      EXPECT_NE(values[0].find(" mm"), std::string::npos);
      parts.insert(std::floor(std::stod(values[0])));
      n_fives += values[1] == "5";
    }
  EXPECT_EQ(parts.size(), 10u);
  EXPECT_EQ(n_fives, 5u);
  EXPECT_EQ(cases_with_seed("3"), cases);
  EXPECT_NE(cases_with_seed("4"), cases);
}

TEST(SweepDefinition, MistakesAreNamed)
{
  EXPECT_TRUE(contains(refused_sweep({"Sweep/A=0:10 mm"}),
                       "Sweep/A: a range without a step"));
  EXPECT_TRUE(contains(refused_sweep({"Sweep/A=0:10:-1"}),
                       "Sweep/A = 0:10:-1: the step does not lead"));
  EXPECT_TRUE(
    contains(refused_sweep({"Sweep/A=0:b:1"}), "\"b\" is not a number"));
  EXPECT_TRUE(contains(refused_sweep({"Sweep/A=1:2:3:4"}), "at most three"));
  EXPECT_TRUE(contains(refused_sweep({"Sweep/A=0:1000000:1"}), "100000"));
}

TEST(SweepDefinition, CasesHaveTheAnalysisOfTheScene)
{
  const Scene scene = sweep_of(
    {"Sweep/Time/End time=1, 2", "Analysis=static path", "Path/Points=7"});
  EXPECT_TRUE(scene.sweep.is_given());
  const Scene one = scene_of_case(scene, {"Time/End time=2"});
  EXPECT_FALSE(one.sweep.is_given());
  EXPECT_EQ(one.analysis, Analysis::static_path);
  EXPECT_EQ(one.path.max_points, 7u);
  EXPECT_EQ(one.time.end_time, 2);
}
