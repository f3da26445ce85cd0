#include <support/graphics_series.h>
#include <support/scene_text.h>

namespace
{
  using namespace auxfem::testing_support;

  /** Whole runs of scenes with plates. */
  class PlatesProgram : public ProgramTest
  {
  protected:
    /** A square frame that falls on a table, and a disc of 2 kg that falls on
     * it. */
    static SceneText falling_frame()
    {
      return SceneText()
        .frame("0 0; 1 0; 1 1; 0 1", "0 1; 1 2; 2 3; 3 0")
        .rectangle("bar", 0.05, 0.05, {1e7, 1000})
        .mesh(3)
        // Waves in struts that are hit are shorter than elements.
        .set("Output/Exit code by verdict", "false")
        .add("Initial velocities/fall", "Joints = all | Velocity y = -2")
        .add("Plates/table",
             "Shape = plane | Position = 0 -0.03 | Normal = 0 1")
        .add("Plates/disc",
             "Shape = sphere | Radius = 0.2 | Position = 0.6 1.23 | "
             "Displacement x = free | Displacement y = free | Mass = 2 | "
             "Initial velocity y = -3")
        .set("Contact/Friction coefficient", 0.2)
        .set("Contact/Slip velocity", 0.05)
        .set("Output/Graphics interval", "5 ms")
        .time(0.02, 1e-4, "newmark");
    }

    ProgramRun run_frame(const Words &overrides = {}) const
    {
      write("frame.prm", falling_frame().str());
      Words arguments = {"frame.prm", "--output", "out"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      return run_auxfem(arguments);
    }

    void expect_refused(const Words &overrides, const Words &parts) const
    {
      const ProgramRun run = run_frame(overrides);
      EXPECT_EQ(run.exit_code, 1) << run.output;
      expect_contains(run.errors, parts);
    }
  };

  TEST_F(PlatesProgram, AreInTheHistoryAndTheSummary)
  {
    const ProgramRun run = run_frame();
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    expect_contains(run.output, {"contact", "plates are given"});
    const Table table = history();
    // Nothing but the plates acts: the table on the frame and by it on the
    // disc.
    double impulse = 0, deepest = 0;
    for (unsigned int i = 1; i < table.n_rows; ++i)
      {
        impulse += 1e-4 * (table["disc.fy"][i] + table["disc.fy"][i - 1]) / 2;
        deepest = std::max({deepest,
                            table["table.penetration"][i],
                            table["disc.penetration"][i]});
        EXPECT_LE(table["table.fy"][i], 0);
        EXPECT_GE(table["disc.fy"][i], 0);
      }
    EXPECT_GT(impulse, 1);
    EXPECT_GT(deepest, 0);
    EXPECT_NEAR(std::stod(summary("largest_penetration_over_thickness")),
                deepest,
                1e-6);
    expect_contains(read_text(path("out/history.units.csv")),
                    {"\ndisc.uy,m,",
                     "\ntable.fy,N,",
                     "\ntable.penetration,1,"});
    // Friction has taken something.
    EXPECT_GT(table["friction.dissipated"].back(), 1e-3);
  }



