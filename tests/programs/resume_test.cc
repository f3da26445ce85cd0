#include <auxfem/algebra/vector.h>

#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Runs that end early and are gone on with, in `out`, beside one that is
   * not, in `whole`. */
  class ResumedRun : public ProgramTest
  {
  protected:
    ResumedRun()
    {
      // Takes some tenths of a second.
      write("scene.prm",
            replaced(replaced(replaced(data_text("star.prm"),
                                       "set End time  = 1 ms",
                                       "set End time  = " + end),
                              "set Time step = 20 us",
                              "set Time step = 0.0000152587890625"),
                     "set Force y = -4e3 * t",
                     "set Force y = -0.3 * sin(1000 * t)") +
              // Else the end time has a say in it.
              "subsection Effects\n  set Large rotation = on\nend\n");
    }

    /** 5 / 2^8, 2 / 2^8 and 3 / 2^8 s: 2^-16 s, the step, divides them without
     * round-off. */
    inline static const std::string end = "0.01953125", early = "0.0078125",
                                    later = "0.01171875";

    /** Of a run in `out` that takes checkpoints as often as it may. */
    static Words begin()
    {
      return {"scene.prm",
              "--output",
              "out",
              "--set",
              "Output/Checkpoint interval=1e-6 s"};
    }

    static Words go_on(const Words &further = {})
    {
      Words words = {"--resume", "out"};
      words.insert(words.end(), further.begin(), further.end());
      return words;
    }

    /** Runs auxfem on @p n_ranks, of which the last is killed at @p seconds
     * after a checkpoint. */
    ProgramRun killed(const Words       &arguments,
                      const unsigned int n_ranks,
                      const std::string &seconds) const
    {
      std::string command = "'" AUXFEM_EXECUTABLE "'";
      for (const std::string &argument : arguments)
        command += " '" + argument + "'";
      write("start.sh",
            "[ ${OMPI_COMM_WORLD_RANK:-0} = " + std::to_string(n_ranks - 1) +
              " ] && echo $$ > pid\nexec " + command + "\n");
      const std::string launcher = n_ranks == 1
        ? std::string("sh")
        : AUXFEM_MPIRUN " -n " + std::to_string(n_ranks) + " sh";
      return run_program(
        {"sh",
         "-c",
         "mkdir -p out; touch mark; " + launcher +
           " start.sh & run=$!; while kill -0 $run 2>/dev/null && ! find out "
           "-name 'checkpoint_?' -newer mark | grep -q .; do sleep 0.01; done; "
           "sleep " +
           seconds + "; kill -9 $(cat pid); wait $run"});
    }

    bool has_checkpoint() const
    {
      return std::filesystem::exists(path("out/checkpoint_a"));
    }

    /** Kills a run on so many ranks some times, and lets it come to its end. */
    void kill_and_go_on(const unsigned int n_ranks) const
    {
      unsigned int n_killed = 0;
      Words        words    = begin();
      for (const char *seconds : {"0", "0.05", "0.01", "0.1", "0.02"})
        {
          // It takes long to start and to end several ranks.
          if (n_ranks > 1 && n_killed == 2)
            break;
          n_killed += killed(words, n_ranks, seconds).exit_code != 0 ? 1 : 0;
          words = go_on();
        }
      const ProgramRun run =
        n_ranks == 1 ? start_auxfem(go_on()) : run_auxfem_on(n_ranks, go_on());
      EXPECT_EQ(run.exit_code, 0) << run.errors;
      EXPECT_EQ(n_killed, n_ranks > 1 ? 2u : 5u);
    }

    /** Starts a run that gets a signal after some rows. */
    void end_by_signal() const
    {
      const ProgramRun ended = run_program(
        {"sh",
         "-c",
         "'" AUXFEM_EXECUTABLE "' scene.prm --output out & run=$!; until [ -e "
         "out/history.csv ] && [ $(wc -l < out/history.csv) -gt 5 ]; do sleep "
         "0.01; done; kill -TERM $run; wait $run"});
      ASSERT_EQ(ended.exit_code, 128 + 15);
      expect_contains(ended.output, {"auxfem --resume out"});
    }

    void expect_that_of_the_whole_run(
      const Words &files = {"history.csv", "solution.pvd"}) const
    {
      // Not compared as texts, which would fill the screen.
      for (const std::string &file : files)
        EXPECT_TRUE(read_text(path("out/") + file) ==
                    read_text(path("whole/") + file))
          << file;
      for (const char *name : {"steps", "newton_iterations", "factorizations"})
        EXPECT_EQ(summary(name), summary(name, "whole")) << name;
      EXPECT_EQ(summary("exit_state"), "completed");
    }
  };

  TEST_F(ResumedRun, KilledAgainAndAgainIsTheWholeOne)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    kill_and_go_on(1);
    expect_that_of_the_whole_run();
    expect_contains(read_text(path("out/log.txt")), {"Goes on from t = "});
  }

  TEST_F(ResumedRun, KilledAgainAndAgainOnTwoRanksIsTheWholeOne)
  {
    ASSERT_EQ(run_auxfem_on(2, {"scene.prm", "--output", "whole"}).exit_code,
              0);
    kill_and_go_on(2);
    expect_that_of_the_whole_run();
  }

  TEST_F(ResumedRun, MayHaveAnotherNumberOfRanks)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    Words half = begin();
    half.insert(half.end(), {"--set", "Time/End time=" + early});
    ASSERT_EQ(run_auxfem_on(2, half).exit_code, 0);
    const ProgramRun run = run_auxfem(go_on({"--set", "Time/End time=" + end}));
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Table whole = history("whole"), resumed = history();
    ASSERT_EQ(whole.n_rows, resumed.n_rows);
    for (const std::string name : {"top.uy", "top.vy", "apex.phi", "strain"})
      for (unsigned int i = 0; i < whole.n_rows; ++i)
        EXPECT_NEAR(whole[name][i],
                    resumed[name][i],
                    1e-10 * auxfem::largest_size(whole[name]))
          << name;
  }

  TEST_F(ResumedRun, GoesOnToALaterEnd)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    Words half = begin();
    // Between two steps, and with a last row of its own.
    half.insert(half.end(), {"--set", "Time/End time=5.33 ms"});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    ASSERT_EQ(run_auxfem(go_on({"--set", "Time/End time=6 ms"})).exit_code, 0);
    const ProgramRun again = run_auxfem(go_on());
    EXPECT_EQ(again.exit_code, 1);
    expect_contains(again.errors, {"got to t = 0.006 s", "Time/End time"});
    EXPECT_NEAR(history()["time"].back(), 6e-3, 1e-15);
  }

  TEST_F(ResumedRun, ToALaterEndIsTheWholeOne)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    Words half = begin();
    half.insert(half.end(),
                {"--set",
                 "Time/End time=" + early,
                 "--set",
                 "Output/History interval=1"});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    ASSERT_EQ(run_auxfem(go_on({"--set", "Time/End time=" + end})).exit_code,
              0);
    expect_that_of_the_whole_run();
  }

  TEST_F(ResumedRun, AfterASignalIsTheWholeOne)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    end_by_signal();
    const ProgramRun run = run_auxfem(go_on());
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_that_of_the_whole_run();
  }

  TEST_F(ResumedRun, KeepsItsParameters)
  {
    Words half = begin();
    half.insert(half.end(), {"--set", "Time/End time=1 ms"});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    const ProgramRun run = run_auxfem(go_on({"--set",
                                             "Time/End time=2 ms",
                                             "--set",
                                             "Time/Time step=10 us",
                                             "--set",
                                             "Output/Segments per element=3",
                                             "--set",
                                             "Output/Graphics=false"}));
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(
      run.errors,
      {"Time/Time step: it was \"0.0000152587890625\", now it is \"10 us\"",
       "Output/Graphics: it was",
       "start anew"});
    EXPECT_EQ(run.errors.find("Segments"), std::string::npos) << run.errors;
    EXPECT_EQ(run.errors.find("End time:"), std::string::npos) << run.errors;
  }

  TEST_F(ResumedRun, RefusesFilesThatHaveChanged)
  {
    write("load.txt", "0 0\n1e-3 -0.1\n");
    const std::string by_table = "Loads/hit/Force y=table: load.txt";
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole", "--set", by_table})
                .exit_code,
              0);
    Words half = begin();
    half.insert(half.end(),
                {"--set", by_table, "--set", "Time/End time=" + early});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    write("load.txt", "0 0\n1e-3 -0.2\n");
    const Words      to_end  = go_on({"--set", "Time/End time=" + end});
    const ProgramRun changed = run_auxfem(to_end);
    EXPECT_EQ(changed.exit_code, 1);
    expect_contains(changed.errors, {"load.txt", "has changed"});
    std::filesystem::remove(path("load.txt"));
    EXPECT_EQ(run_auxfem(to_end).exit_code, 1);
    write("load.txt", "0 0\n1e-3 -0.1\n");
    ASSERT_EQ(run_auxfem(to_end).exit_code, 0);
    EXPECT_TRUE(read_text(path("out/history.csv")) ==
                read_text(path("whole/history.csv")));
  }

  TEST_F(ResumedRun, FallsBackToTheOlderCheckpoint)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    Words half = begin();
    half.insert(half.end(), {"--set", "Time/End time=" + early});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    ASSERT_EQ(run_auxfem(go_on({"--set", "Time/End time=" + later})).exit_code,
              0);
    // The newest; the one before is older by the time a checkpoint takes.
    std::string newest = path("out/checkpoint_a");
    if (std::filesystem::last_write_time(path("out/checkpoint_b")) >
        std::filesystem::last_write_time(newest))
      newest = path("out/checkpoint_b");
    std::filesystem::resize_file(newest,
                                 std::filesystem::file_size(newest) / 2);
    const ProgramRun run = run_auxfem(go_on({"--set", "Time/End time=" + end}));
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.errors, {"warning", "damaged", "other checkpoint"});
    expect_that_of_the_whole_run();
  }

  TEST_F(ResumedRun, IsRefusedWithoutCheckpoints)
  {
    ASSERT_EQ(run_auxfem({"scene.prm",
                          "--output",
                          "out",
                          "--set",
                          "Output/Checkpoint interval=0 s"})
                .exit_code,
              0);
    EXPECT_FALSE(has_checkpoint());
    for (const char *folder : {"out", "nowhere"})
      {
        const ProgramRun run = run_auxfem({"--resume", folder});
        EXPECT_EQ(run.exit_code, 1);
        expect_contains(run.errors, {"no checkpoint in ", folder});
      }
    // What a new run leaves in the folder is its own.
    ASSERT_EQ(run_auxfem(begin()).exit_code, 0);
    EXPECT_TRUE(has_checkpoint());
    ASSERT_EQ(run_auxfem({"scene.prm",
                          "--output",
                          "out",
                          "--set",
                          "Output/Checkpoint interval=0 s"})
                .exit_code,
              0);
    EXPECT_FALSE(has_checkpoint());
  }

  /** The same for paths of equilibria, which buckle on their way. */
  class ResumedPath : public ResumedRun
  {
  protected:
    ResumedPath()
    {
      write("scene.prm",
            replaced(replaced(replaced(prm_text("path.prm"),
                                       "set Cells x       = 5",
                                       "set Cells x       = 2"),
                              "set Cells y       = 4",
                              "set Cells y       = 2"),
                     "set Largest displacement = 25 mm",
                     "set Resolution = 1e-4\n set Largest displacement = " +
                       end));
    }

    inline static const std::string end = "12 mm", early = "2 mm";

    void expect_that_of_the_whole_path() const
    {
      expect_that_of_the_whole_run({"history.csv",
                                    "solution.pvd",
                                    "singular_points.csv",
                                    "singular_solution.pvd"});
      for (const char *name : {"arc_length", "load_factor"})
        EXPECT_EQ(summary(name), summary(name, "whole")) << name;
      EXPECT_EQ(count_lines(read_text(path("out/singular_points.csv"))), 2u);
    }

    void run_whole(const unsigned int n_ranks) const
    {
      const Words words = {"scene.prm", "--output", "whole"};
      ASSERT_EQ((n_ranks == 1 ? run_auxfem(words)
                              : run_auxfem_on(n_ranks, words))
                  .exit_code,
                0);
    }
  };

  TEST_F(ResumedPath, KilledAgainAndAgainIsTheWholeOne)
  {
    run_whole(1);
    kill_and_go_on(1);
    expect_that_of_the_whole_path();
    expect_contains(read_text(path("out/log.txt")),
                    {"Goes on from load factor "});
  }

  TEST_F(ResumedPath, KilledAgainAndAgainOnTwoRanksIsTheWholeOne)
  {
    run_whole(2);
    kill_and_go_on(2);
    expect_that_of_the_whole_path();
  }

  TEST_F(ResumedPath, AfterASignalIsTheWholeOne)
  {
    run_whole(1);
    end_by_signal();
    const ProgramRun run = run_auxfem(go_on());
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_that_of_the_whole_path();
  }

  TEST_F(ResumedPath, ToALaterEndIsTheWholeOne)
  {
    run_whole(1);
    const std::string largest = "Path/Largest displacement=";
    for (const std::string &first_end :
         {largest + early, std::string("Path/Largest load factor=0.3")})
      {
        Words first = begin();
        first.insert(first.end(), {"--set", first_end});
        ASSERT_EQ(run_auxfem(first).exit_code, 0);
        const ProgramRun run = run_auxfem(go_on(
          {"--set", largest + end, "--set", "Path/Largest load factor=1"}));
        ASSERT_EQ(run.exit_code, 0) << run.errors;
        expect_that_of_the_whole_path();
      }
  }

  TEST_F(ResumedPath, KeepsItsParameters)
  {
    Words first = begin();
    first.insert(first.end(), {"--set", "Path/Points=8"});
    ASSERT_EQ(run_auxfem(first).exit_code, 0);
    const ProgramRun run = run_auxfem(go_on({"--set",
                                             "Path/Resolution=1e-3",
                                             "--set",
                                             "Time/End time=2 s",
                                             "--set",
                                             "Path/Points=9"}));
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors,
                    {"Path/Resolution: it was \"1e-4\"",
                     "Time/End time: it was",
                     "Only Path/Largest load factor",
                     "start anew"});
    EXPECT_EQ(run.errors.find("Path/Points:"), std::string::npos) << run.errors;
    const ProgramRun behind = run_auxfem(go_on({"--set", "Path/Points=5"}));
    EXPECT_EQ(behind.exit_code, 1);
    expect_contains(behind.errors, {"7 points", "Path/Points is 5"});
  }
} // namespace
