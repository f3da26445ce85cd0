#include <gtest/gtest.h>
#include <support/followed_path.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Increments that are shortened: how many steps that saves, and that those who
// need none do not pay for it.

namespace
{
  /** As in lee_frame_test.cc. */
  SceneText lees_frame()
  {
    SceneText scene =
      static_frame("0 0; 0 120; 24 120; 120 120", "0 1; 1 2; 2 3");
    return scene.section({4.32e7, 4.32e10, 1.44e7})
      .support("hinges", "0, 3", "pin")
      .mesh(4, 3);
  }
} // namespace

TEST(LineSearch, LeesFrameHasFewerRejectedSteps)
{
  SceneRun run(lees_frame()
                 .prescribe("load", "2", {"free", "-t", "free"})
                 .time(45, 2.5)
                 .str());
  run.run([] {});
  // Whole increments take 366 iterations with 18 rejected steps.
  EXPECT_LE(run.work().retries, 9u);
  EXPECT_LE(run.work().iterations, 320u);
  EXPECT_GT(run.work().shortened, 0u);
}

TEST(LineSearch, PathsOfLeesFrameHaveFewerRejectedSteps)
{
  const FollowedPath path(lees_frame()
                            .load("weight", "2", {"0", "-40000 * t", "0"})
                            .set("Loads/weight/Direction", "follows the joint")
                            .time(1, 1)
                            .str());
  EXPECT_EQ(path.limits().size(), 2u);
  // 8 with whole increments.
  EXPECT_LE(path.result.work.retries, 5u);
}

TEST(LineSearch, EasyStepsHaveNotOneResidualMore)
{
  // Roll-up of a cantilever to a circle, in steps.
  SceneRun rolled(static_frame("0 0; 1 0", "0 1")
                    .section({1e4, 1e4, 1})
                    .support("wall", "0", "clamp")
                    .load("end", "1", {"0", "0", "6.283185307179586 * t"})
                    .mesh(3, 2)
                    .time(1, 0.05)
                    .str());
  rolled.run([] {});
  EXPECT_EQ(rolled.work().shortened, 0u);

  // The paths of Williams' toggle and of a column that leans.
  const FollowedPath toggle(
    static_frame("-12.943 0; 0 0.386; 12.943 0", "0 1; 1 2")
      .section({1.88e6, 1.88e9, 9300})
      .support("feet", "0, 2", "clamp")
      .load("weight", "1", {"0", "-80 * t", "0"})
      .mesh(4, 3)
      .time(1, 1)
      .str());
  EXPECT_EQ(toggle.limits().size(), 2u);
  EXPECT_EQ(toggle.result.work.shortened, 0u);
  const FollowedPath column(static_frame("0 0; 0 1", "0 1")
                              .section({1e6, 1e6, 1})
                              .support("clamp", "0", "clamp")
                              .load("weight", "1", {"0", "-5 * t", "0"})
                              .mesh(4, 3)
                              .time(1, 1)
                              .str(),
                            {"Path/Branch=stable"});
  EXPECT_EQ(column.bifurcations().size(), 1u);
  EXPECT_EQ(column.result.work.shortened, 0u);
}
