#include <analysis/simulation/resumed_run.h>
#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A rod of 1 m with a wave speed of 100 m/s hits a wall at 0.5 m/s; contact
   * lasts 20 ms. A second rod flies beside it, @p beside times as thick.
   */
  SceneText rods(const std::string &step, const double beside = 1)
  {
    return SceneText()
      .frame("0 0; 1 0; 0 5; 1 5", "0 1; 2 3")
      .rectangle("rod", 0.02, 0.02, {1e7, 1000})
      .set("Sections/rod/Struts", "0")
      .rectangle("beside", 0.02 * beside, 0.02, {1e7, 1000})
      .set("Sections/beside/Struts", "1")
      .mesh(2, 2)
      .add("Initial velocities/flight", "Joints = 0, 1 | Velocity x = 0.5")
      .add("Initial velocities/away", "Joints = 2, 3 | Velocity x = -0.5")
      .add("Plates/wall", "Shape = plane | Normal = -1 0 | Position = 1.015 0")
      .time("60 ms", step, "newmark");
  }

  /** Findings on impacts. */
  std::vector<Finding> impacts(const SceneText &scene,
                               const MPI_Comm   communicator = MPI_COMM_SELF)
  {
    std::vector<Finding> found;
    for (const Finding &finding : findings_of(scene, {}, communicator))
      if (finding.text.find("hits the plate \"wall\" for") != std::string::npos)
        {
          EXPECT_EQ(finding.verdict, Verdict::doubtful);
          EXPECT_EQ(finding.location, "strut 0");
          found.push_back(finding);
        }
    return found;
  }
} // namespace

TEST(ImpactWatch, ReportsContactShorterThanAboutThreeSteps)
{
  const auto found = impacts(rods("15 ms"));
  ASSERT_EQ(found.size(), 1u);
  // The rod reaches the wall after 10 ms.
  EXPECT_NEAR(found[0].time, 0.02, 0.011);
  EXPECT_NE(found[0].text.find("Set Time/Relative tolerance"),
            std::string::npos)
    << found[0].text;
  EXPECT_TRUE(impacts(rods("1 ms")).empty());
}

TEST(ImpactWatch, AdaptiveStepsResolveImpacts)
{
  EXPECT_TRUE(
    impacts(rods("15 ms").set("Time/Relative tolerance", 1e-2)).empty());
}

TEST(ImpactWatch, IgnoresContactWithSmallImpulse)
{
  EXPECT_TRUE(impacts(rods("15 ms", 1e5)).empty());
}

namespace
{
  /** A plate of 1 kg falls on a standing rod with damping. */
  SceneText rod_that_is_struck(const std::string &step)
  {
    return SceneText()
      .frame("0 0; 0 1", "0 1")
      .rectangle("rod", 0.02, 0.02, {1e7, 1000})
      .set("Sections/rod/Stiffness-proportional damping", "10 ms")
      .support("foot", "0", "clamp")
      .mesh(2, 2)
      .add("Plates/weight",
           "Shape = plane | Normal = 0 -1 | Position = 0 1.011 | Mass = 1 | "
           "Displacement y = free | Initial velocity y = -0.5")
      .set("Contact/Stiffness", 10)
      .time("20 ms", step, "energy-momentum");
  }

  std::vector<Finding> peaks(const SceneText &scene)
  {
    std::vector<Finding> found;
    for (const Finding &finding : findings_of(scene, {}, MPI_COMM_SELF))
      if (finding.text.find("The largest force on the plate \"weight\"") !=
          std::string::npos)
        found.push_back(finding);
    return found;
  }
} // namespace

TEST(ImpactWatch, NotesUnresolvedPeaks)
{
  const auto found = peaks(rod_that_is_struck("0.2 ms"));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, Verdict::sound);
  // The plate falls by 1 mm.
  EXPECT_NEAR(found[0].time, 0.002, 1e-3);
  EXPECT_TRUE(peaks(rod_that_is_struck("0.05 ms")).empty());
}

TEST(ImpactWatch, IsUnchangedByARestart)
{
  ASSERT_EQ(impacts(rods("7 ms")).size(), 1u);
  EXPECT_EQ(expect_same_when_resumed(rods("7 ms")).result.findings.size(),
            findings_of(rods("7 ms")).size());
}

TEST(ImpactWatchOnRanks, FindsTheSame)
{
  const auto alone    = impacts(rods("15 ms")),
             together = impacts(rods("15 ms"), MPI_COMM_WORLD);
  ASSERT_EQ(alone.size(), 1u);
  ASSERT_EQ(together.size(), 1u);
  EXPECT_EQ(together[0].text, alone[0].text);
}
