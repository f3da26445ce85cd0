#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  class SweepProgram : public ProgramTest
  {
  protected:
    SweepProgram()
    {
      write("scene.prm",
            replaced(prm_text("sweep-angle.prm"), "46:89:1", "50:80:10"));
    }

    static void expect_four_angles(const Table &table)
    {
      EXPECT_EQ(table["Opening angle"], (std::vector<double>{50, 60, 70, 80}));
      const std::vector<double> nu = table["nu12"];
      EXPECT_LT(nu[0], -0.9);
      EXPECT_NEAR(nu[1], -0.551, 0.01);
      EXPECT_LT(nu[2], 0);
      EXPECT_GT(nu[3], 0);
    }
  };

  TEST_F(SweepProgram, HasARowForEachCase)
  {
    const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output,
                    {"Sweep over Lattice/Opening angle: 4 cases of Analysis = "
                     "effective properties",
                     "4/4  Opening angle = 80 deg",
                     "Verdict: sound",
                     "out/sweep.csv"});
    expect_four_angles(Table(path("out/sweep.csv")));
    expect_contains(read_text(path("out/sweep.units.csv")),
                    {"Opening angle,deg,Lattice/Opening angle",
                     "nu12,,effective_properties.constants.nu12"});
    for (const char *const file : {"sweep.units.csv",
                                   "log.txt",
                                   "original.prm",
                                   "parameters.prm",
                                   "cases/0004/summary.json",
                                   "cases/0004/stiffness.csv"})
      EXPECT_TRUE(fs::exists(path("out/" + std::string(file)))) << file;
  }

  TEST_F(SweepProgram, ComputesOnlyWhatIsMissing)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "out"}).exit_code, 0);
    fs::remove(path("out/cases/0003/summary.json"));
    const ProgramRun again =
      run_auxfem({"scene.prm",
                  "--output",
                  "out",
                  "--set",
                  "Sweep/Lattice/Opening angle=50, 60, 70, 75 deg"});
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    expect_contains(again.output,
                    {"Opening angle = 60 deg: from an earlier sweep",
                     "Opening angle = 70 deg\n",
                     "Opening angle = 75 deg\n"});
    EXPECT_EQ(Table(path("out/sweep.csv"))["Opening angle"].back(), 75);
  }

  TEST_F(SweepProgram, RunsCasesSideBySide)
  {
    const ProgramRun run = run_auxfem_on(2, {"scene.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_four_angles(Table(path("out/sweep.csv")));
  }

  // A star whose vertices meet cannot be meshed.
  TEST_F(SweepProgram, CasesThatFailHaveARow)
  {
    const ProgramRun run =
      run_auxfem({"scene.prm",
                  "--output",
                  "out",
                  "--set",
                  "Sweep/Lattice/Opening angle=60 deg",
                  "--sweep",
                  "Sections/wall/Struts=edges, stubs, all"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output,
                    {"1/3", "failed, Sections:", "Verdict: doubtful"});
    const std::string table = read_text(path("out/sweep.csv"));
    expect_contains(table, {"nan", "Sections: Strut", "completed"});
  }

  TEST_F(SweepProgram, TakesNumbersFromHistories)
  {
    write("swing.prm", data_text("star.prm"));
    const ProgramRun run = run_auxfem({"swing.prm",
                                       "--output",
                                       "out",
                                       "--sweep",
                                       "Time/End time=0.5, 1 ms",
                                       "--set",
                                       "Quantities/energy=maximum of strain",
                                       "--set",
                                       "Sampling/Results=energy"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const Table table(path("out/sweep.csv"));
    const auto  energies = table["energy"];
    ASSERT_EQ(energies.size(), 2u);
    EXPECT_GT(energies[0], 0);
    EXPECT_GE(energies[1], energies[0]);
    const Table history(path("out/cases/0002/history.csv"));
    const auto  strain = history["strain"];
    EXPECT_NEAR(energies[1],
                *std::max_element(strain.begin(), strain.end()),
                0.01 * energies[1]);
  }

  TEST_F(SweepProgram, UnknownParametersAndResultsAreNamed)
  {
    const ProgramRun wrong = run_auxfem(
      {"scene.prm", "--output", "out", "--sweep", "Lattice/Angle=1, 2"});
    EXPECT_EQ(wrong.exit_code, 1);
    expect_contains(wrong.errors,
                    {"no valid scene, with", "Angle = 1:", "Lattice/Angle"});
    EXPECT_FALSE(fs::exists(path("out")));
    const ProgramRun missing = run_auxfem(
      {"scene.prm", "--output", "out", "--set", "Sampling/Results=nu21, nu99"});
    EXPECT_EQ(missing.exit_code, 1);
    expect_contains(missing.errors, {"no case has a result \"nu99\"", "nu12"});
  }
} // namespace
