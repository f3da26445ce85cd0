#include <support/graphics_series.h>

#include <support/pi.h>

namespace
{
  using namespace auxfem::testing_support;

  /** The scenes in prm/, as they are. */
  class ShippedScenes : public ProgramTest
  {
  protected:
    void run_scene(const std::string &name,
                   const Words       &overrides = {},
                   const std::string &verdict   = "sound") const
    {
      Words arguments = {scene_file(name), "--output", "out"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      const ProgramRun run = run_auxfem(arguments);
      ASSERT_EQ(run.exit_code, 0) << run.errors;
      EXPECT_EQ(run.errors, "");
      EXPECT_EQ(summary("exit_state"), "completed");
      EXPECT_EQ(summary("verdict"), verdict) << summary("text");
    }

    static std::string scene_file(const std::string &name)
    {
      return std::string(AUXFEM_PRM_DIRECTORY) + "/" + name + ".prm";
    }
  };

  TEST_F(ShippedScenes, AllPassTheCheck)
  {
    unsigned int n_scenes = 0;
    for (const auto &entry :
         std::filesystem::directory_iterator(AUXFEM_PRM_DIRECTORY))
      if (entry.path().extension() == ".prm")
        {
          ++n_scenes;
          const ProgramRun run = run_auxfem({"--check", entry.path().string()});
          EXPECT_EQ(run.exit_code, 0) << entry.path() << run.errors;
          EXPECT_EQ(run.errors, "");
        }
    EXPECT_GE(n_scenes, 17u);
    for (const char *name : {"lattice",
                             "squeeze",
                             "drop-weight",
                             "cantilever",
                             "portal",
                             "star-10x10",
                             "star-10x10-maxwell",
                             "cell-case-1",
                             "cell-case-8",
                             "rigid-cell",
                             "rigid-array",
                             "elastic-cell"})
      EXPECT_TRUE(std::filesystem::exists(scene_file(name))) << name;
  }



  TEST_F(ShippedScenes, TheCantileverEndsAsACircle)
  {
    run_scene("cantilever");
    const Table table = history();

    // Newton's residual of 1e-8 of the end moment 4 pi leaves the rotation as
    // inexact, and the tip by about that times the length.
    const unsigned int last = table.n_rows - 1;
    EXPECT_DOUBLE_EQ(table["time"][last], 1);
    EXPECT_NEAR(table["tip.ux"][last], -1, 1e-7);
    EXPECT_NEAR(table["tip.uy"][last], 0, 1e-7);
    EXPECT_NEAR(table["tip.phi"][last], 2 * pi, 1e-7);
    EXPECT_NEAR(table["clamp.m"][last], -4 * pi, 1e-6);

    // On the way, an arc of the angle 2 pi t: the p-point integration makes
    // the ends of elements exact under a constant moment.
    for (unsigned int i = 1; i < table.n_rows; ++i)
      {
        const double angle = 2 * pi * table["time"][i];
        EXPECT_NEAR(table["tip.ux"][i], std::sin(angle) / angle - 1, 1e-6);
        EXPECT_NEAR(table["tip.uy"][i], (1 - std::cos(angle)) / angle, 1e-6);
        EXPECT_NEAR(table["tip.phi"][i], angle, 1e-6);
      }

    const Table points =
      GraphicsSeries(path("out/solution.pvd"), path("vtk")).points.back();
    const double radius = 1 / (2 * pi);
    for (unsigned int i = 0; i < points.n_rows; ++i)
      {
        EXPECT_NEAR(points["bending_moment"][i], 4 * pi, 1e-6 * 4 * pi);
        EXPECT_NEAR(points["axial_force"][i], 0, 1e-6 * 4 * pi);
        EXPECT_NEAR(points["shear_force"][i], 0, 1e-6 * 4 * pi);
        // A cubic through a quarter of a circle: (pi/2)^4 / 4! times at most
        // 1/81, the largest product of distances to four equidistant nodes.
        EXPECT_NEAR(std::hypot(points["x"][i] + points["displacement.0"][i],
                               points["y"][i] + points["displacement.1"][i] -
                                 radius),
                    radius,
                    3.2e-3 * radius);
      }
  }



