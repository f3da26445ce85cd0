#include <auxfem/study/scene_cases.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>
#include <fstream>
#include <string>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** The quantity @p text of a history that rises by 1 a second from 0 to 3. */
  double quantity(const std::string &text)
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .section({1, 1, 1})
      .support("clamp", "0", "clamp")
      .time(3, 1, "static")
      .set("Quantities/found", text);
    RecordedTable history;
    history.names   = {"time", "force"};
    history.columns = {{0, 1, 2, 3}, {0, 1, 2, 3}};
    const NamedResults found =
      quantities_in(read_scene_from_text(scene.str(), "test.prm"), history);
    EXPECT_EQ(found.size(), 1u);
    return found.at(0).second;
  }

  /** Mean square deviation from a table of zeros from @p first to @p last (s).
   */
  double deviation_from_zeros(const std::string &first, const std::string &last)
  {
    std::ofstream("zeros.csv") << "time,force\n"
                               << first << ",0\n"
                               << last << ",0\n";
    return quantity("mean square deviation of force from table: zeros.csv");
  }
} // namespace

TEST(QuantitiesOfCases, AreKnownWithinTheHistory)
{
  EXPECT_NEAR(quantity("force at 2 s"), 2, 1e-14);
  EXPECT_NEAR(quantity("force at 3 s"), 3, 1e-14);
  EXPECT_TRUE(std::isnan(quantity("force at 3.1 s")));
}

// The squares 0, 1, 4, 9 are integrated as far as the table reaches.
TEST(QuantitiesOfCases, DeviateFromWhatIsKnownOfATable)
{
  const double all = deviation_from_zeros("0", "3"),
               end = deviation_from_zeros("1", "5");
  EXPECT_NEAR(all, 3, 0.1);
  EXPECT_NEAR(end, 13. / 3, 0.1);
  EXPECT_TRUE(std::isnan(deviation_from_zeros("3.5", "5")));
  EXPECT_TRUE(std::isnan(deviation_from_zeros("-2", "-1")));
}

TEST(QuantitiesOfCases, TakeThePlaceOfResultsOfTheirName)
{
  NamedResults results = {{"mass_kilogram", 1}, {"peak", 2}};
  add_quantities({{"mass_kilogram", 3}}, results);
  const NamedResults expected = {{"peak", 2}, {"mass_kilogram", 3}};
  EXPECT_EQ(results, expected);
}
