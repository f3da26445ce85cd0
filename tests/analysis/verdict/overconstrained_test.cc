#include <auxfem/equations/mode_space.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * Message of refuse_overconstrained() for a scene; empty if it accepts it.
   */
  std::string overconstraint_of(const std::string              &text,
                                const std::vector<std::string> &overrides = {},
                                const MPI_Comm communicator = MPI_COMM_WORLD)
  {
    EquationsOnRanks setup(text, overrides, communicator);
    Work             work;
    TangentSolver    solver(setup.equations, setup.scene.solver, work);
    return input_error_of(
      [&] { refuse_overconstrained(solver, setup.equations.initial_state()); });
  }

  SceneText rigid(const std::string &struts)
  {
    return SceneText().add("Rigid parts/bars",
                           "Struts = " + struts +
                             " | Parts = single struts | Mass = 1");
  }

  SceneText pins(const std::string &joints)
  {
    return SceneText().support("ground", joints, "pin");
  }

  /** A square of side 2 with both diagonals, 4 and 5. */
  SceneText braced_square(const SceneText &further)
  {
    return frame_scene("0 0; 2 0; 2 2; 0 2",
                       "0 1; 1 2; 2 3; 3 0; 0 2; 1 3",
                       further);
  }

  /** A chain of @p n bars of 1 m in a zigzag of one in ten. */
  std::string chain(const unsigned int n)
  {
    std::string joints = "0 0", struts;
    for (unsigned int i = 1; i <= n; ++i)
      {
        joints += "; " + std::to_string(i) + (i % 2 == 0 ? " 0" : " 0.1");
        struts += (i == 1 ? "" : "; ") + std::to_string(i - 1) + " " +
          std::to_string(i);
      }
    return frame_scene(joints, struts, rigid("all") + pins("0"));
  }
} // namespace

TEST(Overconstrained, ABarBetweenFixedJointsIsRefused)
{
  const std::string message = overconstraint_of(
    frame_scene("0 0; 1 0; 3 1", "0 1; 1 2", rigid("all") + pins("0, 1")));
  for (const char *words : {"rigid part between fixed joints",
                            "constraint of the rigid part of joints 0 1",
                            "supports"})
    EXPECT_TRUE(contains(message, words)) << message;
}

TEST(Overconstrained, ASecondDiagonalIsRefused)
{
  for (const char *supports : {"", "0"})
    {
      const std::string message = overconstraint_of(braced_square(
        rigid("all") + (*supports ? pins(supports) : SceneText())));
      EXPECT_TRUE(contains(message, "constraint of the rigid part of joints"))
        << message;
    }
}

TEST(Overconstrained, ADeterminateSquarePasses)
{
  EXPECT_EQ(overconstraint_of(frame_scene("0 0; 2 0; 2 2; 0 2",
                                          "0 1; 1 2; 2 3; 3 0; 0 2",
                                          rigid("all") + pins("0"))),
            "");
}

TEST(Overconstrained, AnElasticDiagonalPasses)
{
  EXPECT_EQ(overconstraint_of(
              braced_square(rigid("0, 1, 2, 3, 4") + pins("0"))),
            "");
}

TEST(Overconstrained, TheSecondPinOfADeterminateSquareIsRefused)
{
  EXPECT_NE(overconstraint_of(
              braced_square(rigid("0, 1, 2, 3, 4") + pins("0, 2"))),
            "");
  // A roller along the diagonal leaves it free.
  EXPECT_EQ(
    overconstraint_of(braced_square(
      rigid("0, 1, 2, 3, 4").add(pins("0")).support("slide", "1", "roller x"))),
    "");
}

TEST(Overconstrained, PrescribedMotionCountsAsSupport)
{
  const SceneText driven = SceneText().add(
    "Supports/shaker",
    "Joints = 1 | Type = prescribed | Displacement x = 0.1 * t");
  const std::string bar = "0 0; 1 0; 3 1", struts = "0 1; 1 2";
  EXPECT_NE(overconstraint_of(
              frame_scene(bar, struts, rigid("0") + pins("0") + driven)),
            "");
}