  TEST_F(PlatesProgram, AreDrawnWithWhatTheyTouch)
  {
    const ProgramRun run = run_frame();
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const GraphicsSeries plates(path("out/plates.pvd"), path("vtk_plates")),
      contacts(path("out/contacts.pvd"), path("vtk_contacts"));
    ASSERT_EQ(plates.datasets.n_rows, 5u);
    ASSERT_EQ(contacts.datasets.n_rows, 5u);
    const Table table = history();
    bool        any   = false;
    for (unsigned int i = 0; i < 5; ++i)
      {
        const Table       &points = plates.points[i];
        const unsigned int row    = 50 * i;
        EXPECT_EQ(points.names,
                  (Words{"x",
                         "y",
                         "z",
                         "displacement.0",
                         "displacement.1",
                         "displacement.2",
                         "force.0",
                         "force.1",
                         "force.2",
                         "plate"}));
        for (unsigned int k = 0; k < points.n_rows; ++k)
          if (points["plate"][k] == 0)
            EXPECT_NEAR(points["y"][k], -0.03, 1e-7);
          else
            {
              EXPECT_NEAR(std::hypot(points["x"][k] - 0.6,
                                     points["y"][k] - 1.23),
                          0.2,
                          1e-6);
              EXPECT_NEAR(points["displacement.1"][k],
                          table["disc.uy"][row],
                          1e-6);
            }
        // Both ends of a line have the force of its point.
        double sum = 0;
        for (unsigned int k = 0; k < contacts.points[i].n_rows; ++k)
          {
            EXPECT_LT(contacts.points[i]["gap"][k], 0);
            sum += contacts.points[i]["force.1"][k] / 2;
          }
        any = any || contacts.points[i].n_rows > 0;
        // Numbers of six digits.
        EXPECT_NEAR(sum,
                    -table["table.fy"][row] - table["disc.fy"][row],
                    1e-5 * (1 + std::abs(table["table.fy"][row])));
      }
    EXPECT_TRUE(any);
  }



