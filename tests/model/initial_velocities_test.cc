#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <sstream>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double velocity_round_off = 1e-13;

  std::string number(const double value)
  {
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
  }

  SceneText group(const std::string &name,
                  const std::string &joints,
                  const std::string &entries)
  {
    return SceneText().add("Initial velocities/" + name,
                           "Joints = " + joints + " | " + entries);
  }

  /** Velocity of a rigid body, here (3, -1) m/s at the origin and 2 rad/s. */
  std::map<unsigned int, double> rigid_in_plane(const double x, const double y)
  {
    return {{0, 3 - 2 * y}, {1, -1 + 2 * x}, {rotation_z, 2.}};
  }

  const std::vector<std::array<double, 2>> positions = {{{0, 0}},
                                                        {{2, 0}},
                                                        {{2, 1.5}},
                                                        {{2, 3.5}}};

  /** Struts and a half circle with a velocity for each joint. */
  SceneText joint_by_joint(const SceneText &further = {})
  {
    SceneText groups;
    for (unsigned int joint = 0; joint < positions.size(); ++joint)
      {
        const auto v = rigid_in_plane(positions[joint][0], positions[joint][1]);
        groups.add(group("v" + std::to_string(joint),
                         std::to_string(joint),
                         "Velocity x = " + number(v.at(0)) +
                           " | Velocity y = " + number(v.at(1)) +
                           " | Angular velocity z = 2"));
      }
    return frame_scene("0 0; 2 0; 2 1.5; 2 3.5",
                       "0 1; 1 2; 2 3 1",
                       groups + further);
  }

  void expect_rigid(const std::string              &scene,
                    const std::vector<std::string> &overrides)
  {
    const EquationsOnRanks setup(scene, overrides);
    const State            state = setup.equations.initial_state();
    const auto             names = name_unknowns(setup.model);
    for (unsigned int i = 0; i < names.size(); ++i)
      EXPECT_NEAR((*state.velocity)[i],
                  rigid_in_plane(names[i].position[0], names[i].position[1])
                    .at(std::get<3>(names[i].name)),
                  10 * velocity_round_off);
  }

  std::string refusal(const std::string              &scene,
                      const std::vector<std::string> &overrides = {})
  {
    return input_error_of(
      [&] { const EquationsOnRanks setup(scene, overrides); });
  }
} // namespace

TEST(InitialVelocities, JointsOfOneMotionMakeStrutsAndArcsMoveWithIt)
{
  expect_rigid(joint_by_joint(),
               {"Discretization/Order=4",
                "Discretization/Global refinements=2"});
}

TEST(InitialVelocities, HingedEndsTurnWithTheChord)
{
  const SceneText hinge =
    SceneText().add("Joints/free", "Joints = 1 | Struts = 0 | Type = hinge");
  expect_rigid(joint_by_joint(hinge), {"Discretization/Order=3"});
}

TEST(InitialVelocities, AStrutBetweenTwoSetsIsBentAsABeam)
{
  // Ends at (0, 0) and (2, 0), the second moves across by 1 m/s and turns by
  // 0.5 rad/s: v = 3 s^2 - 2 s^3 - L s^2 (1 - s) / 2, the spin its slope.
  const EquationsOnRanks setup(
    frame_scene(
      "0 0; 2 0",
      "0 1",
      (group("still", "0", "") +
       group("throw",
             "1",
             "Velocity x = 4 | Velocity y = 1 | Angular velocity z = 0.5"))),
    {"Discretization/Order=4", "Discretization/Global refinements=1"});
  const State state = setup.equations.initial_state();
  const auto  names = name_unknowns(setup.model);
  for (unsigned int i = 0; i < names.size(); ++i)
    {
      const double                         s        = names[i].position[0] / 2;
      const std::map<unsigned int, double> expected = {
        {0, 4 * s},
        {1, 3 * s * s - 2 * s * s * s - s * s * (1 - s)},
        {rotation_z, 3 * s * (1 - s) + 0.5 * s * (3 * s - 2)}};
      EXPECT_NEAR((*state.velocity)[i],
                  expected.at(std::get<3>(names[i].name)),
                  velocity_round_off);
    }
}

TEST(InitialVelocities, RejectVelocitiesThatContradictASupport)
{
  const SceneText clamp = SceneText().support("wall", "0", "clamp");
  expect_parts(
    refusal(frame_scene("0 0; 2 0",
                        "0 1",
                        clamp + (group("fall", "all", "Velocity y = -3")))),
    {"Initial velocities/fall",
     "vertical displacement of joint 0",
     "Supports/wall",
     "starts with 0 m/s, not with -3 m/s",
     "Take the joint out of the set"});
  // Later sets override earlier ones.
  EXPECT_EQ(refusal(frame_scene("0 0; 2 0",
                                "0 1",
                                clamp +
                                  (group("fall", "all", "Velocity y = -3") +
                                   group("held", "0", "")))),
            "");
  // A rotation about the support.
  EXPECT_EQ(
    refusal(frame_scene("0 0; 2 0",
                        "0 1",
                        clamp +
                          (group("turn",
                                 "all",
                                 "Velocity y = 2 | Angular velocity z = 2"))),
            {"Supports/wall/Type=pin"}),
    "");
  const std::string moving = "Supports/wall/Displacement y=-3 * t";
  EXPECT_EQ(refusal(frame_scene("0 0; 2 0",
                                "0 1",
                                clamp +
                                  (group("fall", "all", "Velocity y = -3"))),
                    {"Supports/wall/Type=prescribed", moving}),
            "");
}

TEST(InitialVelocities, RejectAngularVelocitiesWithoutARotation)
{
  const SceneText   bar  = SceneText().rigid_part("bar", "0", 1);
  const std::string spin = "Angular velocity z = 2";
  const std::string one =
    frame_scene("0 0; 2 0; 2 1", "0 1; 1 2", bar + (group("turn", "0", spin)));
  expect_parts(refusal(one, {"Sections/band/Struts=1"}),
               {"Initial velocities/turn/Angular velocity",
                "joint 0 has no rotation of its own",
                "name all its joints"});
  EXPECT_EQ(refusal(one,
                    {"Sections/band/Struts=1",
                     "Initial velocities/turn/Joints=0, 1"}),
            "");
}
