#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Message for a cantilever whose tip hangs on a connector to the ground. */
  std::string message_of_link(const std::string &connector,
                              const SceneText   &more = {})
  {
    const SceneText text =
      SceneText()
        .frame("0 0; 1 0", "0 1")
        .circle("beam", 0.01, {1e9, 1000})
        .support("wall", "0", "clamp")
        .add("Connectors/link",
             "Between = ground: 1 | Ground offset = 0 -1 | " + connector)
        .time(1, 0.1, "newmark")
        .add(more);
    return input_error_of([&] { read_scene_from_text(text, "scene.prm", {}); });
  }

  const std::string linear_link = "Law = spring | Spring stiffness = 3";
  const std::string friction_link =
    "Law = friction-slider | Spring stiffness = 3 | Slip force = 1";
} // namespace

TEST(ConnectorMistakes, SoundConnectorsHaveNone)
{
  for (const std::string &sound :
       {linear_link + " | Free length = 0.9",
        linear_link +
          " | Preload = -2 | Failure force = 3 | Failure extension = 1",
        friction_link + " | Preload = 0.5",
        std::string("Law = gap | Spring stiffness = 3 | Preload = -1")})
    EXPECT_EQ(message_of_link(sound), "") << sound;
}

TEST(ConnectorMistakes, FreeLengthAndPreload)
{
  expect_parts(message_of_link(linear_link +
                               " | Free length = 0.9 | Preload = 2"),
               {"Connectors/link", "Free length and Preload", "Remove one"});
  expect_parts(message_of_link(linear_link +
                               " | Free length = 0.9 | "
                               "Geometry = direction | Direction = 0 1"),
               {"Connectors/link/Free length", "0.9", "Preload"});
}

TEST(ConnectorMistakes, PreloadThatTheLawCannotHave)
{
  for (const std::string &law :
       {std::string("Law = dashpot | Damping coefficient = 3"),
        std::string("Law = gap | Spring stiffness = 3"),
        friction_link})
    expect_parts(message_of_link(law + " | Preload = 2"),
                 {"Connectors/link/Preload", "2", "Choose a Law"});
}

TEST(ConnectorMistakes, FrictionAndFailureWithSchemesThatForgetThem)
{
  for (const std::string &connector :
       {friction_link, linear_link + " | Failure force = 2"})
    {
      expect_parts(message_of_link(connector,
                                   SceneText().set("Time/Scheme", "esdirk")),
                   {"Connectors/link", "esdirk", "Choose newmark"});
      expect_parts(message_of_link(connector,
                                   SceneText().set("Analysis", "static path")),
                   {"Connectors/link", "static path", "Scheme = static"});
    }
}

TEST(ConnectorMistakes, RotationalLaws)
{
  const std::string hinge = "Joints = 0 | Type = rotational ";
  const auto        joint = [&](const std::string &entries) {
    return message_of_link(linear_link,
                           SceneText().add("Joints/knee", hinge + entries));
  };
  EXPECT_EQ(joint("gap | Spring stiffness = 3 N m/deg | Gap = 5 deg"), "");
  expect_parts(joint("gap | Spring stiffness = 3 N/m"),
               {"Joints/knee/Spring stiffness", "N m/rad"});
  expect_parts(joint("tabulated | Rotations = 0, 0 | Moments = 0, 1"),
               {"Joints/knee/Rotations", "must rise"});
  expect_parts(message_of_link(linear_link,
                               SceneText().add("Joints/link",
                                               hinge +
                                                 "gap | Spring stiffness = 3")),
               {"Connectors/link", "Joints/link", "same name"});
}
