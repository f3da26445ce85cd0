#include <programs/resumed_run.h>

namespace
{
  using namespace auxfem::testing_support;

  TEST_F(ResumedRun, KilledAgainAndAgainIsTheWholeOne)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    kill_and_go_on(1);
    expect_that_of_the_whole_run();
    expect_contains(read_text(path("out/log.txt")), {"Goes on from t = "});
  }

  TEST_F(ResumedRun, DoesNotWriteThroughLinks)
  {
    namespace fs = std::filesystem;
    Words half   = begin();
    half.insert(half.end(), {"--set", "Time/End time=1 ms"});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    for (const std::string name : {"history.csv",
                                   "history.units.csv",
                                   "parameters.prm",
                                   "log.txt",
                                   "solution",
                                   ".auxfem-files",
                                   "checkpoint_b.part"})
      {
        const std::string file = path("out/" + name), kept = path("kept");
        if (name == "checkpoint_b.part")
          write("kept", "mine");
        else
          fs::rename(file, kept);
        fs::create_symlink(kept, file);
        const bool        is_folder = fs::is_directory(kept);
        const std::string before    = is_folder ? "" : read_text(kept);
        const ProgramRun  run =
          run_auxfem(go_on({"--set", "Time/End time=2 ms"}));
        EXPECT_EQ(run.exit_code, 1) << name << run.output;
        expect_contains(run.errors, {name, "link"});
        if (!is_folder)
          {
            EXPECT_EQ(read_text(kept), before) << name;
          }
        fs::remove(file);
        fs::rename(kept, file);
      }
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

  TEST_F(ResumedRun, ToALaterEndIsAboutTheWholeOne)
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
    expect_about_that_of_the_whole_run();
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
    expect_about_that_of_the_whole_run();
  }

  TEST_F(ResumedRun, GoesOnWithTheJumpAtWhichItEnded)
  {
    write("load.txt", "0 -0.1\n" + early + " -0.1\n" + early + " 0\n1 0\n");
    const std::string by_table = "Loads/hit/Force y=table: load.txt";
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole", "--set", by_table})
                .exit_code,
              0);
    Words half = begin();
    half.insert(half.end(),
                {"--set", by_table, "--set", "Time/End time=" + early});
    ASSERT_EQ(run_auxfem(half).exit_code, 0);
    ASSERT_EQ(run_auxfem(go_on({"--set", "Time/End time=" + end})).exit_code,
              0);
    expect_about_that_of_the_whole_run();
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
    expect_about_that_of_the_whole_run();
  }

  TEST_F(ResumedRun, IsRefusedWithoutCheckpoints)
  {
    ASSERT_EQ(
      run_auxfem(
        {"scene.prm", "--output", "out", "--set", "Output/Checkpoints=0"})
        .exit_code,
      0);
    EXPECT_FALSE(has_checkpoint());
    for (const char *folder : {"out", "nowhere"})
      {
        const ProgramRun run = run_auxfem({"--resume", folder});
        EXPECT_EQ(run.exit_code, 1);
        expect_contains(run.errors, {"no checkpoint in ", folder});
      }
    // A new run removes the checkpoints of the old one.
    ASSERT_EQ(run_auxfem(begin()).exit_code, 0);
    EXPECT_TRUE(has_checkpoint());
    ASSERT_EQ(
      run_auxfem(
        {"scene.prm", "--output", "out", "--set", "Output/Checkpoints=0"})
        .exit_code,
      0);
    EXPECT_FALSE(has_checkpoint());
  }

  TEST_F(ResumedPath, KilledAgainAndAgainIsTheWholeOne)
  {
    run_whole(1);
    kill_and_go_on(1);
    expect_that_of_the_whole_path();
    expect_contains(read_text(path("out/log.txt")),
                    {"Goes on from load factor "});
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
