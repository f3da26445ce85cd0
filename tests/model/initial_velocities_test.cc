#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

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

  std::string group(const std::string &name,
                    const std::string &joints,
                    const std::string &entries)
  {
    return "  subsection " + name + "\n    set Joints = " + joints + "\n" +
      entries + "  end\n";
  }

  std::string velocities(const std::string &groups)
  {
    return "subsection Initial velocities\n" + groups + "end\n";
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

  /** Struts and a half circle, of which each joint is given its velocity. */
  std::string joint_by_joint(const std::string &further = "")
  {
    std::string groups;
    for (unsigned int joint = 0; joint < positions.size(); ++joint)
      {
        const auto v = rigid_in_plane(positions[joint][0], positions[joint][1]);
        groups += group("v" + std::to_string(joint),
                        std::to_string(joint),
                        "    set Velocity x = " + number(v.at(0)) +
                          "\n    set Velocity y = " + number(v.at(1)) +
                          "\n    set Angular velocity z = 2\n");
      }
    return frame_scene("0 0; 2 0; 2 1.5; 2 3.5",
                       "0 1; 1 2; 2 3 1",
                       velocities(groups) + further);
  }

  void expect_rigid(const std::string              &scene,
                    const std::vector<std::string> &overrides)
  {
    const EquationsOnRanks of_scene(scene, overrides);
    const State            state = of_scene.equations.initial_state();
    const auto             names = name_unknowns(of_scene.model);
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
      [&] { const EquationsOnRanks of_scene(scene, overrides); });
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
  const std::string hinge = "subsection Joints\n  subsection free\n"
                            "    set Joints = 1\n    set Struts = 0\n"
                            "    set Type = hinge\n  end\nend\n";
  expect_rigid(joint_by_joint(hinge), {"Discretization/Order=3"});
}

TEST(InitialVelocities, AStrutBetweenTwoSetsIsBentAsABeam)
{
  // Ends at (0, 0) and (2, 0), the second moves across by 1 m/s and turns by
  // 0.5 rad/s: v = 3 s^2 - 2 s^3 - L s^2 (1 - s) / 2, the spin its slope.
  const EquationsOnRanks of_scene(
    frame_scene("0 0; 2 0",
                "0 1",
                velocities(group("still", "0", "") +
                           group("throw",
                                 "1",
                                 "    set Velocity x = 4\n"
                                 "    set Velocity y = 1\n"
                                 "    set Angular velocity z = 0.5\n"))),
    {"Discretization/Order=4", "Discretization/Global refinements=1"});
  const State state = of_scene.equations.initial_state();
  const auto  names = name_unknowns(of_scene.model);
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

TEST(InitialVelocities, RefuseWhatASupportDoesNotAllow)
{
  const std::string clamp = "subsection Supports\n  subsection wall\n"
                            "    set Joints = 0\n    set Type = clamp\n"
                            "  end\nend\n";
  expect_parts(
    refusal(frame_scene(
      "0 0; 2 0",
      "0 1",
      clamp + velocities(group("fall", "all", "    set Velocity y = -3\n")))),
    {"Initial velocities/fall",
     "vertical displacement of joint 0",
     "Supports/wall",
     "starts with 0 m/s, not with -3 m/s",
     "Take the joint out of the set"});
  // What a later set says counts.
  EXPECT_EQ(refusal(frame_scene(
              "0 0; 2 0",
              "0 1",
              clamp +
                velocities(group("fall", "all", "    set Velocity y = -3\n") +
                           group("held", "0", "")))),
            "");
  // A rotation about the support.
  EXPECT_EQ(refusal(frame_scene("0 0; 2 0",
                                "0 1",
                                clamp +
                                  velocities(
                                    group("turn",
                                          "all",
                                          "    set Velocity y = 2\n"
                                          "    set Angular velocity z = 2\n"))),
                    {"Supports/wall/Type=pin"}),
            "");
  const std::string moving = "Supports/wall/Displacement y=-3 * t";
  EXPECT_EQ(
    refusal(frame_scene("0 0; 2 0",
                        "0 1",
                        clamp +
                          velocities(
                            group("fall", "all", "    set Velocity y = -3\n"))),
            {"Supports/wall/Type=prescribed", moving}),
    "");
}

TEST(InitialVelocities, RefuseToTurnWhatHasNoRotation)
{
  const std::string bar  = "subsection Rigid parts\n  subsection bar\n"
                           "    set Struts = 0\n    set Mass = 1\n"
                           "  end\nend\n",
                    spin = "    set Angular velocity z = 2\n";
  const std::string one =
    frame_scene("0 0; 2 0; 2 1",
                "0 1; 1 2",
                bar + velocities(group("turn", "0", spin)));
  expect_parts(refusal(one, {"Sections/band/Struts=1"}),
               {"Initial velocities/turn/Angular velocity",
                "joint 0 has no rotation of its own",
                "name all its joints"});
  EXPECT_EQ(refusal(one,
                    {"Sections/band/Struts=1",
                     "Initial velocities/turn/Joints=0, 1"}),
            "");
}
