#include <auxfem/output/run_folder.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

using namespace auxfem;

namespace
{
  namespace fs = std::filesystem;

  fs::path fresh_folder(const std::string &name)
  {
    const fs::path folder =
      fs::path(AUXFEM_TEST_OUTPUT_DIRECTORY) / ("run_folder_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
  }

  std::string contents(const fs::path &file)
  {
    std::ifstream      stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  Scene scene_in(const fs::path &folder)
  {
    Scene scene;
    scene.file = folder / "scene.prm";
    std::ofstream(scene.file) << "set Title = as written\n";
    scene.all_parameters = "set Title = all\n";
    return scene;
  }
} // namespace

TEST(RunFolder, IsMadeWithParents)
{
  const fs::path folder = fresh_folder("made");
  const Scene    scene  = scene_in(folder);
  const fs::path output = folder / "a" / "b";

  open_run_folder(scene, output) << "a line\n";
  EXPECT_EQ(contents(output / "log.txt"), "a line\n");
  EXPECT_EQ(contents(output / "original.prm"), "set Title = as written\n");
  EXPECT_EQ(contents(output / "parameters.prm"), "set Title = all\n");
}

TEST(RunFolder, FormerResultsGoAndTheUsersFilesStay)
{
  const fs::path folder = fresh_folder("former");
  const Scene    scene  = scene_in(folder);
  for (const char *name : {"solution", "connectors"})
    fs::create_directories(folder / name);
  const std::vector<std::string> former = {"history.csv",
                                           "history.units.csv",
                                           "summary.json",
                                           "solution.pvd",
                                           "connectors.pvd",
                                           "solution/solution_00000.pvtu",
                                           "solution/solution_00000.0.vtu",
                                           "connectors/connectors_00003.1.vtu"};
  const std::vector<std::string> own    = {"notes.txt",
                                           "solution/picture.png",
                                           "solution/mine.vtu"};
  for (const std::string &name : former)
    std::ofstream(folder / name) << "x";
  for (const std::string &name : own)
    std::ofstream(folder / name) << "x";

  open_run_folder(scene, folder);
  for (const std::string &name : former)
    EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const std::string &name : own)
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "connectors"));
}

TEST(RunFolder, OriginalOfAFormerRunCanBeRunAgain)
{
  const fs::path folder = fresh_folder("again");
  Scene          scene  = scene_in(folder);
  scene.file            = folder / "original.prm";
  std::ofstream(scene.file) << "set Title = former\n";
  open_run_folder(scene, folder);
  EXPECT_EQ(contents(scene.file), "set Title = former\n");
}

TEST(RunFolder, SceneFromMemoryHasNoOriginal)
{
  const fs::path folder = fresh_folder("memory");
  Scene          scene;
  scene.file = "a name";
  open_run_folder(scene, folder);
  EXPECT_FALSE(fs::exists(folder / "original.prm"));
}

TEST(RunFolder, FolderThatCannotBeMadeIsRefused)
{
  const fs::path folder = fresh_folder("refused");
  const Scene    scene  = scene_in(folder);
  // A file where the folder should be stops any user, root as well.
  for (const fs::path &output :
       {fs::path(scene.file), fs::path(scene.file) / "below"})
    try
      {
        open_run_folder(scene, output);
        FAIL();
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        EXPECT_NE(message.find(output.string()), std::string::npos);
        EXPECT_NE(message.find("Not a directory"), std::string::npos)
          << message;
        EXPECT_NE(message.find("--output DIR"), std::string::npos);
        EXPECT_NE(message.find("Output/Directory"), std::string::npos);
      }
}

TEST(RunFolder, LogThatCannotBeWrittenIsRefused)
{
  const fs::path folder = fresh_folder("no_log");
  const Scene    scene  = scene_in(folder);
  fs::create_directories(folder / "log.txt");
  try
    {
      open_run_folder(scene, folder);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("log.txt"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("Is a directory"),
                std::string::npos);
    }
}

TEST(RunFolder, FileIsReplacedInOneMove)
{
  const fs::path folder = fresh_folder("replace");
  replace_file(folder / "summary.json", "old");
  replace_file(folder / "summary.json", "new");
  EXPECT_EQ(contents(folder / "summary.json"), "new");
  EXPECT_FALSE(fs::exists(folder / "summary.json.part"));
  EXPECT_THROW(replace_file(folder / "none" / "summary.json", "x"),
               ComputationError);
}
