#include <analysis/simulation/resumed_run.h>
#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/one_mass_scene.h>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * A clamped strut of 1 m and EI = 1 N m2 under 70 N of compression at t = 1.
   */
  SceneText pressed_strut(const unsigned int order,
                          const unsigned int refinements)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .section({1e6, 1e7, 1})
      .support("foot", "0", "clamp")
      .prescribe("press", "1", {"-70e-6 * t", "0", "0"})
      .set("Effects/Large rotation", "on")
      .mesh(order, refinements)
      .time(1, 0.0025, "static");
  }

  /** The finding that contains these words; nullptr if there is none. */
  const Finding *with_words(const std::vector<Finding> &findings,
                            const std::string          &words)
  {
    for (const Finding &finding : findings)
      if (finding.text.find(words) != std::string::npos)
        return &finding;
    return nullptr;
  }

  /** A spring of 1 m from the ground, whose end joint is moved. */
  SceneText shortened_spring(const std::string &motion)
  {
    return SceneText()
      .frame("0 -1; 1 -1; 1 0", "0 1; 1 2")
      .circle("idle", 1e-3, {1, 1})
      .support("idle", "0, 1", "clamp")
      .prescribe("moved", "2", {motion, "0.01", "free"})
      .connector("spring",
                 "spring",
                 "Between = ground: 2 | Ground offset = -1, 0 | "
                 "Spring stiffness = 1")
      .time(1, 0.05, "static");
  }

  /**
   * Without inertia: 1 kg on a spring of (2 pi)^2 N/m, with a period of 1 s,
   * and a dashpot, under a force with a rise time (s).
   */
  SceneText loaded_mass(const double      rise,
                        const std::string law = "kelvin-voigt")
  {
    return one_mass_scene("Law = " + law +
                            " | Spring stiffness = " + text(4 * pi * pi) +
                            (law == "spring" ? ""
                                             : " | Damping coefficient = 0.5"),
                          "Scheme = static | End time = 10 | Time step = 0.02",
                          SceneText().mass("body", "0", 1))
      .load("push", "0", {"min(1, t / " + text(rise) + ")", "0", "0"});
  }

  /**
   * Two clamped struts in line, of different lengths, EI = rho A = 1. Their
   * joint moves laterally at a frequency (rad/s) for some periods.
   */
  SceneText shaken_struts(const double omega, const unsigned int refinements)
  {
    const double period = 2 * pi / omega;
    return SceneText()
      .frame("0 0; 1 0; 2.1 0", "0 1; 1 2")
      .section({1e4, 1e6, 1})
      .set("Sections/section 0/Density", 1e-4)
      .support("feet", "0, 2", "clamp")
      .prescribe("shake",
                 "1",
                 {"0",
                  "1e-3 * sin(" + text(omega) + " * t) * (1 - exp(-(t / " +
                    text(period) + ")^2))",
                  "free"})
      .mesh(2, refinements)
      .time(10 * period, period / 60, "newmark");
  }
} // namespace

TEST(LocalBucklingWatch, ReportsBucklingThatTheMeshCannotShow)
{
  // Euler: 4 pi^2 EI / L^2 between clamps.
  const auto lost_at = [](const std::vector<Finding> &findings) {
    const Finding *lost = with_words(findings, "Stability is lost");
    return lost == nullptr ? 0. : 70 * lost->time / (4 * pi * pi);
  };
  const auto order_2 = findings_of(pressed_strut(2, 0)),
             order_3 = findings_of(pressed_strut(3, 0)),
             order_4 = findings_of(pressed_strut(4, 0)),
             finer   = findings_of(pressed_strut(3, 1));
  EXPECT_EQ(lost_at(order_2), 0.);
  EXPECT_NEAR(lost_at(order_3), 1.52, 0.01);
  EXPECT_NEAR(lost_at(order_4), 1.064, 0.01);
  EXPECT_NEAR(lost_at(finer), 1.013, 0.01);

  const std::string words      = "buckle between their joints";
  const Finding    *buckling_2 = with_words(order_2, words),
                *buckling_3    = with_words(order_3, words);
  ASSERT_NE(buckling_2, nullptr);
  EXPECT_NEAR(buckling_2->time, pi * pi / 70, 0.011);
  EXPECT_EQ(buckling_2->location, "strut 0");
  ASSERT_NE(buckling_3, nullptr);
  EXPECT_NEAR(buckling_3->time, 20.19 / 70, 0.011);
  EXPECT_EQ(with_words(order_4, words), nullptr);
  EXPECT_EQ(with_words(finer, words), nullptr);
  EXPECT_TRUE(
    findings_of(pressed_strut(2, 0).set("Time/End time", 0.14)).empty());
}

