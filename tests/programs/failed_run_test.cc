#include <support/graphics_series.h>

namespace
{
  using namespace auxfem::testing_support;

  /** A computation that fails ends with exit code 2 and keeps its results. */
  class FailedRun : public ProgramTest
  {
  protected:
    static void expect_failure(const ProgramRun &run, const Words &parts)
    {
      EXPECT_EQ(run.exit_code, 2) << run.output << run.errors;
      expect_contains(run.errors, parts);
      EXPECT_LE(count_lines(run.errors), 25u) << run.errors;
      expect_without(run.errors,
                     {"Stacktrace",
                      "An error occurred in line",
                      "internal error",
                      "terminate called"});
    }

    /** Everything in the output folder is whole, and ends at one time. */
    void expect_results_until(const double       time,
                              const Words       &reasons,
                              const double       x,
                              const double       y,
                              const std::string &probe) const
    {
      const Table table = history();
      EXPECT_NEAR(table["time"].back(), time, 1e-12);
      for (const std::string &name : table.names)
        for (const double value : table[name])
          EXPECT_TRUE(std::isfinite(value)) << name;

      expect_contains(summary("exit_state"), reasons);
      expect_contains(read_text(path("out/log.txt")), reasons);
      EXPECT_NEAR(std::stod(summary("time_reached")), time, 1e-12);

      const GraphicsSeries solution(path("out/solution.pvd"), path("vtk"));
      ASSERT_GE(solution.datasets.n_rows, 2u);
      EXPECT_NEAR(solution.datasets["time"].back(), time, 1e-5 * time);
      for (unsigned int i = 0; i < solution.datasets.n_rows; ++i)
        {
          const Table &points = solution.points[i];
          for (const std::string &name : points.names)
            for (const double value : points[name])
              ASSERT_TRUE(std::isfinite(value)) << name;

          const unsigned int row =
            row_at_time(table, solution.datasets["time"][i]);
          const auto rows = rows_at(points, x, y);
          ASSERT_FALSE(rows.empty());
          // Single precision keeps 6e-8 of a number.
          EXPECT_NEAR(points["displacement.1"][rows[0]],
                      table[probe + ".uy"][row],
                      1e-7 * std::abs(table[probe + ".uy"][row]));
        }
    }
  };

  TEST_F(FailedRun, LoadThatBecomesNoNumberInDynamics)
  {
    // Real up to 0.51 ms, in step 26 of 50.
    write("scene.prm",
          replaced(data_text("star.prm"),
                   "= -4e3 * t",
                   "= -80 * sqrt(0.51e-3 - t)"));
    expect_failure(start_auxfem({"scene.prm", "--output", "out"}),
                   {"Loads/hit/Force y",
                    "'-80 * sqrt(0.51e-3 - t)'",
                    "not a finite number at t = 0.0005",
                    "root"});
    EXPECT_EQ(history().n_rows, 26u);
    expect_results_until(0.5e-3,
                         {"Loads/hit/Force y", "not a finite number"},
                         0,
                         0.0409807621,
                         "apex");
  }



  TEST_F(FailedRun, MotionThatBecomesNoNumberInStatics)
  {
    write("scene.prm",
          data_text("star.prm") +
            "\nsubsection Supports\n"
            "  subsection press\n"
            "    set Joints = top\n"
            "    set Type = prescribed\n"
            "    set Displacement y = 1e-4 * log(1 - t / 0.31e-3)\n"
            "  end\n"
            "end\n");
    expect_failure(
      run_auxfem(
        {"scene.prm", "--output", "out", "--set", "Time/Scheme=static"}),
      {"Supports/press/Displacement y", "not a finite number"});
    expect_results_until(0.3e-3,
                         {"Supports/press/Displacement y"},
                         0,
                         0.0409807621,
                         "apex");
  }



