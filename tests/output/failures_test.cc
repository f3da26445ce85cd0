#include <auxfem/output/failures.h>

#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

TEST(Failures, CountsBrokenConnectorsOfEachGroup)
{
  // A rod and a link share the pull; the other link joins held joints.
  SceneRun run(SceneText()
                 .frame("0 0; 1 0; 2 0; 1 1", "0 1; 0 3")
                 .section({1e6, 1e6, 1e6})
                 .support("held", "0, 2, 3", "clamp")
                 .connector("weak",
                            "spring",
                            "Between = 1 2 | Spring stiffness = 1e6 | "
                            "Failure force = 2")
                 .connector("idle",
                            "spring",
                            "Between = 2 3 | Spring stiffness = 100 | "
                            "Failure force = 2")
                 .load("pull", "1", {"-10 * t", "0", "0"})
                 .time(1, 0.25, "static"));
  EXPECT_TRUE(
    broken_connectors(run.equations, run.computation.solution).empty());
  run.run();
  const auto broken =
    broken_connectors(run.equations, run.computation.solution);
  ASSERT_EQ(broken.size(), 1u);
  EXPECT_EQ(broken[0].group, "weak");
  EXPECT_EQ(broken[0].number, 1u);

  EXPECT_EQ(failures_text({}, {}), "");
  EXPECT_EQ(failures_text({{7, 0.25}}, broken),
            "Broken struts: 1, first strut 7 at t = 0.25 s; all in "
            "failures.csv\n"
            "Broken connectors: 1 of weak; when, in the column weak.broken\n");
}
