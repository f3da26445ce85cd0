#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A cantilever of 1 m in two struts, sqrt(EI / rho A) = 1.41 m2/s, excited
   * at its end; its second frequency is 31 rad/s. */
  SceneText shaken(const unsigned int order, const double frequency)
  {
    return SceneText()
      .frame("0 0; 0.5 0; 1 0", "0 1; 1 2")
      .given("s", {0.01, 100, 2e-6}, {1e6, 100})
      .support("foot", "0", "clamp")
      .add("Loads/shake",
           "Joints = 2 | Force y = 0.01 * sin(" + text(frequency) + " * t)")
      .mesh(order)
      .probe("tip", "2")
      .time(1, "2 ms", "newmark");
  }

  struct ShakenTip
  {
    std::vector<Finding> findings;
    std::vector<double>  tip; ///< m
  };

  ShakenTip shaken_tip(const std::string &text)
  {
    const Scene    scene = read_scene_from_text(text, "test.prm");
    MemoryRecorder recorder(scene, MPI_COMM_SELF);
    const auto     findings = run(scene, MPI_COMM_SELF, recorder).findings;
    return {findings, recorder.column("tip.uy")};
  }

  double tip_difference(const std::vector<double> &found,
                        const std::vector<double> &exact)
  {
    double differences = 0, squares = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
      {
        differences += (found[i] - exact[i]) * (found[i] - exact[i]);
        squares += exact[i] * exact[i];
      }
    return std::sqrt(differences / squares);
  }
} // namespace

TEST(WaveWatch, ReportsElementsWithAnInaccurateTipMotion)
{
  for (const double frequency : {15., 31., 60., 100.})
    {
      const ShakenTip fine = shaken_tip(shaken(4, frequency).mesh(4, 2));
      EXPECT_TRUE(fine.findings.empty()) << verdict_text(fine.findings);
      for (const unsigned int order : {1, 2, 3, 4})
        {
          const ShakenTip found      = shaken_tip(shaken(order, frequency));
          const double    difference = tip_difference(found.tip, fine.tip);
          const Verdict   verdict    = verdict_of(found.findings);
          EXPECT_EQ(verdict != Verdict::sound, difference > 0.09)
            << "order " << order << ", " << frequency
            << " rad/s: " << difference << '\n'
            << verdict_text(found.findings);
          if (verdict == Verdict::not_to_be_used)
            {
              EXPECT_GT(difference, 0.2)
                << "order " << order << ", " << frequency << " rad/s";
            }
        }
    }
}

TEST(WaveWatchOnRanks, FindsTheSameOnAllRanks)
{
  const std::string scene = shaken(2, 100);
  const auto        alone = findings_of(scene),
             together     = findings_of(scene, {}, MPI_COMM_WORLD);
  ASSERT_EQ(alone.size(), 1u) << verdict_text(alone);
  ASSERT_EQ(together.size(), 1u);
  EXPECT_EQ(alone[0].verdict, Verdict::not_to_be_used);
  EXPECT_EQ(together[0].text, alone[0].text);
  EXPECT_EQ(together[0].time, alone[0].time);
}

TEST(WaveWatch, IgnoresARodHeldByFriction)
{
  // The rod carries 20 N across and 4 N along, below the friction limit of 10
  // N. It hardly moves; its end creeps by v0 0.4 / sqrt(1 - 0.4^2).
  for (const double step : {2e-4, 1e-4, 5e-5})
    {
      const SceneText scene =
        SceneText()
          .frame("0 0; 0.2 0", "0 1")
          .rectangle("rod", 0.01, 0.01, {2e9, 1000})
          .add("Loads/press",
               "Joints = 0, 1 | Force y = -10 * (1 - exp(-(t / 0.02)^2))")
          .add("Loads/push",
               "Joints = 0 | Force x = 4 * (1 - exp(-(t / 0.05)^2))")
          .add("Plates/table",
               "Shape = plane | Normal = 0 1 | Position = 0 -0.005")
          .add("Contact", "Friction coefficient = 0.5")
          .mesh(3)
          .probe("tip", "1")
          .time(0.1, step, "energy-momentum");
      const Scene    read = read_scene_from_text(scene, "test.prm");
      MemoryRecorder recorder(read, MPI_COMM_SELF);
      const auto     findings = run(read, MPI_COMM_SELF, recorder).findings;
      EXPECT_EQ(verdict_of(findings), Verdict::sound) << verdict_text(findings);
      const double part = 0.4 * (1 - std::exp(-4.));
      EXPECT_NEAR(recorder.column("tip.vx").back(),
                  1e-3 * part / std::sqrt(1 - part * part),
                  3e-5);
    }
}
