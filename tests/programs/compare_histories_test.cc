#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;

  /** scripts/compare-histories, of the program with itself. */
  class CompareHistories : public ProgramTest
  {
  protected:
    ProgramRun compare(const Words &arguments) const
    {
      Words words = {AUXFEM_PYTHON,
                     AUXFEM_PRM_DIRECTORY "/../scripts/compare-histories",
                     AUXFEM_EXECUTABLE,
                     AUXFEM_EXECUTABLE};
      words.insert(words.end(), arguments.begin(), arguments.end());
      return run_program(words);
    }

    const std::string cantilever = AUXFEM_PRM_DIRECTORY "/cantilever.prm";
    const std::string cell       = AUXFEM_PRM_DIRECTORY "/cell-case-1.prm";
  };

  TEST_F(CompareHistories, AProgramIsEqualToItself)
  {
    const ProgramRun run = compare({"--repeat", "2", cantilever, cell});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output,
                    {"largest difference 0.0e+00",
                     "iterations",
                     "ratio new / old",
                     "2 scenes: 2 the same within 1e-10, 0 different, 0 not "
                     "compared"});
    expect_without(run.output, {"only in the"});
  }



  TEST_F(CompareHistories, ServesAllAnalyses)
  {
    const std::string prm = AUXFEM_PRM_DIRECTORY "/";
    ProgramRun        run = compare({prm + "path.prm",
                                     prm + "modes.prm",
                                     prm + "buckling.prm",
                                     prm + "frequency-response.prm"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"4 scenes: 4 the same within 1e-10"});

    run = compare({"--new-set",
                   "Sections/aluminium/Width=0.401 mm",
                   prm + "frequency-response.prm"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.output, {"from frequency = 10 Hz on (top.ux.real)"});
  }



  TEST_F(CompareHistories, AnotherStepIsADifference)
  {
    // Twice the step: the errors become four times as large.
    ProgramRun run = compare({"--new-set", "Time/Time step=0.1 ms", cell});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.output,
                    {", above 1e-10 from t = 0.0003 s on (f2)",
                     "500 of 1001 rows only in the old history",
                     "1 different"});

    run = compare(
      {"--new-set", "Time/Time step=0.1 ms", cell, "--tolerance", "1e-5"});
    EXPECT_EQ(run.exit_code, 0) << run.output;
    expect_contains(run.output, {"1 the same within 1e-05"});
  }



  TEST_F(CompareHistories, ColumnsOfOneOnlyAreListed)
  {
    const ProgramRun run =
      compare({"--new-set", "Probes/root=0", "--all", cantilever});
    EXPECT_EQ(run.exit_code, 0) << run.output;
    expect_contains(run.output,
                    {"only in the new history: root.ux, root.uy, root.phi",
                     "    tip.ux ",
                     "    balance ",
                     "1 the same"});
  }



  TEST_F(CompareHistories, WhatCannotRunIsNotTheSame)
  {
    ProgramRun run = compare({"missing.prm"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.output,
                    {"not compared: the old program ended with exit code 1",
                     "missing.prm",
                     "1 not compared"});

    run = compare({"--new-set",
                   "Time/End time=0.1 ms",
                   "--new-set",
                   "Time/Time step=0.1 ms",
                   cantilever});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.output,
                    {"beyond the start no time is in both histories"});
  }
} // namespace