TEST(YieldWatch, ReportsTheFirstYieldingStrut)
{
  // Stretched by 1 and 2 % a second.
  const auto pulled = [](const std::string &yield_strain) {
    return findings_of(SceneText()
                         .frame("0 0; 1 0; 1.5 0", "0 1; 1 2")
                         .circle("s", 1e-3, {1e9})
                         .set("Sections/s/Yield strain", yield_strain)
                         .support("foot", "0", "clamp")
                         .prescribe("one", "1", {"0.01 * t", "0", "0"})
                         .prescribe("other", "2", {"0.02 * t", "0", "0"})
                         .time(1, 0.1, "static"));
  };
  const auto found = pulled("0.0151");
  ASSERT_EQ(found.size(), 1u) << verdict_text(found);
  EXPECT_EQ(found[0].verdict, Verdict::doubtful);
  EXPECT_EQ(found[0].location, "strut 1");
  EXPECT_NEAR(found[0].time, 0.8, 1e-9);
  EXPECT_NE(found[0].text.find("of 2 %"), std::string::npos) << found[0].text;
  EXPECT_TRUE(pulled("0.021").empty());
  EXPECT_TRUE(pulled("none").empty());
}

namespace
{
  /** A cantilever of 0.2 m with 1 N at its end: 2.143e-4 = F L c / EI at the
   * clamp, by EI = 70e9 * 0.02 * 0.002^3 / 12 and c = 1 mm. */
  SceneText bent_strip(const std::string &yield_strain)
  {
    return SceneText()
      .frame("0 0; 0.2 0", "0 1")
      .rectangle("strip", "20 mm", "2 mm", {"70 GPa", 2700})
      .set("Sections/strip/Yield strain", yield_strain)
      .support("clamp", "0", "clamp")
      .load("tip", "1", {"0", "-t", "0"})
      .time(1, 0.5, "static");
  }

  /** The same strip, given by its stiffnesses. */
  SceneText bent_strip_of_given_section(const std::string &yield_strain)
  {
    return bent_strip(yield_strain)
      .remove("Sections/strip/Width")
      .remove("Sections/strip/Height")
      .add("Sections/strip",
           "Shape = given | Area = 4e-5 | Shear area = 3.33e-5 | "
           "Second moment of area = 1.33333e-11");
  }
} // namespace

TEST(YieldWatch, KnowsTheStrainAtAClamp)
{
  for (const unsigned int order : {2u, 3u, 5u})
    {
      EXPECT_EQ(findings_of(bent_strip("2.13e-4").mesh(order)).size(), 1u);
      EXPECT_TRUE(findings_of(bent_strip("2.16e-4").mesh(order)).empty());
    }
}

TEST(YieldWatch, KnowsTheStrainBetweenTheEndsOfAnElement)
{
  // q L^2 / 8 = 0.2 N m in the middle of a strut on two supports, as above.
  const auto on_two_supports = [](const std::string &yield_strain) {
    SceneText scene = bent_strip(yield_strain);
    return scene.remove("Loads")
      .support("clamp", "0", "pin")
      .support("end", "1", "roller x")
      .add("Loads/line",
           "Type = line | Struts = all | Force per length y = -40*t")
      .mesh(3)
      .set("Effects/Large rotation", "off");
  };
  EXPECT_EQ(findings_of(on_two_supports("2.13e-4")).size(), 1u);
  EXPECT_TRUE(findings_of(on_two_supports("2.16e-4")).empty());
}