  TEST_F(FailedRun, LoadThatIsNoNumberFromTheStart)
  {
    write("scene.prm", data_text("star.prm"));
    expect_failure(
      run_auxfem(
        {"scene.prm", "--output", "out", "--set", "Loads/hit/Force y=1 / t"}),
      {"Loads/hit/Force y: '1 / t'",
       "not a finite number at t = 0 s",
       "division by zero"});
    EXPECT_EQ(history().n_rows, 0u);
    EXPECT_EQ(history().names.front(), "time");
    expect_contains(summary("exit_state"), {"'1 / t'"});
    EXPECT_EQ(std::stod(summary("time_reached")), 0);
    expect_contains(summary("verdict"), {"not to be used"});
    expect_contains(read_text(path("out/summary.json")),
                    {"before its first step"});
  }



  TEST_F(FailedRun, CellThatDoesNotGetThroughItsFirstStep)
  {
    write("scene.prm", prm_text("cell-case-1.prm"));
    expect_failure(run_auxfem({"scene.prm",
                               "--output",
                               "out",
                               "--set",
                               "Reduced cell/Load=1e9",
                               "--set",
                               "Newton/Maximum iterations=1"}),
                   {"converge"});
    expect_contains(summary("verdict"), {"not to be used"});
    expect_contains(read_text(path("out/summary.json")),
                    {"before its first step"});
  }



  TEST_F(FailedRun, OutOfMemory)
  {
#ifdef AUXFEM_SANITIZERS
    GTEST_SKIP() << "The address sanitizer takes all addresses there are.";
#endif
    // Files of a former run stay until new ones replace them.
    write("scene.prm", data_text("star.prm"));
    const Words into_folder = {"scene.prm", "--output", "out"};
    ASSERT_EQ(start_auxfem(into_folder).exit_code, 0);
    const Table former = history();

    // Libraries and Open MPI take two thirds of this, the lattice more than the
    // rest.
    const std::string limited = "ulimit -v 1000000; exec ";
    const std::string words   = " '" AUXFEM_EXECUTABLE "' scene.prm --output "
                                "out --set 'Lattice/Cells x=300' --set "
                                "'Lattice/Cells y=300'";
    for (const std::string launcher : {"", AUXFEM_MPIRUN " -n 2"})
      {
        const ProgramRun run =
          run_program({"sh", "-c", limited + launcher + words});
        EXPECT_EQ(run.exit_code, 2) << run.errors;
        expect_contains(run.errors,
                        {"out of memory on rank ",
                         launcher.empty() ? " of 1," : " of 2,",
                         " MiB in use",
                         "fewer cells"});
        expect_without(run.errors, {"internal error", "terminate called"});
        EXPECT_EQ(history().n_rows, former.n_rows);
      }
  }



  TEST_F(FailedRun, DeadLoadBeyondTheLastEquilibrium)
  {
    // With the spring's length d at the angle w from the line to the ground
    // point, d^2 = 3 - 2 sqrt(2) cos(w), the moment about the pin is
    // k (d - 1) dd/dw; the largest one is the limit.
    double limit = 0;
    for (double w = 0; w < 3; w += 1e-4)
      {
        const double d = std::sqrt(3 - 2 * std::sqrt(2) * std::cos(w));
        limit = std::max(limit, (d - 1) * std::sqrt(2) * std::sin(w) / d);
      }

    write("scene.prm", data_text("overload.prm"));
    expect_failure(run_auxfem({"scene.prm", "--output", "out"}),
                   {"did not converge",
                    "Time/Smallest time step = 0.001 s",
                    "joint",
                    "All steps until then are in the output folder",
                    "smaller smallest step"});

    // The last piece tried is shorter than two smallest steps (1 ms each), and
    // the moment is t. The bar itself is stiff, but shortens by 1e-6.
    const double reached = std::stod(summary("time_reached"));
    EXPECT_LE(reached, limit + 1e-5);
    EXPECT_GE(reached, limit - 2e-3);

    expect_results_until(reached, {"did not converge"}, 1, 0, "tip");
  }



