#include <auxfem/model/build_lattice.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText crossing_frame(const std::string &joints, const std::string &struts)
  {
    return SceneText()
      .frame(joints, struts)
      .rectangle("bar", 0.01, 0.01, {1, 1});
  }

  /** The message of a refusal; empty if the lattice is built. */
  std::string refusal(const SceneText &scene)
  {
    try
      {
        build_lattice(read_scene_from_text(scene.str(), "test.prm"));
        return "";
      }
    catch (const InputError &error)
      {
        return error.what();
      }
  }
} // namespace

TEST(StrutCrossings, RefuseStrutsThatMeetWithoutJoint)
{
  for (const auto &[joints, struts, place] :
       std::vector<std::array<std::string, 3>>{
         // Across, one ends on the other, one upon the other.
         {"0 0; 1 1; 0 1; 1 0", "0 1; 2 3", "(0.5, 0.5)"},
         {"0 0; 1 0; 0.25 0; 0.25 1", "0 1; 2 3", "(0.25, 0)"},
         {"0 0; 1 0; 0.5 0", "0 1; 0 2", "(0.5, 0)"}})
    {
      const SceneText scene = crossing_frame(joints, struts);
      EXPECT_TRUE(contains(refusal(scene), "struts 0 and 1 meet at " + place))
        << refusal(scene);
      EXPECT_EQ(refusal(
                  SceneText(scene).set("Lattice/Struts may cross", "true")),
                "");
    }
}

TEST(StrutCrossings, AllowWhatOnlyComesNear)
{
  // At a common joint, at joints of equal position, parallel, one above the
  // other in space.
  for (const auto &[joints, struts] : std::vector<std::array<std::string, 2>>{
         {"0 0; 1 0; 1 1e-3", "0 1; 0 2"},
         {"0 0; 1 0; 1 0; 1 1", "0 1; 2 3"},
         {"0 0; 1 0; 0 1e-3; 1 1e-3", "0 1; 2 3"}})
    EXPECT_EQ(refusal(crossing_frame(joints, struts)), "");
  EXPECT_EQ(refusal(
              crossing_frame("0 0 0; 1 1 0; 0 1 1e-3; 1 0 1e-3", "0 1; 2 3")
                .dimension(3)),
            "");
  EXPECT_TRUE(contains(
    refusal(
      crossing_frame("0 0 0; 1 1 0; 0 1 0; 1 0 0", "0 1; 2 3").dimension(3)),
    "meet at (0.5, 0.5, 0)"));
}

TEST(StrutCrossings, RigidRodsMaySlideAlongStruts)
{
  EXPECT_EQ(refusal(crossing_frame("0 0; 1 0; 0.5 0; 1.5 0", "0 1; 2 3")
                      .set("Rigid parts/rod/Struts", "1")),
            "");
}
