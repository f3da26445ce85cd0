#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * Two struts of 1 cm thickness with soft faces, 12 mm apart; the upper one
   * moves down by @p way (m).
   */
  SceneText pressed_struts(const double way)
  {
    const std::string motion = text(-way) + " * t";
    return SceneText()
      .frame("0 0; 0.1 0; 0 0.012; 0.1 0.012", "0 1; 2 3")
      .rectangle("bar", 0.01, 0.01, {1e9, 1000})
      .set("Contact/Stiffness", 1e-4)
      .support("below", "0, 1", "clamp")
      .prescribe("above", "2, 3", {"0", motion, "0"})
      .mesh(3)
      .time(1, 0.1, "static");
  }

  /** As above, with a plate that rises from 1 cm below the lower strut. */
  SceneText pressed_by_plate(const double way)
  {
    return pressed_struts(0).add("Plates/press",
                                 "Shape = plane | Position = 0 -0.015 | "
                                 "Normal = 0 1 | Displacement y = " +
                                   text(way) + " * t");
  }

  std::vector<std::string> deep_contacts(const SceneText &scene)
  {
    std::vector<std::string> texts;
    for (const Finding &finding : findings_of(scene.str()))
      if (finding.text.find("of its thickness into") != std::string::npos)
        {
          EXPECT_EQ(finding.verdict, Verdict::doubtful);
          EXPECT_NEAR(finding.time, 1, 1e-12);
          texts.push_back(finding.text);
        }
    return texts;
  }
} // namespace

TEST(ContactWatch, ReportsDeepPenetrationOfStruts)
{
  // Faces are so soft that the motion equals the penetration.
  EXPECT_TRUE(deep_contacts(pressed_struts(0.002 + 0.0008)).empty());
  const auto texts = deep_contacts(pressed_struts(0.002 + 0.0015));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_NE(texts[0].find("goes 15 % of its thickness into strut "),
            std::string::npos)
    << texts[0];
}

TEST(ContactWatch, ReportsDeepPenetrationOfPlates)
{
  EXPECT_TRUE(deep_contacts(pressed_by_plate(0.01 + 0.0008)).empty());
  const auto texts = deep_contacts(pressed_by_plate(0.01 + 0.0015));
  ASSERT_EQ(texts.size(), 1u);
  EXPECT_NE(texts[0].find(
              "strut 0 goes 15 % of its thickness into the plate \"press\""),
            std::string::npos)
    << texts[0];
}

TEST(ContactWatch, LargestPenetrationIncludesSubsteps)
{
  // In one step down by 3.5 mm, at the kink, and up again.
  SceneText scene = pressed_struts(0);
  scene.set("Supports/above/Displacement y", "-0.0035 * min(2 * t, 2 - 2 * t)")
    .set("Effects/Large rotation", "on")
    .time(1, 1, "static");
  const RunResult result = result_of(scene.str());
  ASSERT_TRUE(result.completed());
  ASSERT_TRUE(result.largest_penetration);
  EXPECT_NEAR(*result.largest_penetration, 0.15, 0.005);

  scene.set("Effects/Contact", "off");
  EXPECT_FALSE(result_of(scene.str()).largest_penetration);
}

TEST(ContactWatch, ReportsPlatesThatPassThroughStruts)
{
  const auto told = [](const double way) {
    std::vector<Finding> found;
    for (const Finding &finding :
         findings_of(pressed_by_plate(way).set("Effects/Contact", "off")))
      if (finding.text.find("into the plate \"press\": contact is disabled") !=
          std::string::npos)
        found.push_back(finding);
    return found;
  };
  // The lower face is 1 cm from the plate, which moves in ten steps.
  const auto found = told(0.0122);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].verdict, Verdict::doubtful);
  EXPECT_EQ(found[0].location, "strut 0");
  EXPECT_NEAR(found[0].time, 0.9, 1e-12);
  EXPECT_TRUE(told(0.0095).empty());
  EXPECT_TRUE(told(-0.0122).empty());
}