  TEST_F(PlatesProgram, RunIsTheSameOnTwoRanks)
  {
    ASSERT_EQ(run_frame({"Newton/Tolerance=1e-12"}).exit_code, 0);
    const Table alone = history();
    write("frame.prm", falling_frame().str());
    const ProgramRun run = run_auxfem_on(
      2,
      {"frame.prm", "--output", "out", "--set", "Newton/Tolerance=1e-12"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Table both = history();
    ASSERT_EQ(both.n_rows, alone.n_rows);
    // Newton's tolerance through 200 steps.
    for (const char *name : {"disc.ux", "disc.uy", "disc.fy", "table.fy"})
      for (unsigned int i = 0; i < alone.n_rows; ++i)
        EXPECT_NEAR(both[name][i],
                    alone[name][i],
                    1e-7 * (1 + std::abs(alone[name][i])))
          << name << ' ' << i;
  }



  TEST_F(PlatesProgram, ContactMayBeLeftOut)
  {
    const ProgramRun run = run_frame({"Effects/Contact=off"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const Table table = history();
    EXPECT_EQ(std::count(table.names.begin(), table.names.end(), "disc.fy"), 0);
    // All parts keep their velocity.
    EXPECT_NEAR(table["kinetic"].back(),
                table["kinetic"].front(),
                1e-9 * table["kinetic"].front());
    EXPECT_FALSE(std::filesystem::exists(path("out/contacts.pvd")));
  }



  TEST_F(PlatesProgram, WrongOnesAreRefused)
  {
    expect_refused({"Plates/table/Position=0 0.1"},
                   {"Plates/table",
                    "at rest strut 0 reaches 0.125 m into it",
                    "0.025 m",
                    "no strut deeper",
                    "Position",
                    "Normal"});
    expect_refused({"Plates/table/Normal=0 0"},
                   {"Plates/table/Normal = 0 0",
                    "no direction",
                    "set Normal = 0 1"});
    expect_refused({"Plates/table/Normal=0 0 1"},
                   {"Plates/table/Normal = 0 0 1",
                    "Give the components x and y alone",
                    "Dimension = 3"});
    expect_refused({"Plates/disc/Mass=0"},
                   {"Plates/disc/Mass = 0",
                    "Displacement x = free needs a mass"});
    expect_refused({"Plates/table/Initial velocity y=1"},
                   {"Plates/table/Initial velocity y = 1",
                    "Set Displacement y = free"});
    expect_refused({"Plates/disc/Shape=cylinder", "Plates/disc/Axis=0 0 1"},
                   {"Plates/disc/Shape = cylinder",
                    "Dimension = 3",
                    "`Shape = sphere`"});
    expect_refused({"Contact/Friction coefficient=-0.1"},
                   {"Contact/Friction coefficient = -0.1", "a number >= 0"});
    expect_refused({"Plates/all/Shape=plane",
                    "Plates/all/Position=0 -1",
                    "Plates/all/Normal=0 1"},
                   {"Plates/all", "named \"all\" already"});
    expect_refused({"Probes/disc=disc"},
                   {"Probes/disc", "Plates/disc", "same name"});
  }



  TEST_F(PlatesProgram, SectionsWithoutThicknessAreRefused)
  {
    write("frame.prm",
          falling_frame()
            .remove("Sections/bar")
            .given("bar", {3, 5, 0.7}, {1, 0.5})
            .str());
    const ProgramRun run = run_auxfem({"frame.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors,
                    {"Plates: strut 0 has no thickness", "Shape = rectangle"});
  }



  TEST_F(PlatesProgram, AnalysesThatCannotHaveThemSaySo)
  {
    for (const char *analysis : {"static path", "buckling"})
      expect_refused({std::string("Analysis=") + analysis},
                     {"Plates/table",
                      std::string("Analysis = ") + analysis,
                      "Scheme = static",
                      "Effects/Contact = off"});
    for (const char *analysis : {"modes", "frequency response"})
      expect_refused({std::string("Analysis=") + analysis},
                     {"Contact/Friction coefficient = 0.2",
                      std::string("Analysis = ") + analysis,
                      "Set it to 0"});
  }



  TEST_F(PlatesProgram, ModesHaveTheStiffnessOfWhatTouches)
  {
    // A mass of 10 kg on a light rod, EA / L = 4000 N/m, pressed on a wall with
    // 5 N: the end cap and the axis behind the end are in the wall, and their
    // law is the parabola.
    write("rod.prm",
          SceneText()
            .frame("0 0; 1 0", "0 1")
            .rectangle("rod", 0.02, 0.02, {1e7, 1})
            .support("ground", "0", "clamp")
            .mass("body", "1", 10)
            .load("push", "1", {"5", "0", "0"})
            .mesh(1)
            .add("Plates/wall",
                 "Shape = plane | Position = 1.01 0 | Normal = -1 0")
            .set("Effects/Large rotation", "off")
            .set("Newton/Tolerance", 1e-12)
            .set("Analysis", "modes")
            .set("Modes/Number", 2)
            .set("Modes/About", "static equilibrium")
            // Elements of order 1 are exact along the rod only.
            .set("Output/Exit code by verdict", "false")
            .time(1, 1, "newmark")
            .str());
    const ProgramRun run = run_auxfem({"rod.prm", "--output", "out"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    const double half = 0.01, k = 4000 / (2 * half * half), s = 0.01 * half,
                 rod = 4000, force = 5;
    const auto slope = [&](const double depth) {
      return rod + k * (half * depth + depth * depth / 2) / s;
    };
    double depth = 0;
    for (unsigned int i = 0; i < 30; ++i)
      depth -=
        (rod * depth + k * (half / 2 + depth / 6) * depth * depth / s - force) /
        slope(depth);
    const Table modes(path("out/modes.csv"));
    // A third of the mass of the rod swings too, 1.3e-5 of the body.
    EXPECT_NEAR(modes["frequency"][1],
                std::sqrt(slope(depth) / 10) / (4 * std::acos(0.)),
                2e-4);
  }



  TEST_F(PlatesProgram, FreePlateIsAMechanismInStatics)
  {
    write("frame.prm",
          falling_frame()
            .remove("Initial velocities")
            .remove("Plates/disc/Initial velocity y")
            .support("ground", "0, 1", "clamp")
            .set("Time/Scheme", "static")
            .str());
    const ProgramRun run = run_auxfem({"frame.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors,
                    {"not supported",
                     "of plate \"disc\"",
                     "Plates hold nothing"});
  }
} // namespace
