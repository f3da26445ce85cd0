#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  const std::string short_run = "Time/End time=40 us";

  /** Runs into folders that hold files already. */
  class FilesOfTheUser : public ProgramTest
  {
  protected:
    FilesOfTheUser()
    {
      write("scene.prm", data_text("star.prm"));
    }

    ProgramRun run_into(const std::string &output,
                        const std::string &scene   = "scene.prm",
                        const Words       &further = {}) const
    {
      return run_auxfem(arguments(output, scene, further));
    }

    static Words arguments(const std::string &output,
                           const std::string &scene,
                           const Words       &further)
    {
      Words words = {scene, "--output", output, "--set", short_run};
      words.insert(words.end(), further.begin(), further.end());
      return words;
    }

    static void expect_refusal(const ProgramRun &run, const Words &parts)
    {
      EXPECT_EQ(run.exit_code, 1) << run.output << run.errors;
      expect_contains(run.errors, parts);
    }
  };

  TEST_F(FilesOfTheUser, AreNotWrittenThroughLinks)
  {
    fs::create_directories(path("elsewhere"));
    write("elsewhere/empty", "");
    const auto refuses_link = [&](const std::string &name,
                                  const std::string &target,
                                  const Words       &further = {}) {
      fs::create_directories(path("out"));
      fs::create_symlink(target, path("out/" + name));
      expect_refusal(run_into("out", "scene.prm", further), {name});
      fs::remove_all(path("out"));
    };
    refuses_link(".auxfem-files", "../elsewhere/empty", {"--force"});
    refuses_link(".auxfem-files", "../elsewhere/new", {"--force"});
    refuses_link("solution", "../elsewhere", {"--force"});
    refuses_link("connectors", "../elsewhere/none", {"--force"});
    refuses_link("history.csv", "../elsewhere/empty");

    // --force replaces the link, not its target.
    fs::create_directories(path("out"));
    for (const char *name : {"history.csv", "log.txt", "summary.json.part"})
      fs::create_symlink("../elsewhere/empty",
                         path("out/" + std::string(name)));
    const ProgramRun run = run_into("out", "scene.prm", {"--force"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;

    EXPECT_EQ(read_text(path("elsewhere/empty")), "");
    EXPECT_EQ(std::distance(fs::directory_iterator(path("elsewhere")), {}), 1);
  }

  TEST_F(FilesOfTheUser, AreNotReplacedUnasked)
  {
    fs::create_directories(path("mine"));
    write("mine/log.txt", "a diary");
    const auto refused = [&](const ProgramRun &run) {
      expect_refusal(run, {"`mine`", "log.txt", "has not written", "--force"});
      EXPECT_EQ(read_text(path("mine/log.txt")), "a diary");
      EXPECT_FALSE(fs::exists(path("mine/history.csv")));
    };
    refused(run_into("mine"));
    refused(run_auxfem_on(2, arguments("mine", "scene.prm", {})));

    EXPECT_EQ(run_into("mine", "scene.prm", {"--force"}).exit_code, 0);
    expect_contains(read_text(path("mine/log.txt")), {"Small star lattice"});
    // From now on the files are those of auxfem.
    EXPECT_EQ(run_into("mine").exit_code, 0);
  }



  TEST_F(FilesOfTheUser, SceneInItsOwnFolderUnderTheNameOfAResult)
  {
    fs::rename(path("scene.prm"), path("log.txt"));
    for (const Words &further : {Words(), Words{"--force"}})
      {
        expect_refusal(run_into(".", "log.txt", further),
                       {"The run reads log.txt", "Output/Directory"});
        EXPECT_EQ(read_text(path("log.txt")), data_text("star.prm"));
      }
  }



  TEST_F(FilesOfTheUser, TableAndMeshInTheFolderOfTheResults)
  {
    ASSERT_EQ(run_into("out").exit_code, 0);
    const std::string history = read_text(path("out/history.csv"));
    for (const std::string table : {"table:", "smooth table:", "2 kg * table:"})
      for (const Words &further : {Words(), Words{"--force"}})
        {
          Words with_table = {"--set",
                              "Loads/hit/Force y=" + table +
                                " out/history.csv"};
          with_table.insert(with_table.end(), further.begin(), further.end());
          expect_refusal(run_into("out", "scene.prm", with_table),
                         {"The run reads", "history.csv"});
          EXPECT_EQ(read_text(path("out/history.csv")), history);
        }

    fs::copy(AUXFEM_PRM_DIRECTORY "/../meshes/portal.msh",
             path("out/history.csv"),
             fs::copy_options::overwrite_existing);
    write("portal.prm",
          replaced(read_text(AUXFEM_PRM_DIRECTORY "/portal.prm"),
                   "../meshes/portal.msh",
                   "out/history.csv"));
    expect_refusal(run_auxfem({"portal.prm", "--output", "out", "--force"}),
                   {"The run reads", "history.csv"});
  }



  TEST_F(FilesOfTheUser, IncludedFileInTheFolderOfTheResults)
  {
    fs::create_directories(path("out"));
    write("out/parameters.prm", data_text("star.prm"));
    write("outer.prm", "include out/parameters.prm\n");
    expect_refusal(run_into("out", "outer.prm", {"--force"}),
                   {"The run reads out/parameters.prm"});
    EXPECT_EQ(read_text(path("out/parameters.prm")), data_text("star.prm"));
  }



  TEST_F(FilesOfTheUser, ComparisonKeepsThem)
  {
    const std::string scene = AUXFEM_PRM_DIRECTORY "/cell-case-1.prm";
    fs::create_directories(path("out"));
    write("out/comparison.csv", "mine");
    const Words compare =
      {"--compare", scene, "--output", "out", "--set", "Time/End time=1 ms"};
    expect_refusal(run_auxfem(compare), {"comparison.csv", "--force"});
    EXPECT_EQ(read_text(path("out/comparison.csv")), "mine");
    Words by_force = compare;
    by_force.emplace_back("--force");
    EXPECT_EQ(run_auxfem(by_force).exit_code, 0);
    EXPECT_EQ(run_auxfem(compare).exit_code, 0);
    // Runs and comparisons may share a folder.
    EXPECT_EQ(run_into("out").exit_code, 0);
    EXPECT_TRUE(fs::exists(path("out/comparison.csv")));
  }



  TEST_F(FilesOfTheUser, FolderWithoutName)
  {
    expect_refusal(run_into(""), {"--output needs the name of a folder"});
    expect_refusal(run_auxfem({"scene.prm", "--set", "Output/Directory="}),
                   {"Output/Directory = : there is no value"});
  }



  TEST_F(FilesOfTheUser, TwoRunsAtOnceDoNotMix)
  {
    // The first one is long enough to be still there when it is stopped.
    const std::string program =
      "'" AUXFEM_EXECUTABLE
      "' scene.prm --output out --set 'Time/End time=10 ms' "
      "--set 'Effects/Contact=off'";
    const ProgramRun both =
      run_program({"sh",
                   "-c",
                   program +
                     " >first.txt & first=$!; "
                     "until [ -e out/history.csv ]; do sleep 0.02; done; "
                     "kill -STOP $first; " +
                     program +
                     " --force; code=$?; kill -CONT $first; wait $first; "
                     "echo first ended with $?; exit $code"});
    expect_refusal(both, {"Another run of auxfem", "`out`"});
    expect_contains(both.output, {"first ended with 0"});
    EXPECT_EQ(summary("exit_state"), "completed");
    EXPECT_EQ(run_into("out").exit_code, 0);
  }
} // namespace
