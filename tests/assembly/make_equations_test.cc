#include <equations/space_effect.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two struts in line, joints 0, 1, 2 at x = 0, 1, 2. */
  SceneText two_struts_with(const SceneText &further = {})
  {
    return frame_scene("0 0; 1 0; 2 0", "0 1; 1 2", further);
  }

  std::string equations_refusal(const SceneText &further)
  {
    return input_error_of(
      [&] { EquationsOnRanks(two_struts_with(further), {}, MPI_COMM_SELF); });
  }

  const SceneText hinge_in_the_middle = SceneText().hinge("middle", "1");
} // namespace

TEST(MakeEquations, TwoSupportsMayHoldTheSameJointAtRest)
{
  const EquationsOnRanks setup(two_struts_with()
                                 .support("wall", "0", "clamp")
                                 .support("floor", "0, 2", "roller x"),
                               {},
                               MPI_COMM_SELF);
  ASSERT_EQ(setup.model.supports.size(), 2u);
  EXPECT_EQ(setup.model.supports[0].name, "wall");
  // The reaction is counted once, with the first.
  EXPECT_EQ(setup.model.supports[0].unknowns.size(), 3u);
  ASSERT_EQ(setup.model.supports[1].unknowns.size(), 1u);
  EXPECT_EQ(setup.model.supports[1].unknowns[0].component, 1u);
  EXPECT_EQ(setup.model.supports[1].unknowns[0].unknown,
            setup.dofs().joint_unknown(2, 1));
  EXPECT_EQ(setup.dofs().unknowns().n_free(),
            setup.dofs().layout().n_global() - 4);
}

TEST(MakeEquations, ContradictingSupportsAreRefusedByName)
{
  const std::string message = equations_refusal(
    SceneText()
      .support("wall", "0", "clamp")
      .add("Supports/shaker",
           "Joints = 0 | Type = prescribed | Displacement y = 0.1 * t"));
  EXPECT_TRUE(contains(message, "Supports/shaker")) << message;
  EXPECT_TRUE(contains(message, "Supports/wall")) << message;
  EXPECT_TRUE(contains(message, "vertical displacement of joint 0")) << message;
}

TEST(MakeEquations, TwoMotionsOfOneJointAreRefused)
{
  const std::string message = equations_refusal(
    SceneText()
      .add("Supports/first",
           "Joints = 2 | Type = prescribed | Rotation z = 0.1 * t")
      .add("Supports/second",
           "Joints = 2 | Type = prescribed | Rotation z = 0.1 * t"));
  EXPECT_TRUE(contains(message, "rotation of joint 2")) << message;
}

TEST(MakeEquations, AMomentOnAHingeIsRefused)
{
  const std::string message =
    equations_refusal(SceneText(hinge_in_the_middle)
                        .add("Loads/twist", "Joints = 1 | Moment z = 2"));
  EXPECT_TRUE(contains(message, "Loads/twist/Moment z: joint 1")) << message;
}

TEST(MakeEquations, AForceOnAHingeIsNot)
{
  EXPECT_EQ(equations_refusal(SceneText(hinge_in_the_middle)
                                .add("Loads/push", "Joints = 1 | Force y = 2")),
            "");
}

TEST(MakeEquations, ARotationPrescribedAtAHingeIsRefusedUnlessItIsZero)
{
  const auto turned_by = [](const std::string &angle) {
    return SceneText(hinge_in_the_middle)
      .add("Supports/drive",
           "Joints = 1 | Type = prescribed | Rotation z = " + angle);
  };
  const std::string message = equations_refusal(turned_by("0.1 * t"));
  EXPECT_TRUE(contains(message, "Supports/drive/Rotation z: joint 1"))
    << message;
  EXPECT_EQ(equations_refusal(turned_by("0")), "");
}

TEST(MakeEquations, AHingeAtWhichNoneOfTheStrutsEndsIsRefused)
{
  const std::string message =
    equations_refusal(SceneText().hinge("middle", "0, 1", "1"));
  EXPECT_TRUE(contains(message, "Joints/middle")) << message;
  EXPECT_TRUE(contains(message, "joint 0")) << message;
}

