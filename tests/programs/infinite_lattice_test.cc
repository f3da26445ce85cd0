#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  class InfiniteLatticeProgram : public ProgramTest
  {
  protected:
    InfiniteLatticeProgram()
    {
      std::string scene = prm_text("effective-response.prm");
      scene             = replaced(scene, "-0.25 * t", "-0.06 * t");
      write("scene.prm", replaced(scene, "0.02 s", "0.1 s"));
    }

    /** Expects the numbers of two tables up to @p allowed of the largest. */
    void expect_alike(const std::string &one,
                      const std::string &other,
                      const double       allowed) const
    {
      const Table first(path(one)), second(path(other));
      ASSERT_EQ(first.names, second.names);
      ASSERT_EQ(first.n_rows, second.n_rows);
      for (const std::string &name : first.names)
        for (unsigned int i = 0; i < first.n_rows; ++i)
          {
            if (std::isnan(first[name][i]) && std::isnan(second[name][i]))
              continue;
            EXPECT_NEAR(first[name][i],
                        second[name][i],
                        allowed * std::max(1., first.largest(name)))
              << name << " in row " << i;
          }
    }
  };

  TEST_F(InfiniteLatticeProgram, FollowsAMeanStrain)
  {
    const ProgramRun run = run_auxfem({"scene.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output,
                    {"Verdict: doubtful",
                     "loses stability at t = ",
                     "waves far longer than the period along (1, 0)"});
    const Table response(path("out/response.csv"));
    EXPECT_EQ(response.n_rows, 11u);
    EXPECT_NEAR(response["strain_xx"].back(), -0.06, 1e-12);
    EXPECT_GT(response["strain_xx"].back(), response["strain_yy"].front() - 1);
    EXPECT_NEAR(response["poisson_xy"].front(), -0.551, 0.001);
    EXPECT_LT(response["poisson_xy"].back(), -0.6);
    EXPECT_EQ(response["long_wave_stiffness"].front(), 1);
    EXPECT_LT(response["long_wave_stiffness"].back(), 0);
    const Table stability(path("out/stability.csv"));
    ASSERT_GE(stability.n_rows, 3u);
    EXPECT_NEAR(stability["strain_xx"].front(), -0.0391, 1e-4);
    for (const char *const file : {"response.units.csv",
                                   "stability.units.csv",
                                   "history.csv",
                                   "solution.pvd",
                                   "summary.json"})
      EXPECT_TRUE(fs::exists(path("out/" + std::string(file)))) << file;
    const Table history(path("out/history.csv"));
    EXPECT_EQ(history["strain_xx"], response["strain_xx"]);
    EXPECT_LT(history["stress_xx"].back(), 0);
  }

  TEST_F(InfiniteLatticeProgram, GoesOnAsTheWholeRun)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "whole"}).exit_code, 0);
    ASSERT_EQ(
      run_auxfem(
        {"scene.prm", "--output", "out", "--set", "Time/End time=0.5 s"})
        .exit_code,
      0);
    const ProgramRun rest =
      run_auxfem({"--resume", "out", "--set", "Time/End time=1 s"});
    ASSERT_EQ(rest.exit_code, 0) << rest.errors;
    expect_alike("whole/response.csv", "out/response.csv", 1e-9);
    expect_alike("whole/stability.csv", "out/stability.csv", 1e-9);
  }

  TEST_F(InfiniteLatticeProgram, TwoRanksFindTheSame)
  {
    ASSERT_EQ(run_auxfem({"scene.prm", "--output", "one"}).exit_code, 0);
    const ProgramRun run = run_auxfem_on(2, {"scene.prm", "--output", "two"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_alike("one/response.csv", "two/response.csv", 1e-8);
    expect_alike("one/stability.csv", "two/stability.csv", 1e-8);
  }

  TEST_F(InfiniteLatticeProgram, MistakesAreNamed)
  {
    const auto errors_with = [this](const Words &settings) {
      Words words = {"scene.prm", "--output", "out"};
      for (const std::string &setting : settings)
        words.insert(words.end(), {"--set", setting});
      const ProgramRun run = run_auxfem(words);
      EXPECT_EQ(run.exit_code, 1) << run.output;
      return run.errors;
    };
    expect_contains(errors_with({"Mean deformation/Strain xx=free"}),
                    {"nothing deforms the lattice", "Strain xx = -0.1 * t"});
    expect_contains(errors_with({"Mean deformation/Stress xx=1 kPa"}),
                    {"Mean deformation/Stress xx", "Strain xx is given"});
    expect_contains(errors_with({"Mean deformation/Strain yx=free",
                                 "Mean deformation/Strain xy=free"}),
                    {"can move without any resistance", "mean deformation y"});
    expect_contains(errors_with({"Gravity/Acceleration y=-10"}),
                    {"Gravity", "infinite lattice"});
    expect_contains(errors_with({"Mean deformation/Strain zz=0"}),
                    {"Mean deformation/Strain zz", "Dimension = 3"});
    // Rings around corners of the period are cut by its sides.
    expect_contains(errors_with({"Rigid parts/body/Struts=stubs"}),
                    {"Rigid parts/body", "next period"});
  }
} // namespace