TEST(Overconstrained, TwoPartsThatShareTwoJointsAreRefused)
{
  const std::string message =
    overconstraint_of(frame_scene("0 0; 1 0; 2 1", "0 1; 1 2")
                        .set("Rigid parts/L/Struts", "all")
                        .set("Rigid parts/twin/Joints", "0, 2"));
  EXPECT_TRUE(contains(message, "constraint of the rigid part of joints"))
    << message;
}

TEST(Overconstrained, CellSizeDoesNotMatter)
{
  const auto square = [](const std::string &struts, const std::string &size) {
    const std::string &a = size;
    return overconstraint_of(
      frame_scene("0 0; " + a + " 0; " + a + " " + a + "; 0 " + a,
                  struts,
                  rigid("all") + pins("0")));
  };
  for (const char *size : {"1e-5", "1e4"})
    {
      EXPECT_EQ(square("0 1; 1 2; 2 3; 3 0; 0 2", size), "");
      EXPECT_NE(square("0 1; 1 2; 2 3; 3 0; 0 2; 1 3", size), "");
    }
}

TEST(Overconstrained, ALongChainPasses)
{
  EXPECT_EQ(overconstraint_of(chain(200)), "");
}

TEST(Overconstrained, ScenesWithoutRigidPartsPass)
{
  EXPECT_EQ(overconstraint_of(frame_scene("0 0; 1 0", "0 1", pins("0, 1"))),
            "");
}

namespace
{
  /** An L of rigid struts in space with @p further supports and hinges. */
  SceneText rigid_l(const SceneText &further)
  {
    return SceneText()
      .dimension(3)
      .frame("0 0 0; 0 0 2; 1 0 2", "0 1; 1 2")
      .rigid_part("L", "all", 1)
      .add(further);
  }

  const SceneText revolute =
    SceneText().add("Joints/door",
                    "Joints = 0 | Type = revolute | Axis = 0 0 1");
} // namespace

TEST(Overconstrained, ABodyInSpaceOnOneHingePasses)
{
  EXPECT_EQ(overconstraint_of(rigid_l(pins("0"))), "");
  EXPECT_EQ(overconstraint_of(rigid_l(pins("0") + revolute)), "");
}

TEST(Overconstrained, ASecondPinOnTheAxisIsRefused)
{
  for (const SceneText &hinge : {SceneText(), revolute})
    {
      const std::string message =
        overconstraint_of(rigid_l(pins("0, 1") + hinge));
      EXPECT_TRUE(contains(message, "constraint of the")) << message;
      EXPECT_TRUE(contains(message, "slide along the axis")) << message;
    }
}

TEST(Overconstrained, ARevoluteHingeInAHeldBodyIsRefused)
{
  // Three joints are supported in all remaining directions.
  EXPECT_NE(overconstraint_of(rigid_l(pins("0").add(revolute).add(
              "Supports/slide",
              "Joints = 2 | Type = prescribed | Displacement z = 0"))),
            "");
}

TEST(Overconstrained, ARelationThatFollowsFromOthersIsRefused)
{
  const auto constrained = [](const std::string &second,
                              const std::string &supports) {
    return overconstraint_of(
      frame_scene("0 0; 1 0; 3 1",
                  "0 1; 1 2",
                  SceneText()
                    .section({1, 1, 1})
                    .set("Sections/section 0/Density", 1)
                    .add("Constraints/first", "Joints = 0, 1 | Components = x")
                    .add("Constraints/second", second)
                    .add(pins(supports))));
  };
  const std::string pair = "Type = linear relation | Relation = ";
  EXPECT_EQ(constrained(pair + "x of 0; x of 1; x of 2", "0"), "");
  for (const auto &[second, supports] :
       {std::pair(pair + "2 x of 1; -2 x of 0", "0"),
        std::pair(pair + "x of 1; 2 y of 0", "0"),
        std::pair(std::string("Type = line | Joints = 0 | Direction = 1 1"),
                  "0")})
    {
      const std::string message = constrained(second, supports);
      EXPECT_TRUE(contains(message, "relation of Constraints/")) << message;
      EXPECT_TRUE(contains(message, "Remove a relation")) << message;
    }
}
