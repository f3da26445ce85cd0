#include <auxfem/output/verdict.h>

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

using namespace auxfem;

namespace
{
  const std::vector<Finding> found = {
    {Verdict::not_to_be_used, "Too much energy.", 0.5, ""},
    {Verdict::doubtful, "Stability is lost.", 0.25, "joint 3"}};
}

TEST(Verdict, EqualsWorstFinding)
{
  EXPECT_EQ(verdict_of({}), Verdict::sound);
  EXPECT_EQ(verdict_of({found[1]}), Verdict::doubtful);
  EXPECT_EQ(verdict_of(found), Verdict::not_to_be_used);
  EXPECT_EQ(verdict_of({found[1], found[0]}), Verdict::not_to_be_used);
}

TEST(Verdict, NamesItsReasonsInWords)
{
  EXPECT_EQ(verdict_text({}), "Verdict: sound");
  EXPECT_EQ(verdict_text(found),
            "Verdict: not to be used\n"
            "  Too much energy.\n"
            "  Stability is lost.");
}

TEST(Verdict, IsInSummaryWithTimeAndLocation)
{
  Json sound;
  add_verdict(sound, {});
  EXPECT_EQ(json_text(sound),
            "{\n  \"verdict\": \"sound\",\n  \"warnings\": []\n}");

  Json summary;
  add_verdict(summary, found);
  EXPECT_EQ(summary.at("verdict"), "not to be used");
  const Json  loss     = {{"verdict", "doubtful"},
                          {"text", "Stability is lost."},
                          {"time", 0.25},
                          {"location", "joint 3"}};
  const auto &warnings = summary.at("warnings");
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(), loss), 1)
    << json_text(summary);
}
