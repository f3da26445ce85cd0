#include <equations/effects/space_effect.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two struts in line, joints 0, 1, 2 at x = 0, 1, 2, with @p further text. */
  std::string two_struts_with(const std::string &further)
  {
    return frame_scene("0 0; 1 0; 2 0", "0 1; 1 2", further);
  }

  std::string equations_refusal(const std::string &further)
  {
    return input_error_of(
      [&] { EquationsOnRanks(two_struts_with(further), {}, MPI_COMM_SELF); });
  }

  const std::string hinge_in_the_middle = "subsection Joints\n"
                                          "  subsection middle\n"
                                          "    set Joints = 1\n"
                                          "  end\n"
                                          "end\n";
} // namespace

TEST(MakeEquations, TwoSupportsMayHoldTheSameJointAtRest)
{
  const EquationsOnRanks of_scene(two_struts_with("subsection Supports\n"
                                                  "  subsection wall\n"
                                                  "    set Joints = 0\n"
                                                  "    set Type = clamp\n"
                                                  "  end\n"
                                                  "  subsection floor\n"
                                                  "    set Joints = 0, 2\n"
                                                  "    set Type = roller x\n"
                                                  "  end\n"
                                                  "end\n"),
                                  {},
                                  MPI_COMM_SELF);
  ASSERT_EQ(of_scene.model.supports.size(), 2u);
  EXPECT_EQ(of_scene.model.supports[0].name, "wall");
  // The reaction is counted once, with the first.
  EXPECT_EQ(of_scene.model.supports[0].unknowns.size(), 3u);
  ASSERT_EQ(of_scene.model.supports[1].unknowns.size(), 1u);
  EXPECT_EQ(of_scene.model.supports[1].unknowns[0].component, 1u);
  EXPECT_EQ(of_scene.model.supports[1].unknowns[0].unknown,
            of_scene.dofs().joint_unknown(2, 1));
  EXPECT_EQ(of_scene.dofs().unknowns().n_free(),
            of_scene.dofs().layout().n_global() - 4);
}

TEST(MakeEquations, ContradictingSupportsAreRefusedByName)
{
  const std::string message =
    equations_refusal("subsection Supports\n"
                      "  subsection wall\n"
                      "    set Joints = 0\n"
                      "    set Type = clamp\n"
                      "  end\n"
                      "  subsection shaker\n"
                      "    set Joints = 0\n"
                      "    set Type = prescribed\n"
                      "    set Displacement y = 0.1 * t\n"
                      "  end\n"
                      "end\n");
  EXPECT_TRUE(contains(message, "Supports/shaker")) << message;
  EXPECT_TRUE(contains(message, "Supports/wall")) << message;
  EXPECT_TRUE(contains(message, "vertical displacement of joint 0")) << message;
}

TEST(MakeEquations, TwoMotionsOfOneJointAreRefused)
{
  const std::string message = equations_refusal("subsection Supports\n"
                                                "  subsection first\n"
                                                "    set Joints = 2\n"
                                                "    set Type = prescribed\n"
                                                "    set Rotation z = 0.1 * t\n"
                                                "  end\n"
                                                "  subsection second\n"
                                                "    set Joints = 2\n"
                                                "    set Type = prescribed\n"
                                                "    set Rotation z = 0.1 * t\n"
                                                "  end\n"
                                                "end\n");
  EXPECT_TRUE(contains(message, "rotation of joint 2")) << message;
}

TEST(MakeEquations, AMomentOnAHingeIsRefused)
{
  const std::string message = equations_refusal(hinge_in_the_middle +
                                                "subsection Loads\n"
                                                "  subsection twist\n"
                                                "    set Joints = 1\n"
                                                "    set Moment z = 2\n"
                                                "  end\n"
                                                "end\n");
  EXPECT_TRUE(contains(message, "Loads/twist/Moment z: joint 1")) << message;
}

TEST(MakeEquations, AForceOnAHingeIsNot)
{
  EXPECT_EQ(equations_refusal(hinge_in_the_middle +
                              "subsection Loads\n"
                              "  subsection push\n"
                              "    set Joints = 1\n"
                              "    set Force y = 2\n"
                              "  end\n"
                              "end\n"),
            "");
}

TEST(MakeEquations, ARotationPrescribedAtAHingeIsRefusedUnlessItIsZero)
{
  const auto turned_by = [](const std::string &angle) {
    return hinge_in_the_middle +
      "subsection Supports\n"
      "  subsection drive\n"
      "    set Joints = 1\n"
      "    set Type = prescribed\n"
      "    set Rotation z = " +
      angle + "\n  end\nend\n";
  };
  const std::string message = equations_refusal(turned_by("0.1 * t"));
  EXPECT_TRUE(contains(message, "Supports/drive/Rotation z: joint 1"))
    << message;
  EXPECT_EQ(equations_refusal(turned_by("0")), "");
}

