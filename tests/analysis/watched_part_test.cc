#include <auxfem/analysis/lattice_run.h>
#include <auxfem/analysis/watched_part.h>

#include <analysis/findings_of.h>
#include <analysis/resumed_run.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <regex>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** So many cells that parts of them are watched if displacements are small,
   * which these are; with steps and elements for slower motions. */
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

  /** Without that of bending, which does not look at parts. */
  std::vector<Finding> of_parts(std::vector<Finding> findings)
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

  /** In the order of the findings, per cent. */
  std::vector<double> parts_told(const std::vector<Finding> &findings)
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

  /** Which parts take their turns in some steps. */
  std::vector<unsigned int> turns(WatchedPart &part, const unsigned int n_steps)
  {
    std::vector<unsigned int> turns;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        const unsigned int before = part.now();
        const bool         passed = part.passes_on(/*dt=*/2e-5);
        EXPECT_EQ(passed, part.now() != before);
        turns.push_back(part.now());
      }
    return turns;
  }
} // namespace

TEST(WatchedPart, TakesTurnsInLargeLinearScenesOnly)
{
  const auto n_parts = [](const SceneText &text) {
    const Scene      scene = read_scene_from_text(text, "test.prm");
    const LatticeRun run(scene, MPI_COMM_SELF);
    return WatchedPart(scene, run.equations, 2).n_parts();
  };
  const SceneText few = shaken_stars("top", vibration).cells("star", 10, 10);
  EXPECT_EQ(n_parts(shaken_stars("top", vibration)), 16u);
  EXPECT_EQ(n_parts(shaken_stars("top", vibration, "on")), 1u);
  EXPECT_EQ(n_parts(few), 5u);
  // Each part four times in the run.
  EXPECT_EQ(n_parts(SceneText(few).time("640 us", "20 us", "newmark")), 4u);
  EXPECT_EQ(n_parts(SceneText(few).time("140 us", "20 us", "newmark")), 1u);

  const Scene      scene = read_scene_from_text(few, "test.prm");
  const LatticeRun run(scene, MPI_COMM_SELF);
  WatchedPart part(scene, run.equations, 2), resumed(scene, run.equations, 2);
  EXPECT_EQ(turns(part, 12),
            (std::vector<unsigned int>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 0, 0}));
  EXPECT_EQ(turns(part, 1), std::vector<unsigned int>{1});
  Records records;
  part.save("test", records);
  EXPECT_TRUE(resumed.resume("test", records));
  EXPECT_EQ(turns(resumed, 2), (std::vector<unsigned int>{1, 2}));
  WatchedPart for_some_time(scene, run.equations, 2, 9e-5);
  EXPECT_EQ(turns(for_some_time, 7),
            (std::vector<unsigned int>{0, 0, 0, 0, 0, 1, 1}));
  // Of a run that ends sooner, or later.
  Scene shorter = scene;
  shorter.time.end_time /= 20;
  WatchedPart with_fewer(shorter, run.equations, 2);
  EXPECT_FALSE(with_fewer.resume("test", records));
  EXPECT_EQ(turns(with_fewer, 1), std::vector<unsigned int>{0});
}

TEST(WatchedPart, TellsOfAllUnknowns)
{
  for (const std::string &force : {vibration, blow})
    {
      SCOPED_TRACE(force);
      const auto in_parts = of_parts(findings_of(shaken_stars("top", force))),
                 in_all =
                   of_parts(findings_of(shaken_stars("top", force, "on")));
      const std::vector<double> found    = parts_told(in_parts),
                                expected = parts_told(in_all);
      EXPECT_EQ(expected.size(), force == vibration ? 3u : 1u)
        << verdict_text(in_all);
      ASSERT_EQ(found.size(), expected.size()) << verdict_text(in_parts);
      for (std::size_t i = 0; i < expected.size(); ++i)
        {
          EXPECT_NEAR(found[i], expected[i], 0.15 * expected[i]);
          EXPECT_EQ(in_parts[i].verdict, in_all[i].verdict);
        }
    }
}

TEST(WatchedPart, SeesWhatHappensToOneJoint)
{
  const auto of_joint = [](const std::string &large_rotation) {
    return of_parts(findings_of(shaken_stars("2000", blow, large_rotation)));
  };
  const auto found = of_joint("off"), expected = of_joint("on");
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_NEAR(parts_told(found)[0],
              parts_told(expected)[0],
              parts_told(expected)[0] / 4);
}

TEST(WatchedPart, TurnsGoOnInRunsThatAreResumed)
{
  EXPECT_EQ(of_parts(expect_same_when_resumed(shaken_stars("top", vibration))
                       .result.findings)
              .size(),
            3u);
}

TEST(WatchedPartOnRanks, FindsAboutTheSame)
{
  const std::string scene = shaken_stars("top", vibration);
  const auto        alone = parts_told(findings_of(scene)),
             together     = parts_told(findings_of(scene, {}, MPI_COMM_WORLD));
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(together[i], alone[i], 0.15 * alone[i]);
}
