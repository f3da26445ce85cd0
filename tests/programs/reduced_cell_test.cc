#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;

  /** `Model = reduced cell` and --compare as a user sees them. */
  class ReducedCellProgram : public ProgramTest
  {
  protected:
    static std::string cell_file(const unsigned int number)
    {
      return std::string(AUXFEM_PRM_DIRECTORY) + "/cell-case-" +
        std::to_string(number) + ".prm";
    }

    static Words arguments_for(const unsigned int number,
                               const Words       &overrides)
    {
      Words arguments = {cell_file(number), "--output", "out"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      return arguments;
    }

    ProgramRun run_cell(const unsigned int number,
                        const Words       &overrides = {}) const
    {
      return run_auxfem(arguments_for(number, overrides));
    }

    void expect_refusal_with(const Words &overrides, const Words &parts) const
    {
      const ProgramRun run = run_cell(1, overrides);
      EXPECT_EQ(run.exit_code, 1) << run.errors;
      expect_contains(run.errors, parts);
      expect_without(run.errors, {"internal error", "Stacktrace"});
      EXPECT_FALSE(std::filesystem::exists(path("out")));
    }

    /** A failed run: exit code 2, and rows up to @p time. */
    void expect_failure_at(const ProgramRun &run,
                           const double      time,
                           const Words      &parts) const
    {
      EXPECT_EQ(run.exit_code, 2) << run.errors;
      expect_contains(run.errors, parts);
      expect_without(run.errors, {"internal error", "Stacktrace"});
      const Table table = history();
      EXPECT_NEAR(table["time"].back(), time, 1e-12);
      for (const std::string &name : table.names)
        for (const double value : table[name])
          EXPECT_TRUE(std::isfinite(value)) << name;
      expect_contains(summary("exit_state"), parts);
      expect_contains(read_text(path("out/log.txt")), parts);
    }
  };

  TEST_F(ReducedCellProgram, LeavesTheFolderOfARun)
  {
    const ProgramRun run = run_cell(1);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    expect_contains(run.output,
                    {"Reduced cell", "newmark", "Simulated", "Completed"});

    const Table table = history();
    EXPECT_EQ(table.names,
              (Words{"time",
                     "theta",
                     "Y1",
                     "Y2",
                     "f1",
                     "f2",
                     "kinetic",
                     "stored",
                     "dissipated",
                     "external",
                     "balance"}));
    ASSERT_EQ(table.n_rows, 1001u);
    EXPECT_EQ(table["time"].back(), 0.05);
    EXPECT_NEAR(table["f1"].back(), 2500, 1e-9);
    // The error of the scheme at this step is 1e-7 of the value.
    EXPECT_NEAR(table["f2"].back(), 2378.002513, 1e-3);
    EXPECT_NEAR(table["theta"].back() * 180 / M_PI, 22.608322, 1e-5);

    expect_contains(read_text(path("out/history.units.csv")),
                    {"theta,rad,", "Y1,m,", "f2,N,", "balance,J,"});
    EXPECT_EQ(read_text(path("out/original.prm")), read_text(cell_file(1)));
    expect_contains(read_text(path("out/parameters.prm")),
                    {"Model", "Bar length", "Spring stiffness"});
    EXPECT_EQ(summary("exit_state"), "completed");
    EXPECT_EQ(summary("model"), "reduced cell");
    EXPECT_EQ(summary("scheme"), "newmark");
    EXPECT_NEAR(std::stod(summary("f2_newton")), 2378.002513, 1e-3);
    EXPECT_EQ(summary("steps"), "1000");
    EXPECT_FALSE(std::filesystem::exists(path("out/solution.pvd")));
  }



  TEST_F(ReducedCellProgram, ItsParametersRunAgain)
  {
    ASSERT_EQ(run_cell(6).exit_code, 0);
    const ProgramRun again =
      run_auxfem({"out/parameters.prm", "--output", "again"});
    ASSERT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_text(path("again/history.csv")),
              read_text(path("out/history.csv")));
  }



  TEST_F(ReducedCellProgram, RowsAtTheHistoryInterval)
  {
    ASSERT_EQ(run_cell(1, {"Output/History interval=300"}).exit_code, 0);
    const Table table = history();
    ASSERT_EQ(table.n_rows, 5u); // and the last state
    EXPECT_NEAR(table["time"][3], 0.045, 1e-15);
    EXPECT_EQ(table["time"][4], 0.05);
  }



  TEST_F(ReducedCellProgram, SeveralRanksGiveTheSameOnce)
  {
    ASSERT_EQ(run_cell(8).exit_code, 0);
    const ProgramRun run = run_auxfem_on(2, {cell_file(8), "--output", "two"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.output.find("Simulated"), run.output.rfind("Simulated"));
    EXPECT_EQ(read_text(path("two/history.csv")),
              read_text(path("out/history.csv")));
  }



  TEST_F(ReducedCellProgram, BadInput)
  {
    expect_refusal_with({"Connectors/connector/Spring stiffness=0"},
                        {"Spring stiffness = 0", "> 0"});
    expect_refusal_with({"Connectors/connector/Damping coefficient=-50"},
                        {"Damping coefficient = -50", ">= 0", "create energy"});
    expect_refusal_with({"Reduced cell/Angle=0"}, {"Angle = 0", "< 90"});
    expect_refusal_with({"Reduced cell/Angle=90 deg"},
                        {"Angle = 90 deg", "< 90"});
    expect_refusal_with({"Reduced cell/Bar mass=0"},
                        {"cell-case-1.prm:", "nothing resists acceleration"});
    expect_refusal_with({"Lattice/Cell=star"},
                        {"Lattice", "no meaning with Model = reduced cell"});
    expect_refusal_with({"Time/Scheme=static"}, {"mechanism"});
    expect_refusal_with({"Time/Scheme=as printed", "Time/Time step=0.3 ms"},
                        {"equal steps"});
  }



  TEST_F(ReducedCellProgram, MasslessBarsThatComeUprightEndTheRun)
  {
    const ProgramRun run     = run_cell(8,
                                    {"Reduced cell/Bar mass=0",
                                         "Reduced cell/Part mass=0.3 kg",
                                         "Time/End time=0.2 s"});
    const double     reached = std::stod(summary("time_reached"));
    EXPECT_GT(reached, 0.05);
    EXPECT_LT(reached, 0.2);
    expect_failure_at(run, reached, {"upright"});
    EXPECT_GT(history()["theta"].back(), -M_PI / 2);
  }



  TEST_F(ReducedCellProgram, ThePrintedSchemeEndsWithItsNumbers)
  {
    const ProgramRun run     = run_cell(1,
                                    {"Time/Scheme=as printed",
                                         "Time/Time step=0.5 ms",
                                         "Time/End time=0.5 s"});
    const double     reached = std::stod(summary("time_reached"));
    EXPECT_LT(reached, 0.5);
    expect_failure_at(run, reached, {"as printed", "not finite"});
  }



  TEST_F(ReducedCellProgram, AnUnstableSchemeEndsWithItsNumbers)
  {
    const ProgramRun run =
      run_cell(1,
               {"Time/Scheme=central difference",
                "Connectors/connector/Spring stiffness=2e10 N/m"});
    const double reached = std::stod(summary("time_reached"));
    EXPECT_LT(reached, 0.05);
    EXPECT_GT(history().n_rows, 2u);
    expect_failure_at(run,
                      reached,
                      {"At t = ",
                       "not a finite number",
                       "too long for the scheme",
                       "Time/Time step"});
  }



  TEST_F(ReducedCellProgram, Check)
  {
    const ProgramRun run = run_auxfem({"--check", cell_file(3)});
    EXPECT_EQ(run.exit_code, 0);
    expect_contains(run.output, {"0.5 kg", "Simulated", "Left out"});
    EXPECT_FALSE(std::filesystem::exists(path("output")));
  }



  TEST_F(ReducedCellProgram, ComparisonOfAllCases)
  {
    Words arguments = {"--compare"};
    for (unsigned int number = 1; number <= 8; ++number)
      arguments.push_back(cell_file(number));
    const ProgramRun run = run_auxfem(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
    const std::string table =
      read_text(path("output/comparison/comparison.csv"));
    // A heading, and six schemes for each case.
    EXPECT_EQ(count_lines(table), 1u + 8 * 6);
    for (unsigned int number = 1; number <= 8; ++number)
      {
        const std::string name = "cell-case-" + std::to_string(number);
        for (const std::string scheme : {"arkode",
                                         "newmark",
                                         "hht",
                                         "generalized-alpha",
                                         "central difference",
                                         "as printed"})
          expect_contains(table, {name + "," + scheme + ","});
        expect_contains(run.output, {name});
      }
    expect_contains(read_text(path("output/comparison/comparison.units.csv")),
                    {"theta_end,deg", "f2_difference,1"});
  }



  TEST_F(ReducedCellProgram, ComparisonGoesOnAfterAFailure)
  {
    const ProgramRun run = run_auxfem({"--compare",
                                       cell_file(1),
                                       "--output",
                                       "table",
                                       "--set",
                                       "Connectors/connector/Law=spring",
                                       "--set",
                                       "Time/Time step=0.3 ms"});
    // the dashpot's coefficient is none of a spring's
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors, {"Damping coefficient"});

    const ProgramRun uneven = run_auxfem({"--compare",
                                          cell_file(1),
                                          cell_file(5),
                                          "--output",
                                          "table",
                                          "--set",
                                          "Time/Time step=0.3 ms"});
    EXPECT_EQ(uneven.exit_code, 0) << uneven.errors;
    const std::string table = read_text(path("table/comparison.csv"));
    expect_contains(table,
                    {"needs equal steps", "cell-case-5,newmark", "completed"});
    expect_contains(uneven.output, {"needs equal steps"});
  }



  TEST_F(ReducedCellProgram, ComparisonIsForReducedCellsOnly)
  {
    const std::string scene =
      std::string(AUXFEM_PRM_DIRECTORY) + "/cantilever.prm";
    const ProgramRun run = run_auxfem({"--compare", cell_file(1), scene});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors, {"cantilever.prm", "Model = reduced cell"});
    EXPECT_EQ(run_auxfem({"--compare"}).exit_code, 1);
  }

  TEST_F(ReducedCellProgram, TellsItsQuantities)
  {
    expect_refusal_with({"Quantities/peak=maximum of f3"},
                        {"Quantities/peak", "\"f3\"", "Columns of this scene"});
    const ProgramRun run = run_cell(1,
                                    {"Quantities/peak=maximum of f2",
                                     "Quantities/impulse=integral of f2",
                                     "Quantities/late=f2 at 0.01 s"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"Quantity peak: ", "Quantity late: "});
    EXPECT_NE(run.output.find(" N s\n", run.output.find("Quantity impulse: ")),
              std::string::npos);
    const Table table = history();
    EXPECT_DOUBLE_EQ(std::stod(summary("peak")),
                     *std::max_element(table["f2"].begin(), table["f2"].end()));
  }
} // namespace
