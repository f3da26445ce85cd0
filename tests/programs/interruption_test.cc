#include <mpi.h>
#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Runs that a signal or a full disk ends. */
  class EndedRun : public ProgramTest
  {
  protected:
    EndedRun()
    {
      // Far more steps than are waited for.
      write("scene.prm",
            replaced(data_text("star.prm"),
                     "set End time  = 1 ms",
                     "set End time  = 100 s"));
    }

    /** Runs @p command in the shell, sends @p signal after some rows. */
    ProgramRun interrupted(const std::string &command,
                           const std::string &signal) const
    {
      return run_program(
        {"sh",
         "-c",
         command +
           " & run=$!; until [ -e out/history.csv ] && "
           "[ $(wc -l < out/history.csv) -gt 5 ]; do sleep 0.02; done; "
           "kill -" +
           signal + " $(cat pid 2>/dev/null || echo $run); wait $run"});
    }

    void expect_whole_results(const std::string &exit_state) const
    {
      EXPECT_EQ(summary("exit_state"), exit_state);
      EXPECT_EQ(summary("verdict"), "doubtful");
      expect_contains(read_text(path("out/log.txt")),
                      {"The run is incomplete"});
      const Table table = history(); // throws if a row is torn
      EXPECT_GT(table.n_rows, 5u);
      EXPECT_NEAR(table["time"].back(),
                  std::stod(summary("time_reached")),
                  1e-12);
      expect_contains(read_text(path("out/log.txt")),
                      {"Stopped early", exit_state});
      expect_contains(read_text(path("out/solution.pvd")), {"</VTKFile>"});
    }

    const std::string program =
      "'" AUXFEM_EXECUTABLE "' scene.prm --output out";
  };

  TEST_F(EndedRun, BySignal)
  {
    const ProgramRun run = interrupted(program, "TERM");
    EXPECT_EQ(run.exit_code, 128 + 15) << run.errors;
    expect_contains(run.errors, {"auxfem: ended by signal 15"});
    expect_whole_results("ended by signal 15 (Terminated)");
  }



  TEST_F(EndedRun, ByInterruptOfTheKeyboard)
  {
    // In the background, a shell lets programs ignore it.
    const ProgramRun run =
      interrupted(AUXFEM_PYTHON
                  " -c \"import os, signal; signal.signal(signal.SIGINT, "
                  "signal.SIG_DFL); os.execl('" AUXFEM_EXECUTABLE
                  "', 'auxfem', 'scene.prm', '--output', 'out')\"",
                  "INT");
    EXPECT_EQ(run.exit_code, 128 + 2) << run.errors;
    expect_whole_results("ended by signal 2 (Interrupt)");
  }



  TEST_F(EndedRun, BySignalToOneOfTwoRanks)
  {
    const ProgramRun run =
      interrupted(AUXFEM_MPIRUN
                  " -n 2 sh -c '[ $OMPI_COMM_WORLD_RANK = 0 ] || echo $$ >pid; "
                  "exec \"" AUXFEM_EXECUTABLE "\" scene.prm --output out'",
                  "TERM");
    EXPECT_EQ(run.exit_code, 128 + 15) << run.errors;
    expect_whole_results("ended by signal 15 (Terminated)");
  }



  TEST_F(EndedRun, BySignalInTheReducedCell)
  {
    write("scene.prm", read_text(AUXFEM_PRM_DIRECTORY "/cell-case-1.prm"));
    const std::string endless =
      " --set 'Time/End time=10000 s' --set 'Output/History interval=1000'";
    for (const std::string launcher : {"", AUXFEM_MPIRUN " -n 2 "})
      {
        const ProgramRun run = interrupted(
          launcher + "'" AUXFEM_EXECUTABLE "' scene.prm --output out" + endless,
          "TERM");
        EXPECT_EQ(run.exit_code, launcher.empty() ? 128 + 15 : run.exit_code)
          << run.errors;
        EXPECT_EQ(summary("exit_state"), "ended by signal 15 (Terminated)");
      }
  }



  TEST_F(EndedRun, ByAFullDisk)
  {
    if (OMPI_MAJOR_VERSION >= 5)
      GTEST_SKIP() << "Files of Open MPI 5 are larger than the limit.";
    // No file may be larger than 40 KiB (of 512 bytes, as sh counts).
    const ProgramRun run = run_program(
      {"sh",
       "-c",
       "ulimit -f 80; exec " + program + " --set Output/Graphics=false"});
    EXPECT_EQ(run.exit_code, 2) << run.output;
    expect_contains(run.errors,
                    {"Cannot write to out/history.csv",
                     "File too large",
                     "All earlier rows are in the file"});
    const std::string text = read_text(path("out/history.csv"));
    EXPECT_GT(text.size(), 40000u);
    EXPECT_EQ(text.back(), '\n');
    EXPECT_GT(history().n_rows, 5u);
    expect_contains(summary("exit_state"), {"Cannot write to out/history.csv"});
  }
} // namespace