TEST(YieldWatch, KnowsTheFibresOfGivenSections)
{
  const auto with_fibre = [](const std::string &yield_strain) {
    return findings_of(bent_strip_of_given_section(yield_strain)
                         .set("Sections/strip/Extreme fibre", "1 mm"));
  };
  EXPECT_EQ(with_fibre("2.13e-4").size(), 1u);
  EXPECT_TRUE(with_fibre("2.16e-4").empty());
  // Without a fibre distance it is at least the radius of gyration, 2 mm /
  // 12^1/2.
  const auto without = [](const std::string &yield_strain) {
    return findings_of(bent_strip_of_given_section(yield_strain));
  };
  EXPECT_EQ(without("1.23e-4").size(), 1u);
  EXPECT_TRUE(without("1.25e-4").empty());
}

TEST(ConnectorWatch, ReportsConnectorsWithoutLength)
{
  EXPECT_TRUE(findings_of(shortened_spring("-0.9 * t")).empty());
  const auto shortened = findings_of(shortened_spring("-0.99 * t"));
  ASSERT_EQ(shortened.size(), 1u) << verdict_text(shortened);
  EXPECT_EQ(shortened[0].verdict, Verdict::doubtful);
  EXPECT_NEAR(shortened[0].time, 0.96, 0.051);
  EXPECT_EQ(shortened[0].location, "connector spring of joint 2");
  // Moves from a tenth before the end to a tenth behind it in one step.
  const auto jumped =
    findings_of(shortened_spring("-0.9 * min(1, t / 0.9) - 2 * max(0, t - 0.9)")
                  .set("Time/Time step", 0.1));
  EXPECT_NE(with_words(jumped, "one connector inverts"), nullptr)
    << verdict_text(jumped);
}

TEST(LoadSpeedWatch, KnowsTheKineticEnergyOfARamp)
{
  // (T / 2 pi t)^2 > 0.01: t < 1.59 periods.
  const auto fast = findings_of(loaded_mass(1.5));
  ASSERT_EQ(fast.size(), 1u) << verdict_text(fast);
  EXPECT_EQ(fast[0].verdict, Verdict::doubtful);
  // (1 / 3 pi)^2 = 0.01126
  EXPECT_NE(fast[0].text.find("energy of 1.1 %"), std::string::npos)
    << fast[0].text;
  EXPECT_TRUE(findings_of(loaded_mass(1.7)).empty());
}

TEST(LoadSpeedWatch, IsSilentInElasticStatics)
{
  EXPECT_TRUE(findings_of(loaded_mass(0.1, "spring")).empty());
}

TEST(LoadSpeedWatch, AcceptsSuddenLoads)
{
  // A spring and a parallel Maxwell element: they respond at once, and creep.
  const SceneText sudden =
    loaded_mass(1)
      .set("Connectors/link/Law", "standard-linear-solid")
      .remove("Connectors/link/Spring stiffness")
      .remove("Connectors/link/Damping coefficient")
      .add("Connectors/link",
           "Long-time stiffness = 40 | Spring stiffness = 40 | "
           "Damping coefficient = 100")
      .set("Loads/push/Force x", 1);
  EXPECT_TRUE(findings_of(sudden).empty());
}

TEST(LeftOutWatches, AgreeInResumedRuns)
{
  for (const std::string &scene : {std::string(pressed_strut(2, 0)),
                                   std::string(pressed_strut(3, 0)),
                                   std::string(shortened_spring("-0.99 * t")),
                                   std::string(loaded_mass(1.5)),
                                   std::string(shaken_struts(12, 0))})
    EXPECT_GE(expect_same_when_resumed(scene).result.findings.size(), 1u);
}

TEST(LeftOutWatchesOnRanks, FindTheSame)
{
  for (const std::string &scene : {std::string(shaken_struts(12, 0)),
                                   std::string(shortened_spring("-0.99 * t"))})
    {
      const auto alone    = findings_of(scene),
                 together = findings_of(scene, {}, MPI_COMM_WORLD);
      ASSERT_EQ(alone.size(), 1u);
      ASSERT_EQ(together.size(), 1u);
      EXPECT_EQ(together[0].text, alone[0].text);
      EXPECT_EQ(together[0].location, alone[0].location);
      EXPECT_EQ(together[0].time, alone[0].time);
    }
}
