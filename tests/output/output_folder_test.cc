#include <auxfem/output/output_folder.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  namespace fs = std::filesystem;

  const FolderContents folder_contents = {{"log.txt", "history.csv"},
                                          {"solution"}};


  /** A fresh folder for the running test. */
  class OutputFolderTest : public testing::Test
  {
  protected:
    OutputFolderTest()
      : folder(
          fs::path(AUXFEM_TEST_OUTPUT_DIRECTORY) /
          ("output_folder_" +
           std::string(
             testing::UnitTest::GetInstance()->current_test_info()->name())))
    {
      fs::remove_all(folder);
      fs::create_directories(folder);
    }

    void write(const std::string &name, const std::string &text = "x") const
    {
      fs::create_directories((folder / name).parent_path());
      std::ofstream(folder / name) << text;
    }

    /** A run that writes both files and a series of two times. */
    void run() const
    {
      OutputFolder claim(folder, folder_contents, {});
      claim.claim_series("solution");
      for (const char *name : {"log.txt",
                               "history.csv",
                               "solution.pvd",
                               "solution/solution_00000.vtu",
                               "solution/solution_00001.pvtu",
                               "solution/solution_00001.12.vtu"})
        write(name);
    }

    std::string refusal(const std::vector<std::string> &input_files = {},
                        const bool                      force = false) const
    {
      return input_error_of([&]() {
        OutputFolder(folder, folder_contents, {input_files, force});
      });
    }

    const fs::path folder;
  };

  TEST_F(OutputFolderTest, RemovesOnlyFilesOfAuxfem)
  {
    run();
    const std::vector<std::string> others = {"notes.txt",
                                             "solution/picture.png",
                                             "solution/solution_mean.vtu",
                                             "solution/mine_00000.vtu"};
    for (const std::string &name : others)
      write(name);
    EXPECT_EQ(refusal(), "");
    for (const std::string &name : others)
      EXPECT_TRUE(fs::exists(folder / name)) << name;
    for (const char *name : {"log.txt",
                             "history.csv",
                             "solution.pvd",
                             "solution/solution_00000.vtu",
                             "solution/solution_00001.pvtu",
                             "solution/solution_00001.12.vtu"})
      EXPECT_FALSE(fs::exists(folder / name)) << name;

    for (const std::string &name : others)
      fs::remove(folder / name);
    run();
    EXPECT_EQ(refusal(), "");
    EXPECT_FALSE(fs::exists(folder / "solution"));
  }

  TEST_F(OutputFolderTest, ForeignFilesAreRejectedAndKept)
  {
    for (const std::string name : {"log.txt",
                                   "history.csv",
                                   "solution.pvd",
                                   "solution/solution_00003.vtu"})
      {
        fs::remove_all(folder);
        write(name, "of another");
        expect_parts(refusal(),
                     {folder.string(),
                      name,
                      "auxfem has not written",
                      "--output DIR",
                      "--force"});
        EXPECT_EQ(read_text(folder / name), "of another");
        EXPECT_FALSE(fs::exists(folder / ".auxfem-files"));

        EXPECT_EQ(refusal({}, true), "");
        EXPECT_FALSE(fs::exists(folder / name));
      }
  }

  TEST_F(OutputFolderTest, ForeignFileBesideOwnFilesIsRejected)
  {
    {
      const OutputFolder comparison(folder, {{"table.csv"}, {}}, {});
      write("table.csv");
    }
    write("history.csv", "of another");
    const std::string message = refusal();
    expect_parts(message, {"history.csv"});
    EXPECT_FALSE(contains(message, "table.csv"));

    // A run with other files keeps these in its list.
    fs::remove(folder / "history.csv");
    run();
    EXPECT_TRUE(fs::exists(folder / "table.csv"));
    EXPECT_NO_THROW(OutputFolder(folder, {{"table.csv"}, {}}, {}));
    EXPECT_FALSE(fs::exists(folder / "table.csv"));
    EXPECT_TRUE(fs::exists(folder / "history.csv"));
  }

  TEST_F(OutputFolderTest, ResultsOfOtherRunKindsAreRemovedUnlessRead)
  {
    {
      const OutputFolder study(folder, {{"a.csv", "b.csv", "c.csv"}, {}}, {});
      write("a.csv");
      write("b.csv");
    }
    write("d.csv", "of another");
    const OutputFolder claim(folder,
                             folder_contents,
                             {{(folder / "b.csv").string()},
                              false,
                              {"a.csv", "b.csv", "d.csv"}});
    EXPECT_FALSE(fs::exists(folder / "a.csv"));
    EXPECT_TRUE(fs::exists(folder / "b.csv"));
    EXPECT_TRUE(fs::exists(folder / "d.csv"));
    const std::string list = read_text(folder / ".auxfem-files");
    EXPECT_FALSE(contains(list, "a.csv"));
    EXPECT_TRUE(contains(list, "b.csv"));
  }

  TEST_F(OutputFolderTest, DanglingLinksAreForeign)
  {
    fs::create_symlink("nowhere", folder / "log.txt");
    expect_parts(refusal(), {"log.txt", "auxfem has not written"});
  }

  TEST_F(OutputFolderTest, FileThatIsReadIsNeverReplaced)
  {
    run();
    write("history.csv", "a table");
    fs::create_hard_link(folder / "history.csv", folder / "other name");
    fs::create_symlink("history.csv", folder / "link");
    for (const std::string name : {"history.csv", "other name", "link"})
      for (const bool force : {false, true})
        {
          expect_parts(refusal({(folder / name).string()}, force),
                       {"The run reads " + (folder / name).string(),
                        "its history.csv",
                        "--output DIR"});
          EXPECT_EQ(read_text(folder / "history.csv"), "a table");
        }
    expect_parts(refusal({(folder / "solution/solution_00000.vtu").string()},
                         true),
                 {"solution_00000.vtu"});
  }

  TEST_F(OutputFolderTest, SecondRunIsRejectedWhileFirstRuns)
  {
    {
      const OutputFolder first(folder, folder_contents, {});
      write("log.txt", "of the first");
      for (const bool force : {false, true})
        expect_parts(refusal({}, force),
                     {"Another run of auxfem",
                      folder.string(),
                      "--output DIR"});
      EXPECT_EQ(read_text(folder / "log.txt"), "of the first");
    }
    EXPECT_EQ(refusal(), "");
  }

  TEST_F(OutputFolderTest, ForeignListIsNotOverwritten)
  {
    write(".auxfem-files", "my own list\n");
    expect_parts(refusal(), {".auxfem-files", "cannot be used"});
    EXPECT_EQ(read_text(folder / ".auxfem-files"), "my own list\n");
  }
} // namespace
