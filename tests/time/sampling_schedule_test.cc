#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/time/watch.h>

#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <regex>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * Steps and elements are too coarse for the motion. With small displacements
   * only some steps are sampled.
   */
  SceneText shaken_stars(const std::string &joints,
                         const std::string &force,
                         const std::string &large_rotation = "off")
  {
    return SceneText()
      .cells("star", 20, 20)
      .set("Lattice/Strut length", 0.01)
      .rectangle("s", 4e-4, 4e-4, {70e9, 2700, 0.33})
      .support("foot", "bottom", "clamp")
      .load("shake", joints, {"0", force, "0"})
      .mesh(1)
      .set("Effects/Large rotation", large_rotation)
      .time("4 ms", "20 us", "newmark");
  }

  const std::string vibration = "1e-5 * sin(2 * pi * t / 150e-6)",
                    blow      = "1e-5 * exp(-((t - 200e-6) / 50e-6)^2)";

  /** Removes findings about bending, which samples single steps. */
  std::vector<Finding> without_rates(std::vector<Finding> findings)
  {
    findings.erase(std::remove_if(findings.begin(),
                                  findings.end(),
                                  [](const Finding &finding) {
                                    return finding.text.find(
                                             "Elements of order 1") !=
                                      std::string::npos;
                                  }),
                   findings.end());
    return findings;
  }

  /** Percentages in the order of the findings. */
  std::vector<double> percentages(const std::vector<Finding> &findings)
  {
    std::vector<double> parts;
    for (const Finding &finding : findings)
      {
        std::smatch found;
        if (std::regex_search(finding.text, found, std::regex("([0-9.]+) %")))
          parts.push_back(std::stod(found[1]));
      }
    return parts;
  }
} // namespace

TEST(SamplingSchedule, SamplesLinearMotionsInBursts)
{
  using Steps        = std::vector<unsigned long>;
  const auto sampled = [](const SamplingRate rate,
                          const std::string &large_rotation,
                          const std::string &end,
                          const std::string &scheme = "newmark") {
    const Scene scene =
      read_scene_from_text(shaken_stars("top", vibration, large_rotation)
                             .cells("star", 1, 1)
                             .time(end, "20 us", scheme),
                           "test.prm");
    const LatticeRun       run(scene, MPI_COMM_SELF);
    const SamplingSchedule schedule(run.equations);
    Steps                  steps;
    for (unsigned long i = 0; i < scene.time.n_steps(); ++i)
      if (schedule.is_sampled(rate, i))
        steps.push_back(i);
    return steps;
  };
  const std::string  steps_300 = "6 ms", steps_100 = "2 ms", steps_8 = "160 us";
  const SamplingRate bursts = SamplingRate::bursts,
                     single = SamplingRate::single_steps;
  const Steps in_bursts     = sampled(bursts, "off", steps_300);
  EXPECT_EQ(Steps(in_bursts.begin(), in_bursts.begin() + 7),
            (Steps{0, 1, 2, 13, 14, 15, 26}));
  EXPECT_EQ(Steps(in_bursts.end() - 4, in_bursts.end()),
            (Steps{288, 297, 298, 299}));
  const Steps alone = sampled(single, "on", steps_300);
  EXPECT_EQ(Steps(alone.begin(), alone.begin() + 3), (Steps{0, 13, 26}));
  EXPECT_EQ(alone.back(), 299u);
  EXPECT_EQ(sampled(single, "off", steps_300), alone);
  // At least twenty bursts.
  EXPECT_EQ(sampled(bursts, "off", steps_100).size(), 62u);
  EXPECT_EQ(sampled(bursts, "off", steps_8).size(), 8u);
  // Nonlinear scenes, cheap checks and statics sample every step.
  EXPECT_EQ(sampled(bursts, "on", steps_300).size(), 300u);
  EXPECT_EQ(sampled(SamplingRate::every_step, "off", steps_300).size(), 300u);
  EXPECT_EQ(sampled(single, "off", steps_300, "static").size(), 300u);
}

TEST(SamplingSchedule, SamplesGiveTheFindingsOfAllSteps)
{
  for (const std::string &force : {vibration, blow})
    {
      SCOPED_TRACE(force);
      const auto in_samples =
                   without_rates(findings_of(shaken_stars("top", force))),
                 in_all =
                   without_rates(findings_of(shaken_stars("top", force, "on")));
      const std::vector<double> found    = percentages(in_samples),
                                expected = percentages(in_all);
      EXPECT_EQ(expected.size(), force == vibration ? 3u : 1u)
        << verdict_text(in_all);
      ASSERT_EQ(found.size(), expected.size()) << verdict_text(in_samples);
      for (std::size_t i = 0; i < expected.size(); ++i)
        {
          EXPECT_NEAR(found[i], expected[i], 0.15 * expected[i]);
          EXPECT_EQ(in_samples[i].verdict, in_all[i].verdict);
        }
    }
}

TEST(SamplingSchedule, FindsEventsAtASingleJoint)
{
  const auto joint_findings = [](const std::string &large_rotation) {
    return without_rates(
      findings_of(shaken_stars("2000", blow, large_rotation)));
  };
  const auto found = joint_findings("off"), expected = joint_findings("on");
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_NEAR(percentages(found)[0],
              percentages(expected)[0],
              percentages(expected)[0] / 4);
}

TEST(SamplingScheduleOnRanks, FindsTheSame)
{
  const std::string scene = shaken_stars("top", vibration);
  const auto        alone = percentages(findings_of(scene)),
             together     = percentages(findings_of(scene, {}, MPI_COMM_WORLD));
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(together[i], alone[i], 0.15 * alone[i]);
}
