#include <auxfem/algebra/vector.h>

#include <programs/resumed_run.h>

namespace
{
  using namespace auxfem::testing_support;

  class ResumedRunOnRanks : public ResumedRun
  {};

  class ResumedPathOnRanks : public ResumedPath
  {};

  TEST_F(ResumedRunOnRanks, KilledAgainAndAgainIsTheWholeOne)
  {
    ASSERT_EQ(run_auxfem_on(2, {"scene.prm", "--output", "whole"}).exit_code,
              0);
    kill_and_go_on(2);
    expect_that_of_the_whole_run();
  }

  TEST_F(ResumedRunOnRanks, MayHaveAnotherNumberOfRanks)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    Words half = begin();
    half.insert(half.end(), {"--set", "Time/End time=" + early});
    ASSERT_EQ(run_auxfem_on(2, half).exit_code, 0);
    const ProgramRun run = run_auxfem(go_on({"--set", "Time/End time=" + end}));
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_about_that_of_the_whole_run();
  }

  TEST_F(ResumedPathOnRanks, KilledAgainAndAgainIsTheWholeOne)
  {
    run_whole(2);
    kill_and_go_on(2);
    expect_that_of_the_whole_path();
  }
} // namespace
