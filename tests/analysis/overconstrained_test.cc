#include <auxfem/analysis/inverse_iteration.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** What refuse_overconstrained() has against a scene; empty if nothing. */
  std::string overconstraint_of(const std::string              &text,
                                const std::vector<std::string> &overrides = {},
                                const MPI_Comm communicator = MPI_COMM_WORLD)
  {
    EquationsOnRanks of_scene(text, overrides, communicator);
    Work             work;
    TangentSolver    solver(of_scene.equations, of_scene.scene.solver, work);
    return input_error_of([&] {
      refuse_overconstrained(solver, of_scene.equations.initial_state());
    });
  }

  std::string rigid(const std::string &struts)
  {
    return "subsection Rigid parts\n"
           "  subsection bars\n"
           "    set Struts = " +
      struts +
      "\n    set Parts = single struts\n"
      "    set Mass = 1\n"
      "  end\n"
      "end\n";
  }

  std::string pins(const std::string &joints)
  {
    return "subsection Supports\n"
           "  subsection ground\n"
           "    set Joints = " +
      joints +
      "\n    set Type = pin\n"
      "  end\n"
      "end\n";
  }

  /** A square of side 2 with both diagonals, 4 and 5. */
  std::string braced_square(const std::string &further)
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
  for (const char *words : {"Rigid parts",
                            "constraint of the rigid part of joints 0 1",
                            "supports"})
    EXPECT_TRUE(contains(message, words)) << message;
}

TEST(Overconstrained, ASecondDiagonalIsRefused)
{
  for (const char *supports : {"", "0"})
    {
      const std::string message = overconstraint_of(braced_square(
        rigid("all") + (*supports ? pins(supports) : std::string())));
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
  // A roller across the diagonal's direction leaves it free.
  EXPECT_EQ(overconstraint_of(braced_square(rigid("0, 1, 2, 3, 4") + pins("0") +
                                            "subsection Supports\n"
                                            "  subsection slide\n"
                                            "    set Joints = 1\n"
                                            "    set Type = roller x\n"
                                            "  end\n"
                                            "end\n")),
            "");
}

TEST(Overconstrained, PrescribedMotionCountsAsSupport)
{
  const std::string driven = "subsection Supports\n"
                             "  subsection shaker\n"
                             "    set Joints = 1\n"
                             "    set Type = prescribed\n"
                             "    set Displacement x = 0.1 * t\n"
                             "  end\n"
                             "end\n";
  const std::string bar = "0 0; 1 0; 3 1", struts = "0 1; 1 2";
  EXPECT_NE(overconstraint_of(
              frame_scene(bar, struts, rigid("0") + pins("0") + driven)),
            "");
}

TEST(Overconstrained, TwoPartsThatShareTwoJointsAreRefused)
{
  const std::string message =
    overconstraint_of(frame_scene("0 0; 1 0; 2 1",
                                  "0 1; 1 2",
                                  "subsection Rigid parts\n"
                                  "  subsection L\n"
                                  "    set Struts = all\n"
                                  "  end\n"
                                  "  subsection twin\n"
                                  "    set Joints = 0, 2\n"
                                  "  end\n"
                                  "end\n"));
  EXPECT_TRUE(contains(message, "constraint of the rigid part of joints"))
    << message;
}

TEST(Overconstrained, SmallCellsAreJudgedAsLargeOnes)
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
  std::string rigid_l(const std::string &further)
  {
    return "set Dimension = 3\nsubsection Lattice\n  set Cell = frame\n"
           "  set Joints = 0 0 0; 0 0 2; 1 0 2\n"
           "  set Struts = 0 1; 1 2\nend\n"
           "subsection Rigid parts\n  subsection L\n    set Struts = all\n"
           "    set Mass = 1\n  end\nend\n" +
      further;
  }

  const std::string revolute = "subsection Joints\n  subsection door\n"
                               "    set Joints = 0\n"
                               "    set Type = revolute\n"
                               "    set Axis = 0 0 1\n  end\nend\n";
} // namespace

TEST(Overconstrained, ABodyInSpaceOnOneHingePasses)
{
  EXPECT_EQ(overconstraint_of(rigid_l(pins("0"))), "");
  EXPECT_EQ(overconstraint_of(rigid_l(pins("0") + revolute)), "");
}

TEST(Overconstrained, ASecondPinOnTheAxisIsRefused)
{
  for (const std::string &hinge : {std::string(), revolute})
    {
      const std::string message =
        overconstraint_of(rigid_l(pins("0, 1") + hinge));
      EXPECT_TRUE(contains(message, "Rigid parts and revolute hinges"))
        << message;
      EXPECT_TRUE(contains(message, "slide along the axis")) << message;
    }
}

TEST(Overconstrained, ARevoluteHingeInAHeldBodyIsRefused)
{
  // Three joints held against all that is left.
  EXPECT_NE(overconstraint_of(rigid_l(
              pins("0") + revolute +
              "subsection Supports\n  subsection slide\n    set Joints = 2\n"
              "    set Type = prescribed\n    set Displacement z = 0\n"
              "  end\nend\n")),
            "");
}
