#include <auxfem/output/notes.h>
#include <auxfem/output/verdict.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <filesystem>
#include <fstream>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::vector<std::string> notes_on_scene(const SceneText &scene)
  {
    const EquationsOnRanks scene_equations(scene, {}, MPI_COMM_SELF);
    return notes_on(scene_equations.equations);
  }

  /** A clamped strut whose free end has a support of @p type. */
  SceneText strut_with(const std::string &type, const std::string &load)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("strip", 0.01, 0.01, {1e9, 1})
      .add("Supports/foot", "Joints = 0")
      .add("Supports/tip", "Joints = 1 | Type = " + type)
      .add("Loads/push", "Joints = 1 | " + load);
  }

  std::vector<std::string> notes_of(const std::string &height)
  {
    const EquationsOnRanks scene_equations(
      SceneText()
        .frame("0 0; 1 0; 1 0.02", "0 1; 1 2")
        .rectangle("strip", "5 mm", height, {1e9, 1}),
      {},
      MPI_COMM_SELF);
    return notes_on(scene_equations.equations);
  }
} // namespace

TEST(Notes, WarnAboutThickSections)
{
  EXPECT_TRUE(notes_of("4.9 mm").empty());
  const std::vector<std::string> metres = notes_of("1");
  ASSERT_EQ(metres.size(), 1u);
  expect_parts(metres[0],
               {"Sections/strip",
                "strut 1 is about 1 m thick, but only 0.02 m long",
                "if you meant 1 mm, add the unit"});
  const std::vector<std::string> stout = notes_of("6 mm");
  ASSERT_EQ(stout.size(), 1u);
  expect_parts(stout[0], {"0.006 m thick"});
}

TEST(Notes, ReportParametersOfOtherSchemes)
{
  const auto notes_with = [](const std::string &scheme) {
    const EquationsOnRanks scene_equations(
      SceneText()
        .frame("0 0; 1 0", "0 1")
        .rectangle("strip", 0.01, 0.01, {1e9, 1})
        .add("Time", "Scheme = " + scheme)
        .set("Time/Order of esdirk", 5),
      {},
      MPI_COMM_SELF);
    return notes_on(scene_equations.equations);
  };
  const std::vector<std::string> notes = notes_with("newmark");
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Time/Order of esdirk = 5 has no effect",
                "Scheme = esdirk",
                "Time/Scheme is newmark"});
  EXPECT_TRUE(notes_with("esdirk").empty());
}

TEST(Notes, ReportStrutsThatOverlapAtRest)
{
  const auto notes_with = [](const std::string &joints,
                             const std::string &contact) {
    const EquationsOnRanks scene_equations(
      SceneText()
        .frame(joints, "0 1; 2 3")
        .rectangle("strip", 0.02, 0.02, {1e9, 1})
        .set("Effects/Contact", contact),
      {},
      MPI_COMM_SELF);
    return notes_on(scene_equations.equations);
  };
  const std::string within                    = "0 0; 1 0; 0 0.005; 1 0.005",
                    beside                    = "0 0; 1 0; 0 0.015; 1 0.015",
                    apart                     = "0 0; 1 0; 0 0.021; 1 0.021";
  const std::vector<std::string> within_notes = notes_with(within, "auto"),
                                 beside_notes = notes_with(beside, "auto");
  ASSERT_EQ(within_notes.size(), 1u);
  expect_parts(within_notes[0],
               {"0 and 1 lie in each other at rest", "pass each other freely"});
  ASSERT_EQ(beside_notes.size(), 1u);
  expect_parts(beside_notes[0],
               {"0 and 1 overlap at rest", "no contact forces"});
  EXPECT_TRUE(notes_with(apart, "auto").empty());
  EXPECT_TRUE(notes_with(within, "off").empty());
}

TEST(Notes, ReportLoadsWithoutEffect)
{
  const std::vector<std::string> notes =
    notes_on_scene(strut_with("roller x", "Force x = 1 | Force y = t"));
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Loads/push/Force y: 't'",
                "does nothing",
                "vertical displacement",
                "reactions"});
  EXPECT_EQ(notes_on_scene(strut_with("clamp", "Moment z = 1")).size(), 1u);
  EXPECT_TRUE(notes_on_scene(strut_with("pin", "Moment z = 1")).empty());
}

TEST(Notes, NameInputFilesInTheFolderOfTheResults)
{
  namespace fs             = std::filesystem;
  const std::string folder = testing::TempDir() + "scenes";
  fs::create_directories(folder);
  for (const char *file : {"parameters.prm", "original.prm", "data.csv"})
    std::ofstream(folder + "/" + file);
  const SceneText scene =
    strut_with("roller x", "Force x = 1").set("Output/Directory", folder);
  EXPECT_TRUE(notes_on_scene(scene).empty());
  std::ofstream(folder + "/bridge.prm");
  const std::vector<std::string> notes = notes_on_scene(scene);
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0], {"among input files", folder, "bridge.prm"});
  fs::remove_all(folder);
}
