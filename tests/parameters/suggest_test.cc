#include <auxfem/parameters/describe.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  using Names = std::vector<std::string>;

  const Names sets = {"all", "bottom", "left", "notches", "right", "top"};
} // namespace

TEST(Suggest, LettersReplacedMissingSwappedAndAdded)
{
  for (const auto *typo : {"bottpm", "botom", "bototm", "bottoms", "BOTTOM"})
    EXPECT_EQ(nearest_names(typo, sets), Names{"bottom"}) << typo;
}

TEST(Suggest, Beginnings)
{
  EXPECT_EQ(nearest_names("notch", sets), Names{"notches"});
  EXPECT_EQ(nearest_names("topmost", sets), Names{"top"});
}

TEST(Suggest, NothingForNamesFarAway)
{
  EXPECT_EQ(nearest_names("foundation", sets), Names{});
  EXPECT_EQ(nearest_names("", sets), Names{});
  EXPECT_EQ(nearest_names("x", {"y", "z"}), Names{});
}

TEST(Suggest, TheNearestThreeInOrder)
{
  EXPECT_EQ(nearest_names("stub4", {"stubs12", "stub12", "stub1", "stubs"}),
            (Names{"stub1", "stubs", "stub12"}));
}

TEST(Suggest, PresentNameOfARenamedParameter)
{
  const Names newton = {"Tolerance", "Jacobian reuse threshold"};
  EXPECT_EQ(nearest_names("Kept reduction", newton),
            Names{"Jacobian reuse threshold"});
  EXPECT_EQ(nearest_names("Kept reduction", {"Cell", "Columns"}), Names{});
}

TEST(Suggest, EndOfASentence)
{
  EXPECT_EQ(did_you_mean("botom", sets), "; did you mean \"bottom\"?");
  EXPECT_EQ(did_you_mean("cat", {"car", "hat"}),
            "; did you mean \"car\" or \"hat\"?");
  EXPECT_EQ(did_you_mean("foundation", sets), ".");
}
