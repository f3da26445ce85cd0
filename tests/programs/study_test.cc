#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  class StudyProgram : public ProgramTest
  {
  protected:
    StudyProgram()
    {
      write("scene.prm", data_text("star.prm"));
    }

    Words arguments(const Words &further) const
    {
      Words words = {"scene.prm", "--output", "out", "--set", "Analysis=study"};
      words.insert(words.end(), further.begin(), further.end());
      return words;
    }

    std::size_t n_runs() const
    {
      const fs::directory_iterator all(path("out/runs"));
      return std::distance(begin(all), end(all));
    }
  };
} // namespace

TEST_F(StudyProgram, LeavesTablesAndPictures)
{
  const ProgramRun run = run_auxfem(arguments({}));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  expect_contains(run.output,
                  {"Study: convergence, 9 simulations",
                   "9/9",
                   "## Error by mesh: order",
                   "## Error by time step: ",
                   "## What to take",
                   "Reference: "});
  const std::string page = read_text(path("out/study.md"));
  expect_contains(page,
                  {"# ",
                   "## Error by mesh",
                   "![Error by mesh](error-mesh.svg)"});
  for (const char *const file : {"study.csv",
                                 "study.units.csv",
                                 "error-mesh.gnuplot",
                                 "error-mesh.svg",
                                 "error-mesh.png",
                                 "error-time-step.svg",
                                 "log.txt",
                                 "original.prm",
                                 "parameters.prm"})
    EXPECT_GT(fs::file_size(path("out/" + std::string(file))), 0u) << file;
  expect_contains(read_text(path("out/error-mesh.svg")), {"<svg", "</svg>"});
  EXPECT_EQ(n_runs(), 9u);
}

TEST_F(StudyProgram, SimulationInItsFolderReplacesItsResults)
{
  EXPECT_EQ(
    run_auxfem(arguments({"--set", "Study/Refinements=none"})).exit_code,
    0);
  EXPECT_EQ(run_auxfem({"scene.prm", "--output", "out"}).exit_code, 0);
  for (const char *const file : {"study.md",
                                 "study.csv",
                                 "study.units.csv",
                                 "error-time-step.gnuplot",
                                 "error-time-step.svg",
                                 "error-time-step.png"})
    EXPECT_FALSE(fs::exists(path("out/" + std::string(file)))) << file;
  EXPECT_TRUE(fs::exists(path("out/history.csv")));
  // They serve the next study.
  EXPECT_EQ(n_runs(), 5u);
  const ProgramRun again =
    run_auxfem(arguments({"--set", "Study/Refinements=none"}));
  EXPECT_EQ(again.exit_code, 0) << again.errors;
  expect_contains(again.output, {"from an earlier study here"});
  EXPECT_FALSE(fs::exists(path("out/history.csv")));
}

TEST_F(StudyProgram, GoesOnWhereItWasInterrupted)
{
  // Ended while it computes, when some runs are there.
  const ProgramRun first = run_program(
    {"sh",
     "-c",
     std::string(AUXFEM_EXECUTABLE) +
       " scene.prm --output out --set Analysis=study --set 'Study/Refinements="
       "0, 1, 2, 3, 4, 5, 6' & run=$!; until [ $(ls out/runs 2>/dev/null | grep "
       "-c 'json$') -ge 2 ]; do sleep 0.01; done; kill -TERM $run; wait $run"});
  EXPECT_EQ(first.exit_code, 128 + 15) << first.output << first.errors;
  const std::size_t before = n_runs();
  EXPECT_GE(before, 2u);
  const ProgramRun second =
    run_auxfem(arguments({"--set", "Study/Refinements=0, 1, 2"}));
  EXPECT_EQ(second.exit_code, 0) << second.errors;
  expect_contains(second.output, {"from an earlier study here"});
}

TEST_F(StudyProgram, RunsGoSideBySideOnRanks)
{
  const ProgramRun run =
    run_auxfem_on(2, arguments({"--set", "Study/Refinements=none"}));
  EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
  expect_contains(run.output, {"5/5", "## Error by time step"});
  EXPECT_EQ(n_runs(), 5u);
}

TEST_F(StudyProgram, CheckListsTheRunsAndDrawsTheLattice)
{
  const ProgramRun run = run_auxfem(arguments({"--check"}));
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  expect_contains(run.output, {"9 simulations", "4 elements a strut"});
  EXPECT_EQ(std::distance(fs::directory_iterator(path("out")), {}), 1);
  EXPECT_TRUE(fs::exists(path("out/lattice.vtu")));
}

TEST_F(StudyProgram, MistakesCostNoEarlierResults)
{
  EXPECT_EQ(
    run_auxfem(arguments({"--set", "Study/Refinements=none"})).exit_code,
    0);
  const std::string before = read_text(path("out/study.md"));
  const ProgramRun  run =
    run_auxfem(arguments({"--set", "Quantities/q=history nowhere.uy"}));
  EXPECT_EQ(run.exit_code, 1);
  expect_contains(run.errors, {"Quantities/q", "nowhere.uy", "Columns"});
  EXPECT_EQ(read_text(path("out/study.md")), before);
}

TEST_F(StudyProgram, ReferenceThatFailsGivesTheExitCodeOfUselessResults)
{
  // The finest steps alone, of 5 us, come by 0.995 ms.
  const ProgramRun run = run_auxfem(arguments(
    {"--set",
     "Loads/hit/Force y=if(abs(t - 0.995e-3) < 1e-9, 0 / 0, -4e3 * t)",
     "--set",
     "Study/Refinements=none"}));
  EXPECT_EQ(run.exit_code, 3) << run.output << run.errors;
  expect_contains(run.output, {"Verdict: not to be used", "reference"});
}
