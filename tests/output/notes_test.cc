#include <auxfem/output/notes.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::vector<std::string> notes_of(const std::string &height)
  {
    const EquationsOnRanks of_scene(
      SceneText()
        .frame("0 0; 1 0; 1 0.02", "0 1; 1 2")
        .rectangle("strip", "5 mm", height, {1e9, 1}),
      {},
      MPI_COMM_SELF);
    return notes_on(of_scene.scene, of_scene.equations);
  }
} // namespace

TEST(Notes, AskAboutSectionsThickForTheirStruts)
{
  EXPECT_TRUE(notes_of("4.9 mm").empty());
  const std::vector<std::string> metres = notes_of("1");
  ASSERT_EQ(metres.size(), 1u);
  expect_parts(metres[0],
               {"Sections/strip",
                "about 1 m thick",
                "strut 1 is only 0.02 m long",
                "was 1 mm meant?"});
  const std::vector<std::string> stout = notes_of("6 mm");
  ASSERT_EQ(stout.size(), 1u);
  expect_parts(stout[0], {"0.006 m thick"});
}

TEST(Notes, TellOfParametersOfAnotherScheme)
{
  const auto notes_with = [](const std::string &scheme) {
    const EquationsOnRanks of_scene(SceneText()
                                      .frame("0 0; 1 0", "0 1")
                                      .rectangle("strip", 0.01, 0.01, {1e9, 1})
                                      .add("Time", "Scheme = " + scheme)
                                      .set("Time/Order of esdirk", 5),
                                    {},
                                    MPI_COMM_SELF);
    return notes_on(of_scene.scene, of_scene.equations);
  };
  const std::vector<std::string> notes = notes_with("newmark");
  ASSERT_EQ(notes.size(), 1u);
  expect_parts(notes[0],
               {"Time/Order of esdirk = 5 has no effect",
                "Scheme = esdirk",
                "Time/Scheme is newmark"});
  EXPECT_TRUE(notes_with("esdirk").empty());
}

TEST(Notes, NameStrutsThatOverlapAtRest)
{
  const auto notes_with = [](const std::string &joints,
                             const std::string &contact) {
    const EquationsOnRanks of_scene(SceneText()
                                      .frame(joints, "0 1; 2 3")
                                      .rectangle("strip", 0.02, 0.02, {1e9, 1})
                                      .set("Effects/Contact", contact),
                                    {},
                                    MPI_COMM_SELF);
    return notes_on(of_scene.scene, of_scene.equations);
  };
  const std::string crossing                 = "0 0; 1 0; 0.3 -0.5; 0.3 0.5",
                    beside                   = "0 0; 1 0; 0 0.015; 1 0.015",
                    apart                    = "0 0; 1 0; 0 0.021; 1 0.021";
  const std::vector<std::string> of_crossing = notes_with(crossing, "auto"),
                                 of_beside   = notes_with(beside, "auto");
  ASSERT_EQ(of_crossing.size(), 1u);
  expect_parts(of_crossing[0],
               {"0 and 1 cross at rest", "pass each other freely"});
  ASSERT_EQ(of_beside.size(), 1u);
  expect_parts(of_beside[0], {"0 and 1 overlap at rest", "do not touch"});
  EXPECT_TRUE(notes_with(apart, "auto").empty());
  EXPECT_TRUE(notes_with(crossing, "off").empty());
}
