#include <auxfem/equations/mode_space.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  std::string refusal_with(const std::string              &solver_type,
                           const std::string              &text,
                           const std::vector<std::string> &overrides,
                           const std::optional<double>     first_step)
  {
    std::vector<std::string> all = overrides;
    all.push_back("Solver/Type=" + solver_type);
    EquationsOnRanks setup(text, all, MPI_COMM_SELF);
    Work             work;
    TangentSolver    solver(setup.equations, setup.scene.solver, work);
    return input_error_of([&] {
      refuse_mechanism(solver, setup.equations.initial_state(), first_step);
    });
  }

  /**
   * Message of refuse_mechanism() for a scene; empty if it accepts it. An
   * iterative solver must reach the same verdict, possibly by another mode.
   */
  std::string
  mechanism_of(const std::string              &text,
               const std::vector<std::string> &overrides  = {},
               const std::optional<double>     first_step = std::nullopt)
  {
    const std::string refusal =
      refusal_with("auto", text, overrides, first_step);
    EXPECT_EQ(refusal_with("gmres", text, overrides, first_step).empty(),
              refusal.empty());
    return refusal;
  }

  /** A square of four struts, joints 0..3 counterclockwise from the origin. */
  SceneText square(const SceneText &further = {})
  {
    return frame_scene("0 0; 1 0; 1 1; 0 1", "0 1; 1 2; 2 3; 3 0", further)
      .set("Time/Scheme", "static");
  }

  const SceneText hinges = SceneText().hinge("corners", "all");

  const SceneText two_pins = SceneText().support("ground", "0, 1", "pin");

  SceneText brace(const std::string &stiffness)
  {
    return SceneText().connector("brace",
                                 "spring",
                                 "Spring stiffness = " + stiffness +
                                   " | Between = 0 2");
  }
} // namespace

TEST(Mechanism, AHingedSquareIsRefusedNamingAMovingJoint)
{
  const std::string message = mechanism_of(square(hinges + two_pins));
  EXPECT_TRUE(contains(message, "horizontal displacement of joint 2") ||
              contains(message, "horizontal displacement of joint 3"))
    << message;
  EXPECT_TRUE(contains(message, "Supports")) << message;
}

TEST(Mechanism, ABracedHingedSquareStands)
{
  EXPECT_EQ(mechanism_of(square(hinges + two_pins + brace("1"))), "");
}

TEST(Mechanism, ASoftBraceHoldsASquareToo)
{
  // A million times softer than the struts, still far above round-off.
  EXPECT_EQ(mechanism_of(square(hinges + two_pins + brace("1e-6"))), "");
}

TEST(Mechanism, ADashpotHoldsASquareInAStepOnly)
{
  const std::string text = square(SceneText(hinges).add(two_pins).add(
    "Connectors/brace",
    "Law = dashpot | Damping coefficient = 1 | Between = 0 2"));
  EXPECT_EQ(mechanism_of(text, {}, 0.1), "");
  EXPECT_NE(mechanism_of(text), "");
}

TEST(Mechanism, ARigidSquareOnTwoPinsStands)
{
  EXPECT_EQ(mechanism_of(square(two_pins)), "");
}

TEST(Mechanism, AHingedSquareWithRotationalSpringsStands)
{
  EXPECT_EQ(
    mechanism_of(square(
      SceneText()
        .add("Joints/corners",
             "Joints = all | Type = rotational spring | Stiffness = 0.01")
        .add(two_pins))),
    "");
}

TEST(Mechanism, AStructureWithoutSupportsIsRefused)
{
  EXPECT_TRUE(contains(mechanism_of(square()), "not supported"));
}

TEST(Mechanism, OnePinLeavesARotation)
{
  EXPECT_NE(mechanism_of(square(SceneText().support("ground", "0", "pin"))),
            "");
}

TEST(Mechanism, AnUnconnectedPartIsFound)
{
  // The second strut is unconnected.
  const std::string message = mechanism_of(
    frame_scene("0 0; 1 0; 3 0; 4 0", "0 1; 2 3").support("wall", "0", "clamp"),
    {"Time/Scheme=static"});
  EXPECT_TRUE(contains(message, "joint 2") || contains(message, "joint 3") ||
              contains(message, "strut 1"))
    << message;
}

TEST(Mechanism, ASlenderCantileverOfManyElementsStands)
{
  // Bending a million times softer than stretching, in 64 elements.
  EXPECT_EQ(
    mechanism_of(frame_scene("0 0; 1 0", "0 1").support("wall", "0", "clamp"),
                 {"Time/Scheme=static",
                  "Discretization/Global refinements=6",
                  "Sections/band/Second moment of area=3e-6"}),
    "");
}

TEST(Mechanism, ALargeStarArrayOnItsFoundationStands)
{
  EXPECT_EQ(mechanism_of(star_with_everything(6, 6), {"Time/Scheme=static"}),
            "");
}

TEST(Mechanism, UnitsDoNotMatter)
{
  // The same square in millimetres and steel.
  const std::vector<std::string> steel = {
    "Lattice/Joints=0 0; 1e-3 0; 1e-3 1e-3; 0 1e-3",
    "Sections/band/Young's modulus=200e9",
    "Sections/band/Area=1e-8",
    "Sections/band/Shear area=1e-8",
    "Sections/band/Second moment of area=1e-17"};
  EXPECT_EQ(mechanism_of(square(two_pins), steel), "");
  EXPECT_NE(mechanism_of(square(hinges + two_pins), steel), "");
}

TEST(Mechanism, ABodyInSpaceThatTurnsAboutItsHingeIsRefused)
{
  const SceneText door =
    SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0 0; 1 1 0", "0 1; 1 2")
      .rigid_part("door", "all", 1)
      .support("pivot", "0", "pin")
      .add("Joints/hinge", "Joints = 0 | Type = revolute | Axis = 0 1 0");
  // The constraints need a direct solver.
  EXPECT_NE(refusal_with("auto", door, {}, std::nullopt), "");
  // A spring to the ground supports it.
  EXPECT_EQ(refusal_with("auto",
                         SceneText(door)
                           .remove("Joints/hinge/Axis")
                           .add("Joints/hinge",
                                "Type = rotational spring | Stiffness = 3"),
                         {},
                         std::nullopt),
            "");
}

TEST(Mechanism, IsDistinctFromAStiffnessRatioTooLarge)
{
  // A cantilever of two struts, the outer one 1e12 times as stiff.
  const auto cantilever_of = [](const std::string &modulus) {
    return SceneText()
      .frame("0 0; 0.1 0; 0.2 0", "0 1; 1 2")
      .circle("soft", "2 mm", {1, 1000})
      .circle("stiff", "2 mm", {modulus, 1000})
      .set("Sections/stiff/Struts", "1")
      .support("foot", "0", "clamp")
      .mesh(3)
      .set("Time/Scheme", "static");
  };
  const std::string refusal = mechanism_of(cantilever_of("1e12"));
  EXPECT_NE(refusal.find("too far apart"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("1e+12 times"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("strut 1 ("), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("strut 0 ("), std::string::npos) << refusal;
  EXPECT_EQ(mechanism_of(cantilever_of("1e6")), "");
  EXPECT_NE(mechanism_of(cantilever_of("1e12").remove("Supports"))
              .find("without any resistance"),
            std::string::npos);
}