TEST(MakeEquations, AHingeAtWhichNoneOfTheStrutsEndsIsRefused)
{
  const std::string message = equations_refusal("subsection Joints\n"
                                                "  subsection middle\n"
                                                "    set Joints = 0, 1\n"
                                                "    set Struts = 1\n"
                                                "  end\n"
                                                "end\n");
  EXPECT_TRUE(contains(message, "Joints/middle")) << message;
  EXPECT_TRUE(contains(message, "joint 0")) << message;
}

TEST(MakeEquations, HingesAddRotationsAndCanBeSwitchedOff)
{
  const EquationsOnRanks rigid(two_struts_with(""), {}, MPI_COMM_SELF),
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
      EquationsOnRanks of_scene(two_struts_with(
                                  "subsection Joints\n  subsection middle\n"
                                  "    set Joints = 1\n    set Struts = " +
                                  struts +
                                  "\n    set Type = rotational spring\n"
                                  "    set Stiffness = 7\n  end\nend\n"),
                                {"Time/Scheme=static"},
                                MPI_COMM_SELF);
      State            from = of_scene.equations.initial_state(), to = from;
      // All of strut 1 turns rigidly by a tiny angle, so it has no forces.
      const double angle = 1e-9;
      const auto   names = name_unknowns(of_scene.model);
      for (unsigned int i = 0; i < names.size(); ++i)
        {
          const unsigned int c = std::get<3>(names[i].name);
          if (c == 1)
            to.displacement[i] = angle * std::max(0., names[i].position[0] - 1);
          if (c == rotation_z && names[i].position[0] > 1)
            to.displacement[i] = angle;
        }
      to.displacement[of_scene.dofs().end_rotation(1, 0)] = angle;
      const Evaluation step = of_scene.step(from, to, 1.);
      of_scene.residual(step);
      // Strains of 1e-18 are left of the rotation's square.
      EXPECT_NEAR(to.residual[of_scene.dofs().end_rotation(1, 0)],
                  7 * angle,
                  1e-6 * angle);
      EXPECT_NEAR(to.residual[of_scene.dofs().end_rotation(0, 1)],
                  -7 * angle,
                  1e-6 * angle);
      of_scene.accept(step);
      EXPECT_NEAR(to.energies.strain(),
                  3.5 * angle * angle,
                  1e-6 * angle * angle);
    }
}

TEST(MakeEquations, AReferenceVectorAlongAStrutIsRefused)
{
  const auto scene = [](const std::string &reference) {
    return "set Dimension = 3\n" +
      frame_scene("0 0 0; 1 0 0; 1 2 0",
                  "0 1; 1 2 0.5",
                  "subsection Sections\n  subsection blade\n"
                  "    set Struts = 1\n"
                  "    set Shape = circle\n    set Radius = 0.1\n"
                  "    set Young's modulus = 1\n    set Density = 1\n"
                  "    set Reference vector = " +
                    reference + "\n  end\nend\n");
  };
  // The arc 1 leads along y in its middle.
  expect_parts(input_error_of([&] {
                 EquationsOnRanks(scene("0 1 0.05"), {}, MPI_COMM_SELF);
               }),
               {"Sections/blade/Reference vector",
                "strut 1",
                "joints 1 - 2",
                "5 degrees"});
  EXPECT_NO_THROW(EquationsOnRanks(scene("0 0.3 1"), {}, MPI_COMM_SELF));
}

TEST(MakeEquations, WithoutMeanForcesASchemeThatBalancesThemIsRefusedByName)
{
  const std::string              frame = space_frame("0 0 0; 1 0 0", "0 1", "");
  const std::vector<std::string> balanced = {"Time/Scheme=energy-momentum"};
  const std::string              message =
    input_error_of([&] { EquationsOnRanks(frame, balanced, MPI_COMM_SELF); });
  EXPECT_TRUE(contains(message, "Time/Scheme = energy-momentum")) << message;
  EXPECT_TRUE(contains(message, "struts that turn in space")) << message;
  EXPECT_TRUE(contains(message, "generalized-alpha")) << message;
  // Small rotations have them.
  EXPECT_NO_THROW(EquationsOnRanks(frame,
                                   {balanced[0], "Effects/Large rotation=off"},
                                   MPI_COMM_SELF));
  EXPECT_NO_THROW(
    EquationsOnRanks(two_struts_with(""), balanced, MPI_COMM_SELF));
}
