#include <auxfem/output/output_folder.h>
#include <auxfem/parameters/errors.h>

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

  fs::path fresh_folder(const std::string &name)
  {
    const fs::path folder =
      fs::path(AUXFEM_TEST_OUTPUT_DIRECTORY) / ("run_folder_" + name);
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
  }


  /** A scene in @p folder, whose results go to @p output. */
  Scene scene_in(const fs::path &folder, const fs::path &output)
  {
    Scene scene;
    scene.file = folder / "scene.prm";
    std::ofstream(scene.file) << "set Title = as written\n";
    scene.input_files      = {scene.file};
    scene.all_parameters   = "set Title = all\n";
    scene.output.directory = output;
    return scene;
  }
} // namespace

TEST(RunFolder, IsMadeWithParents)
{
  const fs::path folder = fresh_folder("made");
  const fs::path output = folder / "a" / "b";
  RunFolder(scene_in(folder, output), {}).log() << "a line\n";
  EXPECT_EQ(read_text(output / "log.txt"), "a line\n");
  EXPECT_EQ(read_text(output / "original.prm"), "set Title = as written\n");
  EXPECT_EQ(read_text(output / "parameters.prm"), "set Title = all\n");
}

TEST(RunFolder, ForeignFilesWithResultNamesAreRejected)
{
  const fs::path folder = fresh_folder("others");
  for (const std::string name : {"log.txt",
                                 "original.prm",
                                 "parameters.prm",
                                 "history.csv",
                                 "history.units.csv",
                                 "summary.json",
                                 "solution.pvd",
                                 "rigid_parts.pvd",
                                 "connectors.pvd",
                                 "connectors/connectors_00003.1.vtu"})
    {
      const fs::path output = folder / "out";
      fs::remove_all(output);
      fs::create_directories((output / name).parent_path());
      std::ofstream(output / name) << "of another";
      Scene scene = scene_in(folder, output);
      expect_parts(input_error_of([&]() { RunFolder run(scene, {}); }),
                   {name, "auxfem has not written", "--force"});
      EXPECT_EQ(read_text(output / name), "of another");

      RunFolder run(scene, {{}, true});
      EXPECT_EQ(read_text(output / "original.prm"), "set Title = as written\n");
    }
}

TEST(RunFolder, OriginalOfAFormerRunCanBeRunAgain)
{
  const fs::path folder = fresh_folder("again");
  Scene          scene  = scene_in(folder, folder / "out");
  RunFolder      first(scene, {});
  scene.output.directory = folder / "other";
  scene.file             = folder / "out" / "original.prm";
  RunFolder second(scene, {});
  EXPECT_EQ(read_text(folder / "other" / "original.prm"),
            "set Title = as written\n");
}

TEST(RunFolder, OriginalOfAFormerRunCanBeRunIntoItsFolder)
{
  const fs::path folder = fresh_folder("again_in_place");
  Scene          scene  = scene_in(folder, folder / "out");
  for (unsigned int i = 0; i < 3; ++i)
    {
      RunFolder run(scene, {});
      EXPECT_EQ(read_text(folder / "out" / "original.prm"),
                "set Title = as written\n");
      scene.file = folder / "out" / "original.prm";
    }
}

TEST(RunFolder, SceneWithTheNameOfAResultIsKept)
{
  const fs::path folder = fresh_folder("own_scene");
  Scene          scene  = scene_in(folder, folder);
  scene.file            = folder / "log.txt";
  scene.input_files     = {scene.file};
  fs::rename(folder / "scene.prm", scene.file);
  expect_parts(input_error_of([&]() {
                 RunFolder run(scene, {{}, true});
               }),
               {"The run reads", "log.txt"});
  EXPECT_EQ(read_text(scene.file), "set Title = as written\n");
}

TEST(RunFolder, SceneFromMemoryHasNoOriginal)
{
  const fs::path folder = fresh_folder("memory");
  Scene          scene;
  scene.file             = "a name";
  scene.output.directory = folder;
  RunFolder run(scene, {});
  EXPECT_FALSE(fs::exists(folder / "original.prm"));
}

TEST(RunFolder, UncreatableFolderIsRejected)
{
  const fs::path folder = fresh_folder("refused");
  // A file in place of the folder stops any user, also root.
  for (const fs::path &output :
       {folder / "scene.prm", folder / "scene.prm" / "below"})
    expect_parts(
      input_error_of([&]() { RunFolder run(scene_in(folder, output), {}); }),
      {output.string(), "Not a directory", "--output DIR", "Output/Directory"});
}

TEST(RunFolder, UnwritableLogIsRejected)
{
  const fs::path folder = fresh_folder("no_log");
  fs::create_directories(folder / "out" / "log.txt");
  Scene scene = scene_in(folder, folder / "out");
  expect_parts(input_error_of([&]() {
                 RunFolder run(scene, {{}, true});
               }),
               {"log.txt", "Is a directory"});
}

TEST(RunFolder, FileIsReplacedAtomically)
{
  const fs::path folder = fresh_folder("replace");
  replace_file(folder / "summary.json", "old");
  replace_file(folder / "summary.json", "new");
  EXPECT_EQ(read_text(folder / "summary.json"), "new");
  EXPECT_FALSE(fs::exists(folder / "summary.json.part"));
  EXPECT_THROW(replace_file(folder / "none" / "summary.json", "x"),
               ComputationError);
}
