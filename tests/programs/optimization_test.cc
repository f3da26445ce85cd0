#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  class OptimizationProgram : public ProgramTest
  {
  protected:
    OptimizationProgram()
    {
      write("scene.prm", prm_text("design-cell.prm"));
    }

    ProgramRun run(const Words &overrides) const
    {
      Words arguments = {"scene.prm", "--output", "out"};
      for (const std::string &assignment : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(assignment);
        }
      return run_auxfem(arguments);
    }

    Table table() const
    {
      return Table(path("out/optimization.csv"));
    }
  };

  TEST_F(OptimizationProgram, LeavesATableAndTheBestScene)
  {
    const ProgramRun found = run({});
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    expect_contains(
      found.output,
      {"Optimization of 2 design variables, Analysis = simulation",
       "Spring stiffness from 5 kN/m to 40 kN/m",
       "minimize peak",
       "with travel >= -100 mm",
       "by COBYLA",
       "first  Spring stiffness = 20 kN/m, Damping coefficient = "
       "50 N s/m: peak = 2378",
       "with half the step",
       "% of the result per % of the variable",
       "Connectors/connector/Damping coefficient  0.0414",
       "Verdict: sound",
       "out/best.prm"});
    const Table designs = table();
    EXPECT_EQ(designs["evaluation"].front(), 1);
    EXPECT_EQ(designs["Spring stiffness"].front(), 20);
    const std::vector<double> best = designs["best_so_far"];
    // The scene itself is beyond the constraint.
    EXPECT_TRUE(std::isnan(best.front()));
    EXPECT_GT(designs["excess"].front(), 0.02);
    EXPECT_NEAR(best.back(), 2319.7, 0.1);
    expect_contains(read_text(path("out/optimization.units.csv")),
                    {"Damping coefficient,N s/m,Connectors/connector/Damping "
                     "coefficient",
                     "peak,,minimize peak"});
    expect_contains(summary("verdict"), {"sound"});
    EXPECT_GT(std::stod(summary("gain")), 50);

    const ProgramRun again = run_auxfem({"out/best.prm"});
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_NEAR(history("out/best").largest("f2"), best.back(), 0.01);
  }

  // As if the first one had been killed: only designs that are missing run.
  TEST_F(OptimizationProgram, ContinuesFromDesignsThatAreThere)
  {
    ASSERT_EQ(run({"Optimization/Sensitivities=false"}).exit_code, 0);
    const std::string before = read_text(path("out/optimization.csv"));
    const std::size_t n      = table()["evaluation"].size() - 1;
    for (std::size_t i = 6; i <= n; ++i)
      fs::remove_all(path("out/designs/0001/00") + (i < 10 ? "0" : "") +
                     std::to_string(i));
    const ProgramRun again = run({"Optimization/Sensitivities=false"});
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    const auto line = [&again](const std::string &design) {
      const std::size_t begin = again.output.find("  " + design);
      return again.output.substr(begin, again.output.find('\n', begin) - begin);
    };
    const std::string reused = "from an earlier optimization";
    for (const char *const design : {"first", "0001/0001", "0001/0005"})
      expect_contains(line(design), {reused});
    expect_without(line("0001/0006"), {reused});
    EXPECT_EQ(read_text(path("out/optimization.csv")), before);
  }

  TEST_F(OptimizationProgram, SearchesSideBySideFindTheSameOnTwoRanks)
  {
    const Words overrides = {"--set",
                             "Optimization/Constraints=none",
                             "--set",
                             "Optimization/Starts=3",
                             "--set",
                             "Optimization/Evaluations=12"};
    Words       arguments = {"scene.prm", "--output", "one"};
    arguments.insert(arguments.end(), overrides.begin(), overrides.end());
    EXPECT_EQ(run_auxfem(arguments).exit_code, 0);
    arguments[2]           = "two";
    const ProgramRun other = run_auxfem_on(2, arguments);
    EXPECT_EQ(other.exit_code, 0) << other.errors;
    EXPECT_EQ(read_text(path("one/optimization.csv")),
              read_text(path("two/optimization.csv")));
    expect_contains(other.output, {"Verdict: doubtful", "Evaluations"});
  }

  TEST_F(OptimizationProgram, EndsAfterItsEvaluationsWithEveryMethod)
  {
    for (const char *const method :
         {"COBYLA", "BOBYQA", "Subplex", "DIRECT-L", "CRS", "MMA", "SLSQP"})
      {
        const ProgramRun found =
          run({"Optimization/Evaluations=6",
               "Optimization/Sensitivities=false",
               std::string("Optimization/Method=") + method});
        EXPECT_NE(found.exit_code, 1) << method << found.errors;
        EXPECT_NE(found.exit_code, 2) << method << found.errors;
        // Methods by derivatives run two more for each variable.
        const std::string name      = method;
        const double      per_point = name == "MMA" || name == "SLSQP" ? 5 : 1;
        EXPECT_LE(table()["evaluation"].size(), 1 + 6 * per_point) << method;
      }
  }

  // The stiffer the connector, the shorter the way and the larger the force.
  TEST_F(OptimizationProgram, TwoObjectivesHaveAFront)
  {
    const ProgramRun found =
      run({"Optimization/Objective=minimize peak; maximize travel",
           "Optimization/Constraints=none",
           "Optimization/Front points=5",
           "Optimization/Evaluations=40"});
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    expect_contains(found.output, {"front of both objectives", "front.csv"});
    const Table               front(path("out/front.csv"));
    const std::vector<double> peak = front["peak"], travel = front["travel"];
    ASSERT_GE(peak.size(), 5u);
    for (std::size_t i = 1; i < peak.size(); ++i)
      {
        EXPECT_GT(peak[i], peak[i - 1]);
        EXPECT_GT(travel[i], travel[i - 1]);
      }
    // Its first end is the softest connector.
    EXPECT_NEAR(peak.front(), 1963.31, 0.5);
    EXPECT_GT(travel.back(), -0.06);
  }

  TEST_F(OptimizationProgram, MistakesAreNamedBeforeAnyRun)
  {
    const auto refusal = [this](const std::string &assignment) {
      const ProgramRun refused = run({assignment});
      EXPECT_EQ(refused.exit_code, 1) << assignment;
      EXPECT_FALSE(fs::exists(path("out"))) << assignment;
      return refused.errors;
    };
    expect_contains(refusal("Design variables/Connectors/connector/Spring "
                            "stiffness=40:5 kN/m"),
                    {"lower bound", "40:5 kN/m"});
    expect_contains(refusal("Design variables/Connectors/connector/Spring "
                            "stiffness=30:40 kN/m"),
                    {"20 kN/m", "not within", "30 kN/m"});
    expect_contains(refusal("Design variables/Connectors/spring/Mass=1:2"),
                    {"no such parameter"});
    expect_contains(refusal("Design variables/Connectors/connector/Spring "
                            "stiffness=-5:40 kN/m"),
                    {"within the bounds makes no valid scene, -5 kN/m", "> 0"});
    write("scene.prm", prm_text("design-star.prm"));
    expect_contains(refusal("Design variables/Lattice/Cells x=1:4"),
                    {"makes no valid scene, 2.854", "not a whole number"});
    write("scene.prm", prm_text("design-cell.prm"));
    expect_contains(refusal("Optimization/Method=simplex"),
                    {"\"simplex\" is no method", "Subplex"});
    expect_contains(refusal("Optimization/Objective=minimise peak"),
                    {"minimise peak", "minimize EXPRESSION"});
  }

  TEST_F(OptimizationProgram, AnObjectiveThatTheRunDoesNotHaveIsNamed)
  {
    const ProgramRun refused =
      run({"Optimization/Objective=minimize reaction"});
    EXPECT_EQ(refused.exit_code, 1);
    expect_contains(refused.errors,
                    {"Optimization/Objective = reaction",
                     "largest_f2_newton",
                     "peak"});
  }

  TEST_F(OptimizationProgram, AMistakeThatTheFirstRunFindsIsAMistake)
  {
    const ProgramRun refused = run({"Quantities/peak=maximum of f3"});
    EXPECT_EQ(refused.exit_code, 1);
    expect_contains(refused.errors,
                    {"from which the search begins, fails",
                     "Quantities/peak: there is no column \"f3\"",
                     "or \"f2\"?"});
  }

  TEST_F(OptimizationProgram, ASignalLeavesTheDesignsSoFar)
  {
    const ProgramRun ended = run_program(
      {"sh",
       "-c",
       "'" AUXFEM_EXECUTABLE "' scene.prm --output out --set "
       "Optimization/Method=CRS --set Optimization/Evaluations=100000 & "
       "run=$!; until [ -e out/designs/0001/0004/summary.json ]; do sleep "
       "0.02; done; kill -TERM $run; wait $run"});
    EXPECT_EQ(ended.exit_code, 128 + 15) << ended.errors;
    expect_contains(ended.output,
                    {"Interrupted", "out/optimization.csv", "best.prm"});
    EXPECT_GE(table()["evaluation"].size(), 4u);
    EXPECT_EQ(run_auxfem({"--check", "out/best.prm"}).exit_code, 0);
  }

  TEST_F(OptimizationProgram, AGlobalMethodAloneIsDoubtful)
  {
    const ProgramRun found = run({"Optimization/Method=CRS",
                                  "Optimization/Evaluations=20",
                                  "Optimization/Sensitivities=false"});
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    expect_contains(found.output,
                    {"Verdict: doubtful", "Method = CRS ends after"});
  }

  TEST_F(OptimizationProgram, ARunThatFailsFromTheStartEndsWithItsReason)
  {
    const ProgramRun failed = run({"Reduced cell/Load=sqrt(0.02 - t)"});
    EXPECT_EQ(failed.exit_code, 2);
    expect_contains(failed.errors,
                    {"from which the search begins, fails",
                     "not a finite number",
                     "Give values"});
  }

  TEST_F(OptimizationProgram, NoDesignWithinConstraintsIsNotToBeUsed)
  {
    const ProgramRun found = run({"Optimization/Constraints=travel >= -1 mm",
                                  "Optimization/Evaluations=15",
                                  "Optimization/Sensitivities=false"});
    EXPECT_EQ(found.exit_code, 3);
    expect_contains(found.output,
                    {"No design meets all constraints", "not to be used"});
  }

  // After the limit the load has no value.
  TEST_F(OptimizationProgram, FailedDesignsMakeTheVerdictDoubtful)
  {
    const ProgramRun found =
      run({"Constants=limit = 0.1",
           "Reduced cell/Load=1e6 * t^2 * sqrt(limit - t)",
           "Design variables/Constants/limit=0.01:0.2",
           "Optimization/Constraints=none",
           "Optimization/Method=DIRECT-L",
           "Optimization/Evaluations=15",
           "Optimization/Sensitivities=false"});
    EXPECT_EQ(found.exit_code, 0);
    expect_contains(found.output,
                    {"designs have no usable results",
                     "not a finite number",
                     "doubtful"});
  }

  TEST_F(OptimizationProgram, ACheckPrintsTheProblem)
  {
    const ProgramRun checked =
      run_auxfem({"--check", "scene.prm", "--output", "out"});
    EXPECT_EQ(checked.exit_code, 0) << checked.errors;
    expect_contains(checked.output,
                    {"Optimization of 2 design variables", "minimize peak"});
    EXPECT_FALSE(fs::exists(path("out/designs")));
  }
} // namespace