  TEST_F(ShippedScenes, RelaxingStrutsLoseTheEnergyOfAnImpact)
  {
    run_scene("tpu-impact", {"Output/Graphics=false"});
    const Table table = history();
    const auto &lost  = table["strut_relaxation_dissipated"];
    for (unsigned int i = 1; i < table.n_rows; ++i)
      EXPECT_GE(lost[i], lost[i - 1]);
    EXPECT_GT(lost.back(), 0.9 * table["external"].back());
    EXPECT_LT(std::abs(table["balance"].back()),
              1e-4 * table["external"].back());
  }



  TEST_F(ShippedScenes, TheDropWeightIsThrownBack)
  {
    run_scene("drop-weight", {"Output/Graphics=false"});
    const Table table   = history();
    double      impulse = 0, at_foot = 0, error = 0;
    for (unsigned int i = 1; i < table.n_rows; ++i)
      {
        // Forces are means of steps, and all of its momentum is from them.
        impulse += table["weight.fy"][i] * 20e-6;
        EXPECT_NEAR(table["weight motion.vy"][i], -1 + impulse / 0.2, 1e-7);
        EXPECT_GE(table["weight.fy"][i], 0);
        EXPECT_LT(table["weight.penetration"][i], 0.1);
        at_foot = std::max(at_foot, table["foundation.ry"][i]);
        error   = std::max(error, std::abs(table["balance"][i]));
      }
    // The weight has left with the energy that lattice and connectors returned.
    EXPECT_EQ(table["weight.fy"].back(), 0);
    EXPECT_GT(table["weight motion.vy"].back(), 0.5);
    EXPECT_LT(table["weight motion.vy"].back(), 0.8);
    EXPECT_LT(error, 1e-9 * 0.1);
    EXPECT_GT(table["damper.dissipated"].back(), 0.01);

    // Without dashpots it is faster and the foot feels more.
    const double slowed = table["weight motion.vy"].back();
    run_scene("drop-weight",
              {"Output/Graphics=false", "Effects/Connector viscosity=off"});
    const Table undamped = history();
    EXPECT_GT(undamped["weight motion.vy"].back(), slowed + 0.1);
    EXPECT_GT(*std::max_element(undamped["foundation.ry"].begin(),
                                undamped["foundation.ry"].end()),
              at_foot + 2);
  }



  TEST_F(ShippedScenes, TheSqueezedLatticeShrinksSideways)
  {
    // Until the plate has come down by a twentieth; later on, as the struts
    // buckle, the lattice need not stay symmetric.
    run_scene("squeeze", {"Time/End time=0.6 s", "Output/Graphics=false"});
    const Table table = history();
    for (unsigned int i = 1; i < table.n_rows; ++i)
      {
        EXPECT_GT(table["left.ux"][i], 0);
        EXPECT_LT(table["right.ux"][i], 0);
      }
    EXPECT_LT(table["top.uy"].back(), -4e-3);

    // Around -0.55, see the next test; large strain changes it, but not by
    // half.
    const double contraction =
      (table["right.ux"].back() - table["left.ux"].back()) /
      table["top.uy"].back();
    EXPECT_GT(contraction, 0.4);
    EXPECT_LT(contraction, 0.7);
  }



  TEST_F(ShippedScenes, TheSqueezedLatticeSaysThatItsStrutsBuckle)
  {
    run_scene("squeeze", {"Output/Graphics=false"}, "doubtful");
    expect_contains(summary("text"), {"Stability is lost at about t = "});
  }



  TEST_F(ShippedScenes, TheSqueezedLatticeHasItsPoissonRatio)
  {
    // One small static step without the connectors, which the closed form
    // below does not have: 1e-12 N/m is as good as none; nor damping.
    run_scene("squeeze",
              {"Time/Scheme=static",
               "Time/End time=4 ms",
               "Time/Time step=4 ms",
               "Connectors/damper/Spring stiffness=1e-12",
               "Connectors/damper/Damping coefficient=0",
               "Effects/Strut damping=off",
               "Output/Graphics=false"});
    const Table  table = history();
    const double ratio = -(table["right.ux"].back() - table["left.ux"].back()) /
      table["top.uy"].back();

    // Star of 12 equal Timoshenko struts by unit-load method: compliances of
    // an arm under equal (Cs) and opposite (Cd) loads along x and y, and of
    // its stubs. Under uniaxial load the boundary of the array sees what the
    // inner cells see. Slender limit: (3 - 5 sin 2a) / (5 - 3 sin 2a).
    const double angle = pi / 3, length = 10e-3;
    const double width = 10e-3, height = 1e-3, modulus = 20e6;
    const double EA = modulus * width * height, EI = EA * height * height / 12;
    const double kGA = 5. / 6 * EA / (2 * (1 + 0.45));
    const double p   = length * (std::sin(angle) - std::cos(angle));
    const double d   = 2 * length * std::sin(angle) - p;
    const double Cd  = length * d * d / (12 * EI) + p * p / (length * EA) +
      d * d / (length * kGA);
    const double Cs = length * p * p / (3 * EI) + d * d / (length * EA) +
      p * p / (length * kGA);
    const double reference = (Cs - Cd) / (Cs + Cd + 4 * length / EA);
    EXPECT_LT(reference, 0);

    // Large rotation changes the ratio in proportion to the strain, with a
    // factor of 1.5 here as runs with larger steps show.
    const double strain = std::abs(table["top.uy"].back()) / 0.136603;
    EXPECT_LT(strain, 1e-5);
    EXPECT_NEAR(ratio, reference, 3 * strain);
  }



