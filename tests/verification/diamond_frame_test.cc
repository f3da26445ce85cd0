#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>
#include <cmath>

using namespace auxfem::testing_support;

namespace
{
  // Four equal members of length L = 1 and EI = 1, pulled or pushed along the
  // vertical diagonal by +-P (Mattiasson 1981; Jenkins et al. 1966). References
  // are those of inextensible members. With EA = kGA each member keeps its
  // rotations and its end moves by (P/2) L / EA more along the load.
  constexpr double diamond_axial_stiffness = 1e4;

  struct DiamondRow
  {
    double load;          ///< P L^2 / EI
    double along, across; ///< half the change of the two diagonals / L
  };

  /** Joints: 0 right, 1 top, 2 left, 3 bottom. */
  SceneText diamond(const bool is_pinned, const double direction)
  {
    const std::string c = text(std::sqrt(0.5));
    SceneText scene = static_frame(c + " 0; 0 " + c + "; -" + c + " 0; 0 -" + c,
                                   "0 1; 1 2; 2 3; 3 0");
    const std::string sign     = direction > 0 ? "" : "-";
    const std::string opposite = direction > 0 ? "-" : "";
    scene.section({diamond_axial_stiffness, diamond_axial_stiffness, 1})
      .support("horizontal diagonal", "0, 2", "roller x")
      .support("vertical diagonal", "1, 3", "roller y")
      .load("top", "1", {"0", sign + "t", "0"})
      .load("bottom", "3", {"0", opposite + "t", "0"})
      .mesh(4, 3);
    if (is_pinned)
      scene.hinge("loaded corners", "1, 3");
    return scene;
  }

  void compare(const bool                     is_pinned,
               const double                   direction,
               const std::vector<DiamondRow> &reference)
  {
    SceneRun          run(diamond(is_pinned, direction).time(10, 0.2).str());
    const std::string name =
      std::string(is_pinned ? "hinged at the loaded corners" : "all rigid") +
      (direction > 0 ? ", pulled" : ", pushed");
    ComparisonTable table("Diamond frame, " + name +
                          ", inextensible rod equation by shooting");
    run.run([&] {
      for (const DiamondRow &row : reference)
        if (std::abs(row.load - run.state.time) < 1e-6)
          {
            const double stretch =
              direction * row.load / 2 / diamond_axial_stiffness;
            const std::string at = "P L^2/EI = " + text(row.load) + ": ";
            // The reference has eight decimals.
            const double allowed = 1e-8;
            table.row(at + "loaded diagonal",
                      run.motion(1, 1) - stretch,
                      row.along,
                      allowed);
            table.row(at + "other diagonal",
                      run.motion(0, 0),
                      row.across,
                      allowed);
            EXPECT_NEAR(run.motion(3, 1), -run.motion(1, 1), 1e-9);
            EXPECT_NEAR(run.motion(2, 0), -run.motion(0, 0), 1e-9);
          }
    });
    // The frame balances itself.
    EXPECT_NEAR(run.reaction("vertical diagonal", 0), 0, 1e-8);
    EXPECT_NEAR(run.reaction("horizontal diagonal", 1), 0, 1e-8);
  }

  TEST(DiamondFrame, HingedPulled)
  {
    compare(true,
            1,
            {{0.4, 0.03064591, -0.03232727},
             {1, 0.06783718, -0.07670325},
             {2, 0.11251535, -0.13960153},
             {4, 0.16428937, -0.23183485},
             {6, 0.19182530, -0.29446625},
             {10, 0.21931286, -0.37322348}});
  }

  TEST(DiamondFrame, HingedPushed)
  {
    compare(true,
            -1,
            {{0.4, -0.03629752, 0.03418518},
             {1, -0.10293777, 0.08741405},
             {2, -0.24754355, 0.17046098},
             {4, -0.58235985, 0.24223758},
             {6, -0.83139890, 0.20518719},
             {10, -1.08927239, 0.07735055}});
  }

  TEST(DiamondFrame, RigidPulled)
  {
    compare(false,
            1,
            {{0.4, 0.00815875, -0.00827327},
             {1, 0.01976285, -0.02044847},
             {2, 0.03752266, -0.04007575},
             {4, 0.06783718, -0.07670325},
             {6, 0.09242515, -0.10981404},
             {10, 0.12907910, -0.16637074}});
  }

  TEST(DiamondFrame, RigidPushed)
  {
    compare(false,
            -1,
            {{0.4, -0.00851228, 0.00839101},
             {1, -0.02197178, 0.02118081},
             {2, -0.04634835, 0.04295442},
             {4, -0.10293777, 0.08741405},
             {6, -0.17034621, 0.13098855},
             {10, -0.33154340, 0.20260798}});
  }

  // A member between two rigid corners is two members hinged at its inflection,
  // half as long each: deflections of the rigid frame under 4 P are those of
  // the hinged one under P.
  TEST(DiamondFrame, RigidFrameIsTwiceTheHingedOne)
  {
    for (const double direction : {1., -1.})
      {
        SceneRun rigid(diamond(false, direction).time(8, 0.5).str());
        SceneRun hinged(diamond(true, direction).time(2, 0.125).str());
        rigid.run();
        hinged.run();
        const double stretch =
          (8 - 2) * direction / 2 / diamond_axial_stiffness;
        // Discretisation: 16 against 8 elements between inflections
        EXPECT_NEAR(rigid.motion(1, 1) - stretch, hinged.motion(1, 1), 1e-9);
        EXPECT_NEAR(rigid.motion(0, 0), hinged.motion(0, 0), 1e-9);
      }
  }

  // Small loads: du = p/12 with hinges, p/48 without, from bending; (p/2) EI/EA
  // from stretch.
  TEST(DiamondFrame, SmallDisplacements)
  {
    for (const bool is_pinned : {true, false})
      {
        SceneRun run(diamond(is_pinned, 1).linear().str());
        run.run();
        EXPECT_NEAR(run.motion(1, 1),
                    1. / (is_pinned ? 12 : 48) + 0.5 / diamond_axial_stiffness,
                    1e-9); // round-off of stretching against bending
      }
  }
} // namespace
