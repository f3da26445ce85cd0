#include <support/graphics_series.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Runs with Analysis = static path. */
  class PathProgram : public ProgramTest
  {
  protected:
    ProgramRun run_path(const Words &overrides = {}) const
    {
      return run_shipped("path.prm", overrides);
    }
  };

  TEST_F(PathProgram, LeavesAPathAndItsSingularPoints)
  {
    const ProgramRun run = run_path();
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("1: bifurcation at load factor 0.6419"),
              std::string::npos);
    const Table path_table(path("out/history.csv"));
    const auto &factors = path_table["load_factor"];
    ASSERT_GT(path_table.n_rows, 8u);
    for (unsigned int i = 1; i < path_table.n_rows; ++i)
      EXPECT_GT(path_table["arc_length"][i], path_table["arc_length"][i - 1]);
    EXPECT_EQ(path_table["negative_eigenvalues"].back(), 0.);
    // The branch leans; linear theory predicts its start.
    EXPECT_GT(std::abs(path_table["top.ux"].back()), 5e-3);
    EXPECT_GT(factors.back(), 0.6419);

    const std::string singular = read_text(path("out/singular_points.csv"));
    EXPECT_NE(singular.find("number,kind,load_factor,arc_length"),
              std::string::npos);
    EXPECT_NE(singular.find("\n1,bifurcation,0.6419"), std::string::npos)
      << singular;
    EXPECT_EQ(std::count(singular.begin(), singular.end(), '\n'), 2);

    // A picture a point, but for that of the bifurcation, with the same
    // motions.
    const GraphicsSeries series(path("out/solution.pvd"), path("vtk"));
    ASSERT_EQ(series.datasets.n_rows, path_table.n_rows - 1);
    EXPECT_NEAR(series.datasets["time"].back(),
                path_table["arc_length"].back(),
                1e-9);
    const GraphicsSeries mode(path("out/singular_solution.pvd"), path("mode"));
    ASSERT_EQ(mode.datasets.n_rows, 1u);
    const auto &across = mode.points[0]["displacement.0"];
    EXPECT_GT(*std::max_element(across.begin(), across.end()), 1e-3);
  }

  TEST_F(PathProgram, ItsFilesGoWithIt)
  {
    ASSERT_EQ(run_path({"Path/Points=8"}).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(path("out/singular_points.csv")));
    const ProgramRun run =
      run_path({"Analysis=simulation", "Loads/pressure/Force y=-0.1 * t"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(path("out/singular_points.csv")));
    EXPECT_FALSE(std::filesystem::exists(path("out/singular_solution.pvd")));
  }

  TEST_F(PathProgram, ImperfectLatticesHaveNoBifurcation)
  {
    const ProgramRun run = run_path({"Imperfections/lean/Type=buckling mode",
                                     "Imperfections/lean/Amplitude=0.1 mm",
                                     "Output/Graphics=false"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("stress-free lattice by up to 0.0001"),
              std::string::npos)
      << run.output;
    const std::string singular = read_text(path("out/singular_points.csv"));
    EXPECT_EQ(std::count(singular.begin(), singular.end(), '\n'), 1);
    EXPECT_GT(std::abs(Table(path("out/history.csv"))["top.ux"].back()), 5e-3);
  }

  TEST_F(PathProgram, ResultsOfOtherRunsMayBeImperfections)
  {
    const ProgramRun leaning = run_path({"Analysis=simulation",
                                         "Output/Directory=leaning",
                                         "Output/Graphics=false",
                                         "Loads/pressure/Force x=0.01 * t",
                                         "Loads/pressure/Force y=0"});
    ASSERT_EQ(leaning.exit_code, 0) << leaning.errors;
    const Words      imperfect = {"Imperfections/lean/Type=result",
                                  "Imperfections/lean/Folder=leaning",
                                  "Imperfections/lean/Amplitude=0.1 mm",
                                  "Output/Graphics=false"};
    const ProgramRun run       = run_path(imperfect);
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("stress-free lattice by up to 0.0001"),
              std::string::npos)
      << run.output;
    // The lattice leans to the side of its imperfection.
    EXPECT_GT(Table(path("out/history.csv"))["top.ux"].back(), 5e-3);

    Words other_mesh = imperfect;
    other_mesh.push_back("Discretization/Order=2");
    const ProgramRun refused = run_path(other_mesh);
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.errors.find("another mesh"), std::string::npos)
      << refused.errors;
  }

  TEST_F(PathProgram, ACheckDrawsTheLatticeOnly)
  {
    const ProgramRun run =
      run_auxfem({"--check",
                  std::string(AUXFEM_PRM_DIRECTORY) + "/path.prm",
                  "--output",
                  "out"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_TRUE(std::filesystem::exists(path("out/lattice.vtu")));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path("out")),
                            {}),
              1);
  }
} // namespace
