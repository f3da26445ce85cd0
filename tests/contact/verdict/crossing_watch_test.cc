#include <analysis/simulation/resumed_run.h>
#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Bars of radius 10 mm; joint 0 is moved. */
  SceneText bars(const unsigned int dimension,
                 const std::string &joints,
                 const std::string &struts,
                 const std::string &held,
                 const std::string &motion)
  {
    return SceneText()
      .dimension(dimension)
      .frame(joints, struts)
      .circle("s", "10 mm", {"1 GPa", 1000})
      .support("held", held, "clamp")
      .add("Supports/moved", "Joints = 0 | Type = prescribed | " + motion)
      .set("Effects/Contact", "off")
      .time(1, 0.01, "static");
  }

  /** A cantilever whose end moves through a bar at y = 0.2. */
  std::string bent_through(const std::string &motion)
  {
    return bars(2,
                "0.9 0; 0 0; 0.6 0.2; 1.5 0.2",
                "0 1; 2 3",
                "1, 2, 3",
                "Displacement y = " + motion);
  }

  /** As above in space, beside the bar. */
  std::string bent_past(const std::string &z)
  {
    return bars(3,
                "0.9 0 0; 0 0 0; 0.8 0.2 " + z + "; 0.8 0.2 -1",
                "0 1; 2 3",
                "1, 2, 3",
                "Displacement y = 0.4 * t");
  }
} // namespace

TEST(CrossingWatch, ReportsCrossingStrutsAndTheirTime)
{
  const auto found = findings_of(bent_through("0.4 * t"));
  ASSERT_EQ(found.size(), 1u) << verdict_text(found);
  EXPECT_EQ(found[0].verdict, Verdict::doubtful);
  // Contact distance is 20 mm; checks are two steps apart.
  EXPECT_NEAR(found[0].time, 0.45, 0.101);
  EXPECT_NE(found[0].text.find("touch"), std::string::npos) << found[0].text;
  EXPECT_NE(found[0].text.find("have passed into each other"),
            std::string::npos);
  EXPECT_EQ(found[0].location, "strut 0");
  EXPECT_NE(found[0].text.find("0 and 1"), std::string::npos) << found[0].text;

  const auto touching = findings_of(bent_through("0.19 * t"));
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].text.find("passed"), std::string::npos);
  const auto short_of = findings_of(bent_through("0.175 * t"));
  EXPECT_TRUE(short_of.empty()) << verdict_text(short_of);
}

TEST(CrossingWatch, ChecksSmallDisplacementsSetByTheUserToo)
{
  // A bar translates through another, so all energies are round-off.
  const auto led = [](const std::string &way) {
    return findings_of(SceneText()
                         .frame("0 0; 1 0; 0.3 0.1; 0.7 0.1", "0 1; 2 3")
                         .circle("s", "10 mm", {"1 GPa", 1000})
                         .support("held", "2, 3", "clamp")
                         .prescribe("led", "0, 1", {"0", way, "0"})
                         .set("Effects/Large rotation", "off")
                         .time(1, 0.01, "static"));
  };
  const auto found = led("0.15 * t");
  ASSERT_EQ(found.size(), 1u) << verdict_text(found);
  // Contact from 80 mm to 120 mm, checked every 20 mm.
  EXPECT_GE(found[0].time, 0.08 / 0.15);
  EXPECT_LE(found[0].time, 0.101 / 0.15);
  EXPECT_NE(found[0].text.find("set Effects/Large rotation"), std::string::npos)
    << found[0].text;
  EXPECT_TRUE(led("0.075 * t").empty());
}

TEST(CrossingWatch, AStrutMayCrossItself)
{
  // Its end rotates by more than a turn and passes its start.
  const std::string motion = "Displacement x = -0.95 * t | "
                             "Displacement y = 0.3 * sin(pi * t) - 0.05 * t | "
                             "Rotation z = 2 * pi * t";
  const SceneText   loop   = bars(2, "1 0; 0 0", "0 1", "1", motion).mesh(3, 3);
  const auto        found  = findings_of(loop);
  ASSERT_FALSE(found.empty());
  bool is_told = false;
  for (const Finding &finding : found)
    is_told |= finding.text.find("crosses itself") != std::string::npos;
  EXPECT_TRUE(is_told) << verdict_text(found);
}

TEST(CrossingWatch, ConsidersThicknessInSpace)
{
  // Moves along y past the end of a bar along z: overlapping by 15 mm, and
  // beside it.
  const auto through = findings_of(bent_past("0.005"));
  ASSERT_EQ(through.size(), 1u) << verdict_text(through);
  EXPECT_NEAR(through[0].time, 0.5, 0.05);
  const auto beside = findings_of(bent_past("-0.025"));
  EXPECT_TRUE(beside.empty()) << verdict_text(beside);
}

TEST(CrossingWatch, IsUnchangedByARestart)
{
  for (const char *motion : {"0.4 * t", "0.4 * sin(3 * t)"})
    EXPECT_EQ(
      expect_same_when_resumed(bent_through(motion)).result.findings.size(),
      1u);
}

TEST(CrossingWatchOnRanks, FindsTheSame)
{
  for (const std::string &scene : {bent_through("0.4 * t"), bent_past("0.005")})
    {
      const auto alone    = findings_of(scene),
                 together = findings_of(scene, {}, MPI_COMM_WORLD);
      ASSERT_EQ(alone.size(), 1u);
      ASSERT_EQ(together.size(), 1u);
      EXPECT_EQ(together[0].text, alone[0].text);
      EXPECT_EQ(together[0].time, alone[0].time);
    }
}

TEST(CrossingWatch, StraightBarsOfATrussCrossNothing)
{
  const auto pounds = [](const double force) {
    return text(4.4482216 * force);
  };
  for (unsigned int i = 1; i <= 15; ++i)
    {
      const auto found = findings_of(
        SceneText()
          .frame("0 0; 3.6576 0; 4.2672 0; 1.8288 2.4384", "0 3; 1 3; 2 3")
          .section({1.33e8, 1.33e8, 8.6e3}, "0")
          .section({6.67e7, 6.67e7, 8.6e3}, "1, 2")
          .hinge("pins", "all")
          .support("ground", "0, 1, 2", "pin")
          .load("P", "3", {pounds(1e3 * i), pounds(-5e2 * i), "0"})
          .time(1, 1, "static"));
      EXPECT_EQ(verdict_text(found).find("cross"), std::string::npos) << i;
    }
}