  TEST_F(FailedRun, StepAtItsFloorInDynamics)
  {
    write("scene.prm", data_text("star.prm"));
    // From 0.081 ms on, where a step ends, one iteration never suffices: 19 us
    // remain to the end of the step, and a quarter of them is too short.
    expect_failure(
      run_auxfem({"scene.prm",
                  "--output",
                  "out",
                  "--set",
                  "Loads/hit/Force y=if(t < 81e-6, 0, -50)",
                  "--set",
                  "Newton/Maximum iterations=1",
                  "--set",
                  "Time/Smallest time step=5 us",
                  "--set",
                  "Output/Graphics interval=0.02 ms"}),
      {"where a load or a prescribed motion jumps, did not converge "
       "even with dt = 9.5e-06 s (half of it would be less than",
       "1 iteration",
       "joint"});
    expect_results_until(0.081e-3,
                         {"did not converge"},
                         0,
                         0.0409807621,
                         "apex");
  }


  TEST_F(FailedRun, SuddenLoadInStatics)
  {
    write("scene.prm", data_text("star.prm"));
    // Viscous struts take a sudden load in a first step of 1e-5 of the others.
    expect_failure(run_auxfem({"scene.prm",
                               "--output",
                               "out",
                               "--set",
                               "Loads/hit/Force y=-1e9",
                               "--set",
                               "Time/Scheme=static",
                               "--set",
                               "Effects/Large rotation=on",
                               "--set",
                               "Newton/Maximum iterations=1",
                               "--set",
                               "Time/Smallest time step=5 us"}),
                   {"The step from t = 0 s, where a load or a prescribed "
                    "motion jumps, did not converge",
                    "which is less than Time/Smallest time step = 5e-06 s"});
  }



  TEST_F(FailedRun, ConnectorWhoseEndsMeet)
  {
    // Both ends are prescribed, so no free row sees the connector's force.
    write("scene.prm",
          "set Dimension = 2\n"
          "subsection Lattice\n"
          "  set Cell = frame\n"
          "  set Joints = 0 0; 0 0.2; 1 0\n"
          "  set Struts = 0 2; 1 2\n"
          "end\n"
          "subsection Sections\n"
          "  subsection all\n"
          "    set Shape = given\n"
          "    set Area = 0.01\n"
          "    set Shear area = 0.01\n"
          "    set Second moment of area = 2e-6\n"
          "    set Young's modulus = 1e6\n"
          "    set Poisson's ratio = 0\n"
          "    set Density = 100\n"
          "  end\n"
          "end\n"
          "subsection Supports\n"
          "  subsection wall\n"
          "    set Joints = 0, 2\n"
          "    set Type = clamp\n"
          "  end\n"
          "  subsection hand\n"
          "    set Joints = 1\n"
          "    set Type = prescribed\n"
          "    set Displacement x = 0\n"
          "    set Displacement y = -0.4 * t\n"
          "    set Rotation z = 0\n"
          "  end\n"
          "end\n"
          "subsection Connectors\n"
          "  subsection short one\n"
          "    set Law = kelvin-voigt\n"
          "    set Spring stiffness = 10 N/m\n"
          "    set Damping coefficient = 0.1 N s/m\n"
          "    set Between = 0 1\n"
          "  end\n"
          "end\n"
          "subsection Time\n"
          "  set Scheme = newmark\n"
          "  set End time = 1\n"
          "  set Time step = 0.01\n"
          "end\n"
          "subsection Probes\n"
          "  set moved = 1\n"
          "end\n");
    expect_failure(run_auxfem({"scene.prm", "--output", "out"}),
                   {"connector \"short one\"",
                    "joint 0 and joint 1",
                    "meet at t = 0.5 s"});
    const double reached = std::stod(summary("time_reached"));
    EXPECT_LT(reached, 0.5);
    EXPECT_GT(reached, 0.49);
    expect_results_until(reached, {"short one", "meet"}, 0, 0.2, "moved");
  }
} // namespace