TEST(MakeEquations, HingesAddRotationsAndCanBeSwitchedOff)
{
  const EquationsOnRanks rigid(two_struts_with(), {}, MPI_COMM_SELF),
    hinged(two_struts_with(hinge_in_the_middle), {}, MPI_COMM_SELF),
    off(two_struts_with(hinge_in_the_middle),
        {"Effects/Hinges=off"},
        MPI_COMM_SELF);
  EXPECT_EQ(hinged.dofs().layout().n_global(),
            rigid.dofs().layout().n_global() + 1);
  EXPECT_FALSE(hinged.dofs().joint_has(1, rotation_z));
  EXPECT_EQ(off.dofs().layout().n_global(), rigid.dofs().layout().n_global());
}

TEST(MakeEquations, ASpringActsBetweenTheReleasedStrutAndTheJoint)
{
  // Strut 1 released against strut 0, or both: the same relative rotation.
  for (const std::string struts : {"1", "all"})
    {
      EquationsOnRanks setup(
        two_struts_with().add("Joints/middle",
                              "Joints = 1 | Struts = " + struts +
                                " | Type = rotational spring | "
                                "Stiffness = 7"),
        {"Time/Scheme=static"},
        MPI_COMM_SELF);
      State from = setup.equations.initial_state(), to = from;
      // Strut 1 rotates rigidly by a tiny angle, so it has no forces.
      const double angle = 1e-9;
      const auto   names = name_unknowns(setup.model);
      for (unsigned int i = 0; i < names.size(); ++i)
        {
          const unsigned int c = std::get<3>(names[i].name);
          if (c == 1)
            to.displacement[i] = angle * std::max(0., names[i].position[0] - 1);
          if (c == rotation_z && names[i].position[0] > 1)
            to.displacement[i] = angle;
        }
      to.displacement[setup.dofs().end_rotation(1, 0)] = angle;
      const Evaluation step = setup.step(from, to, 1.);
      setup.residual(step);
      // The square of the rotation causes strains of 1e-18.
      EXPECT_NEAR(to.residual[setup.dofs().end_rotation(1, 0)],
                  7 * angle,
                  1e-6 * angle);
      EXPECT_NEAR(to.residual[setup.dofs().end_rotation(0, 1)],
                  -7 * angle,
                  1e-6 * angle);
      setup.accept(step);
      EXPECT_NEAR(to.energies.strain(),
                  3.5 * angle * angle,
                  1e-6 * angle * angle);
    }
}

TEST(MakeEquations, AReferenceVectorAlongAStrutIsRefused)
{
  const auto scene = [](const std::string &reference) {
    return frame_scene("0 0 0; 1 0 0; 1 2 0", "0 1; 1 2 0.5")
      .dimension(3)
      .circle("blade", 0.1, {1, 1})
      .add("Sections/blade", "Struts = 1 | Reference vector = " + reference);
  };
  // Arc 1 is parallel to y in its middle.
  expect_parts(input_error_of([&] {
                 EquationsOnRanks(scene("0 1 0.05"), {}, MPI_COMM_SELF);
               }),
               {"Sections/blade/Reference vector",
                "strut 1",
                "joints 1 - 2",
                "5 degrees"});
  EXPECT_NO_THROW(EquationsOnRanks(scene("0 0.3 1"), {}, MPI_COMM_SELF));
}

TEST(MakeEquations, RungeKuttaStepsWithRigidPartsFollowNoError)
{
  const SceneText esdirk = SceneText()
                             .set("Time/Scheme", "esdirk")
                             .set("Time/Relative tolerance", "1e-3");
  EXPECT_NO_THROW(EquationsOnRanks(two_struts_with(esdirk), {}, MPI_COMM_SELF));
  EXPECT_EQ(
    equations_refusal(SceneText(esdirk).rigid_part("bar", "1", 0.5)),
    "Time/Relative tolerance: Time/Scheme = esdirk has no error estimate "
    "with rigid parts or revolute hinges. Set it to none, or choose newmark, "
    "hht or generalized-alpha.");
}