  TEST_F(ShippedScenes, TheMainSceneBendsItsStruts)
  {
    // Until the impact is over.
    run_scene("lattice", {"Time/End time=56 ms", "Output/Graphics=false"});
    // 20 cells of 12, less one for each of the 31 neighbours that share it
    EXPECT_EQ(summary("joints"), "209");
    EXPECT_EQ(summary("connectors"), "20");
    EXPECT_GT(std::stod(summary("largest_rotation_radian")), 30 * pi / 180);

    const Table table = history();
    EXPECT_LT(table["top.uy"].back(), 0);
    EXPECT_GT(table["damper.dissipated"].back(), 0);
    EXPECT_GT(table["foundation.ry"].back(), 0);
  }



  TEST_F(ShippedScenes, ThePortalRunsAgainFromItsRecordedParameters)
  {
    // Its mesh file is found from another folder, too.
    run_scene("portal");
    const ProgramRun again =
      run_auxfem({"out/parameters.prm", "--output", "again"});
    ASSERT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_text(path("again/history.csv")),
              read_text(path("out/history.csv")));
    EXPECT_GT(history().n_rows, 2u);
  }



  // Edges and stubs of one kind come out alike, although each has its variable.
  TEST_F(ShippedScenes, TheBestStarCellIsAuxeticByMoreThanOne)
  {
    run_scene("design-star");
    const Table               table(path("out/optimization.csv"));
    const std::vector<double> best = table["best_so_far"];
    EXPECT_NEAR(best.front(), -0.5507, 1e-3);
    EXPECT_LT(best.back(), -1.07);
    const std::string text   = read_text(path("out/summary.json"));
    const std::string chosen = text.substr(text.find("\"best\""));
    const auto        height = [&chosen](const std::string &name) {
      return std::stod(json_value(chosen, "Constants/" + name));
    };
    for (const char *name : {"h3", "h4", "h7"})
      EXPECT_NEAR(height(name), height("h0"), 1e-3 * height("h0")) << name;
    for (const char *name : {"h9", "h10", "h11"})
      EXPECT_NEAR(height(name), 0.4, 1e-6) << name;
  }

  // The record has noise of 2 N.
  TEST_F(ShippedScenes, TheFitFindsTheConnector)
  {
    run_scene("fit-connector");
    const std::string text   = read_text(path("out/summary.json"));
    const std::string chosen = text.substr(text.find("\"best\""));
    EXPECT_NEAR(std::stod(
                  json_value(chosen, "Connectors/connector/Spring stiffness")),
                17.3,
                0.2);
    EXPECT_NEAR(
      std::stod(json_value(chosen, "Connectors/connector/Damping coefficient")),
      86,
      6);
  }

  TEST_F(ShippedScenes, TheTimedLatticesRun)
  {
    for (const char *name : {"star-10x10", "star-10x10-maxwell"})
      {
        // A hundredth of the run.
        run_scene(name, {"Time/End time=0.2 ms", "Output/Graphics=false"});
        EXPECT_EQ(summary("joints"), "1020");
        EXPECT_EQ(summary("struts"), "1200");
        EXPECT_EQ(summary("connectors"), "100");
        // 1200 elements of order 2 with a node inside, three unknowns a node
        EXPECT_EQ(summary("unknowns"), "6660");

        const Table table = history();
        EXPECT_EQ(table.n_rows, 11u);
        EXPECT_LT(table["top.uy"].back(), 0);
        EXPECT_NE(table["foundation.ry"].back(), 0);
      }
  }
} // namespace
