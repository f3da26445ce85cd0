#include <support/run_program.h>
#include <verification/one_mass_scene.h>

namespace
{
  using namespace auxfem::testing_support;

  /** 1 kg on 4 N/m, thrown with 1 m/s: omega = 2/s. */
  class VerdictProgram : public ProgramTest
  {
  protected:
    ProgramRun run_with_step(const std::string &step,
                             const Words       &more = {
                                     "Output/Graphics=false"}) const
    {
      write("scene.prm",
            one_mass_scene("Law = spring | Spring stiffness = 4",
                           "End time = 20 | Time step = " + step,
                           mass_and_velocity(1, 1)));
      Words arguments = {"scene.prm", "--output", "out"};
      for (const std::string &text : more)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      return run_auxfem(arguments);
    }
  };

  TEST_F(VerdictProgram, IsTheLastWordOfARun)
  {
    const ProgramRun sound = run_with_step("50 ms");
    EXPECT_EQ(sound.exit_code, 0) << sound.errors;
    EXPECT_EQ(sound.output.substr(sound.output.rfind("Verdict")),
              "Verdict: sound\n");
    EXPECT_EQ(summary("verdict"), "sound");
    expect_contains(read_text(path("out/summary.json")), {"\"warnings\": []"});
  }

  TEST_F(VerdictProgram, WatchesLeaveTheLinearSolverOfTheRun)
  {
    const ProgramRun run = start_auxfem({AUXFEM_PRM_DIRECTORY "/lattice.prm",
                                         "--output",
                                         "out",
                                         "--set",
                                         "Output/Graphics=false"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    // Turning dashpots make the matrix unsymmetric; the watch checks a lattice
    // at rest, whose matrix is symmetric.
    expect_contains(summary("linear_solver"), {"unsymmetric"});
  }

  TEST_F(VerdictProgram, DoubtfulResultsAreNoFailure)
  {
    const ProgramRun doubtful = run_with_step("0.5");
    EXPECT_EQ(doubtful.exit_code, 0) << doubtful.errors;
    expect_contains(doubtful.output,
                    {"Verdict: doubtful",
                     "The steps are long for the motion",
                     "Time/Time step = 0.5 s"});
    EXPECT_EQ(summary("verdict"), "doubtful");
  }

  TEST_F(VerdictProgram, ResultsThatAreNotToBeUsedEndWithThree)
  {
    const ProgramRun ruined = run_with_step("2");
    EXPECT_EQ(ruined.exit_code, 3);
    EXPECT_EQ(ruined.errors, "");
    expect_contains(ruined.output, {"Verdict: not to be used"});
    EXPECT_EQ(summary("verdict"), "not to be used");
    EXPECT_EQ(summary("exit_state"), "completed");

    const ProgramRun asked_for =
      run_with_step("2", {"Output/Exit code by verdict=false"});
    EXPECT_EQ(asked_for.exit_code, 0) << asked_for.errors;
    EXPECT_EQ(summary("verdict"), "not to be used");
  }
} // namespace
