#include <support/graphics_series.h>
#include <support/scene_text.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Runs with Analysis = modes. */
  class ModesProgram : public ProgramTest
  {
  protected:
    ProgramRun run_modes(const Words &overrides = {}) const
    {
      return run_shipped("modes.prm", overrides);
    }
  };

  TEST_F(ModesProgram, LeavesATableAndPictures)
  {
    const ProgramRun run = run_modes({"Modes/Number=3", "Modes/Pictures=4"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("None is missing"), std::string::npos);
    const Table table(path("out/modes.csv"));
    ASSERT_EQ(table.n_rows, 3u);
    for (unsigned int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(table["frequency"][i] * table["period"][i], 1, 1e-12);
        EXPECT_LT(table["residual"][i], 1e-6);
      }
    for (unsigned int i = 1; i < 3; ++i)
      {
        EXPECT_GE(table["frequency"][i], table["frequency"][i - 1]);
      }
    // The first goes along x, the foot stays, half a period later all is on the
    // other side.
    const GraphicsSeries series(path("out/mode_1_solution.pvd"), path("vtk"));
    ASSERT_EQ(series.datasets.n_rows, 4u);
    EXPECT_NEAR(series.datasets["time"][2], 0.5, 1e-12);
    double largest = 0;
    for (unsigned int i = 0; i < series.points[0].n_rows; ++i)
      {
        const double there = series.points[0]["displacement.0"][i],
                     back  = series.points[2]["displacement.0"][i];
        EXPECT_NEAR(there - series.points[1]["displacement.0"][i],
                    series.points[1]["displacement.0"][i] - back,
                    1e-6 * 0.1);
        largest = std::max(largest, std::abs(there - back) / 2);
      }
    // 5 % of the longer side.
    EXPECT_NEAR(largest, 0.05 * 0.1366, 0.01 * 0.1366);
    EXPECT_TRUE(std::filesystem::exists(path("out/mode_3_connectors.pvd")));
    EXPECT_FALSE(std::filesystem::exists(path("out/mode_4_solution.pvd")));
  }

  /** A steel bar of 1 m and 10 mm between clamps, without a mesh. */
  SceneText clamped_bar(const std::string &displacement)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rectangle("steel", "10 mm", "10 mm", {"210 GPa", 7850})
      .support("A", "0", "clamp")
      .prescribe("B", "1", {displacement, "0", "0"})
      .set("Output/Graphics", "false")
      .time(1, 1);
  }

  TEST_F(ModesProgram, ElementsMeetTheToleranceByDefault)
  {
    write("bar.prm",
          clamped_bar("0").set("Analysis", "modes").set("Modes/Number", 4));
    const ProgramRun run =
      run_auxfem({path("bar.prm"), "--output", path("out")});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"Verdict: sound", "tolerance"});
    const Table table(path("out/modes.csv"));
    // (beta L)^2 sqrt(EI / rho A) of clamped beams. Shear and rotary inertia,
    // which it leaves out, are about (h beta)^2 / 6 of it.
    const double beta[] = {4.730041, 7.853205, 10.995608, 14.137165};
    for (unsigned int i = 0; i < 4; ++i)
      {
        EXPECT_NEAR(table["angular_frequency"][i] /
                      (beta[i] * beta[i] * std::sqrt(210e9 / 7850 / 12) * 0.01),
                    1,
                    std::pow(0.01 * beta[i], 2) / 3);
        EXPECT_LT(table["mesh_error"][i], 1e-4);
      }
  }

  TEST_F(ModesProgram, GivenElementsThatAreTooCoarseAreTold)
  {
    write(
      "bar.prm",
      clamped_bar("0").set("Analysis", "modes").set("Modes/Number", 2).mesh(3));
    const ProgramRun run =
      run_auxfem({path("bar.prm"), "--output", path("out")});
    EXPECT_EQ(run.exit_code, 3) << run.errors;
    expect_contains(run.output, {"not to be used", "Order = auto"});
  }

  TEST_F(ModesProgram, ElementsOfBucklingMeetTheToleranceByDefault)
  {
    write("bar.prm",
          clamped_bar("-0.001 * t")
            .set("Analysis", "buckling")
            .set("Modes/Number", 4));
    const ProgramRun run =
      run_auxfem({path("bar.prm"), "--output", path("out")});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Table table(path("out/buckling.csv"));
    // 4 pi^2 EI / L^2 by EA u / L; shear makes it less by 1e-3.
    EXPECT_NEAR(table["factor"][0], 4 * M_PI * M_PI / 12 * 0.1, 2e-3 * 0.329);
    for (unsigned int i = 0; i < 4; ++i)
      EXPECT_LT(table["mesh_error"][i], 1e-4);
  }

  TEST_F(ModesProgram, LoadsChangeThem)
  {
    double before = 0;
    for (const std::string load : {"-1", "-0.5", "0"})
      {
        const ProgramRun run = run_modes(
          {"Loads/pressure/Force y=" + load, "Output/Graphics=false"});
        ASSERT_EQ(run.exit_code, 0) << run.errors;
        const double lowest = Table(path("out/modes.csv"))["frequency"][0];
        EXPECT_GT(lowest, 1.1 * before);
        before = lowest;
      }
  }

  TEST_F(ModesProgram, DampingIsToldWhereItIsAskedFor)
  {
    const ProgramRun plain =
      run_modes({"Modes/Number=2", "Output/Graphics=false"});
    ASSERT_EQ(plain.exit_code, 0) << plain.errors;
    EXPECT_TRUE(std::isnan(Table(path("out/modes.csv"))["damping_ratio"][0]));
    const ProgramRun damped =
      run_modes({"Modes/Number=2",
                 "Output/Graphics=false",
                 "Modes/Damped=true",
                 "Sections/aluminium/Stiffness-proportional damping=1e-4"});
    ASSERT_EQ(damped.exit_code, 0) << damped.errors;
    const Table table(path("out/modes.csv"));
    for (unsigned int i = 0; i < 2; ++i)
      {
        // Struts alone would have beta omega / 2; springs and loads take a
        // part.
        const double strut_damping = 1e-4 * M_PI * table["frequency"][i];
        EXPECT_LT(table["damping_ratio"][i], 1.6 * strut_damping);
        EXPECT_GT(table["damping_ratio"][i], 0.6 * strut_damping);
        EXPECT_NEAR(table["damped_frequency"][i] / table["frequency"][i],
                    std::sqrt(1 - std::pow(table["damping_ratio"][i], 2)),
                    1e-3);
      }
    EXPECT_NE(damped.output.find("Hz, ratio"), std::string::npos);
  }

  TEST_F(ModesProgram, LoadsThatFollowMakeThemComplex)
  {
    const Words follow = {"Loads/pressure/Direction=follows the joint",
                          "Modes/Number=2",
                          "Modes/Pictures=4"};
    ProgramRun  run    = run_modes(follow);
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"not symmetric", "Not counted"});
    const Table table(path("out/complex_modes.csv"));
    ASSERT_EQ(table.n_rows, 2u);
    for (unsigned int i = 0; i < 2; ++i)
      {
        EXPECT_GT(table["frequency"][i], 50);
        EXPECT_LT(table["residual"][i], 1e-6);
      }
    EXPECT_FALSE(std::filesystem::exists(path("out/modes.csv")));
    EXPECT_TRUE(std::filesystem::exists(path("out/mode_2_solution.pvd")));
  }

  TEST_F(ModesProgram, RelaxationsAreToldWhereTheyAreAskedFor)
  {
    const ProgramRun run = run_modes({"Modes/Number=1",
                                      "Output/Graphics=false",
                                      "Modes/Relaxations=2",
                                      "Lattice/Cells x=1",
                                      "Lattice/Cells y=1",
                                      "Connectors/spring/Law=maxwell",
                                      "Connectors/spring/Damping "
                                      "coefficient=2"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    // One for each element.
    expect_contains(run.output, {"1 of 2 relaxations", "not counted"});
    const Table table(path("out/relaxations.csv"));
    ASSERT_EQ(table.n_rows, 1u);
    // By itself it has 10 ms; the struts that hold it make it slower.
    EXPECT_GT(table["time"][0], 0.01);
    EXPECT_LT(table["residual"][0], 1e-6);
  }

  TEST_F(ModesProgram, StaticsHaveNone)
  {
    const ProgramRun run = run_modes({"Time/Scheme=static"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("needs inertia"), std::string::npos)
      << run.errors;
  }

  TEST_F(ModesProgram, ACheckDrawsTheLatticeOnly)
  {
    const ProgramRun run =
      run_auxfem({"--check",
                  std::string(AUXFEM_PRM_DIRECTORY) + "/modes.prm",
                  "--output",
                  "out"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_TRUE(std::filesystem::exists(path("out/lattice.vtu")));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("out")),
                            {}),
              1);
  }

  TEST_F(ModesProgram, BucklingLeavesATableAndPictures)
  {
    const ProgramRun run =
      run_auxfem({std::string(AUXFEM_PRM_DIRECTORY) + "/buckling.prm",
                  "--output",
                  "out",
                  "--set",
                  "Modes/Number=2",
                  "--set",
                  "Modes/Pictures=4"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("None is missing"), std::string::npos);
    EXPECT_NE(run.output.find("linear theory"), std::string::npos);
    const Table table(path("out/buckling.csv"));
    ASSERT_EQ(table.n_rows, 2u);
    EXPECT_NEAR(table["factor"][0], 1.284, 1e-3);
    EXPECT_GT(table["factor"][1], table["factor"][0]);
    EXPECT_LT(table["residual"][0], 1e-6);
    EXPECT_TRUE(std::filesystem::exists(path("out/mode_2_solution.pvd")));

    // Exactly, equilibria are stable until there and no further.
    for (const auto &[force, is_stable] :
         {std::pair("-1.27", true), std::pair("-1.30", false)})
      {
        const ProgramRun exact =
          run_modes({std::string("Loads/pressure/Force y=") + force,
                     "Modes/Number=1",
                     "Output/Graphics=false"});
        ASSERT_EQ(exact.exit_code, 0) << exact.errors;
        EXPECT_EQ(exact.output.find("unstable") == std::string::npos, is_stable)
          << force;
      }
    // One kind of results takes the place of the other.
    EXPECT_FALSE(std::filesystem::exists(path("out/buckling.csv")));
  }

  TEST_F(ModesProgram, BucklingNeedsNoDensity)
  {
    write("massless.prm",
          replaced(prm_text("buckling.prm"),
                   "    set Density         = 2700 kg/m3\n",
                   ""));
    const ProgramRun run = run_auxfem({"massless.prm",
                                       "--output",
                                       "out",
                                       "--set",
                                       "Modes/Number=1",
                                       "--set",
                                       "Output/Graphics=false"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NEAR(Table(path("out/buckling.csv"))["factor"][0], 1.284, 1e-3);
  }

  TEST_F(ModesProgram, BucklingRefusesScenesWithout)
  {
    const auto errors = [&](const Words &further) {
      Words words = {std::string(AUXFEM_PRM_DIRECTORY) + "/buckling.prm",
                     "--output",
                     "out"};
      words.insert(words.end(), further.begin(), further.end());
      const ProgramRun run = run_auxfem(words);
      EXPECT_EQ(run.exit_code, 1);
      return run.errors;
    };
    expect_contains(errors({"--set", "Effects/Large rotation=off"}),
                    {"Effects/Large rotation = off"});
    expect_contains(errors({"--set", "Loads/pressure/Force y=0"}), {"no load"});
    expect_contains(errors(
                      {"--set", "Loads/pressure/Direction=follows the joint"}),
                    {"follow"});
  }
} // namespace
