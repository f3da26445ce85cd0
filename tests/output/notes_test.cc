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
