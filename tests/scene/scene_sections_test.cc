#include <auxfem/scene/scene_sections.h>

#include <gtest/gtest.h>

namespace
{
  using namespace auxfem;

  TEST(SceneSections, EntriesAreListedInOrder)
  {
    const std::vector<DeclaredEntry> entries =
      declared_entries([](dealii::ParameterHandler &prm) {
        declare(prm, Quantity{"Z", "", "m", Range::positive(), "First one."});
        declare(prm, Choice{"Young's a/b", "x", {"x", "y"}, "Second one."});
      });
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0].name, "Z");
    EXPECT_EQ(entries[0].sentence, "First one.");
    EXPECT_TRUE(entries[0].required());
    EXPECT_EQ(entries[0].problem("1 mm"), "");
    EXPECT_NE(entries[0].problem("0"), "");
    EXPECT_EQ(entries[1].name, "Young's a/b");
    EXPECT_EQ(entries[1].default_value, "x");
    EXPECT_FALSE(entries[1].required());
    EXPECT_NE(entries[1].problem(""), "");
  }



  TEST(SceneSections, PatternsOfDealIIAreUnderstood)
  {
    const std::vector<DeclaredEntry> entries =
      declared_entries([](dealii::ParameterHandler &prm) {
        prm.declare_entry("N", "1", dealii::Patterns::Integer(1, 3), "Plain.");
      });
    ASSERT_EQ(entries.size(), 1u);
    EXPECT_FALSE(entries[0].rule);
    EXPECT_FALSE(entries[0].required());
    EXPECT_EQ(entries[0].problem("3"), "");
    EXPECT_NE(entries[0].problem("4"), "");
    EXPECT_NE(entries[0].allowed(), "");
  }



  TEST(SceneSections, EveryEntryHasASentence)
  {
    const auto check = [](const auto &declare) {
      for (const DeclaredEntry &entry : declared_entries(declare))
        {
          EXPECT_GT(entry.sentence.size(), 3u) << entry.name;
          EXPECT_EQ(entry.sentence.back(), '.') << entry.name;
        }
    };
    for (const SubsectionKind &kind : subsection_kinds())
      {
        check(kind.declare);
        EXPECT_EQ(kind.choice.empty(), kind.variants.empty()) << kind.name;
        for (const SubsectionVariant &variant : kind.variants)
          check(variant.declare);
      }
  }
} // namespace
