#include <support/run_program.h>

namespace
{
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  /** Bad input ends with one clear message and exit code 1. */
  class BadInput : public ProgramTest
  {
  protected:
    /** A message to the user fits on one screen and names nothing internal. */
    static void expect_refusal(const ProgramRun &run, const Words &parts)
    {
      EXPECT_EQ(run.exit_code, 1) << run.output << run.errors;
      expect_contains(run.errors, parts);
      EXPECT_GT(count_lines(run.errors), 0u);
      EXPECT_LE(count_lines(run.errors), 27u) << run.errors;
      expect_without(run.errors,
                     {"Stacktrace",
                      "An error occurred in line",
                      "violated condition",
                      "internal error",
                      "terminate called",
                      "---",
                      "#0"});
    }

    /** Runs the scene of tests/data with @p from replaced by @p to. */
    void expect_refusal_of(const std::string &from,
                           const std::string &to,
                           const Words       &parts) const
    {
      write("scene.prm", replaced(data_text("star.prm"), from, to));
      expect_refusal(run_auxfem({"scene.prm", "--output", "out"}), parts);
    }

    /** Runs the scene of tests/data with @p overrides. */
    void expect_refusal_with(const Words &overrides, const Words &parts) const
    {
      write("scene.prm", data_text("star.prm"));
      Words arguments = {"scene.prm", "--output", "out"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      expect_refusal(run_auxfem(arguments), parts);
    }

    /** File and line of the first line with @p text, as messages have it. */
    static std::string position_of(const std::string &text)
    {
      const std::string scene = data_text("star.prm");
      return "scene.prm:" +
        std::to_string(1 + count_lines(scene.substr(0, scene.find(text)))) +
        ":";
    }
  };

  TEST_F(BadInput, UnknownSection)
  {
    expect_refusal_of("subsection Time",
                      "subsection Tiem",
                      {position_of("subsection Time"),
                       "unknown subsection \"Tiem\"",
                       "did you mean \"Time\"?",
                       "Allowed here:",
                       "Connectors"});
  }



  TEST_F(BadInput, UnknownParameter)
  {
    expect_refusal_of("set End time ",
                      "set Endtime ",
                      {position_of("set End time"),
                       "Time/Endtime",
                       "unknown parameter",
                       "did you mean \"End time\"?",
                       "Allowed here:",
                       "Smallest time step"});
  }



  TEST_F(BadInput, ValueOutOfRange)
  {
    expect_refusal_of("= 0.2 mm",
                      "= -0.2 mm",
                      {position_of("0.2 mm"),
                       "Sections/steel/Radius = -0.2 mm",
                       "out of range",
                       "Allowed: a number > 0 in m"});
  }



  TEST_F(BadInput, ValueOutOfChoices)
  {
    expect_refusal_of("= kelvin-voigt",
                      "= kelvin-vogt",
                      {position_of("kelvin-voigt"),
                       "Connectors/damper/Law = kelvin-vogt",
                       "did you mean kelvin-voigt",
                       "standard-linear-solid"});
  }



  TEST_F(BadInput, WrongUnitWord)
  {
    expect_refusal_of("= 200 N/m",
                      "= 200 N",
                      {position_of("200 N/m"),
                       "Connectors/damper/Spring stiffness = 200 N",
                       "unit word \"N\" does not fit",
                       "unit words allowed:",
                       "N/m",
                       "kN/m"});
  }



  TEST_F(BadInput, MissingParameter)
  {
    expect_refusal_of("set Radius",
                      "# set Radius",
                      {"scene.prm",
                       "Sections/steel/Radius must be given",
                       "Radius of the circle"});
  }



  TEST_F(BadInput, SeveralMistakesAtOnce)
  {
    std::string scene = data_text("star.prm");
    scene = replaced(scene, "subsection Probes", "subsection Probe");
    scene = replaced(scene, "= 200 N/m", "= soft");
    scene = replaced(scene, "= 20 us", "= 20 ms");
    write("scene.prm", scene);
    expect_refusal(run_auxfem({"scene.prm"}),
                   {"3 mistakes",
                    "\"Probes\"",
                    "\"soft\" is not a number",
                    "Time/Time step = 0.02 s",
                    "Time/End time = 0.001 s"});
    EXPECT_FALSE(fs::exists(path("output")));
  }



  TEST_F(BadInput, ImpossibleGeometry)
  {
    expect_refusal_of("= 60 deg",
                      "= 40 deg",
                      {"scene.prm",
                       "Lattice",
                       "'star'",
                       "theta0 = 40 deg",
                       "b = L (sin(theta0) - cos(theta0)) > 0 fails",
                       "more than 45 deg and at most 90 deg"});
    write("general.prm",
          replaced(replaced(data_text("star.prm"),
                            "Cell          = star",
                            "Cell          = general star"),
                   "Opening angle = 60 deg",
                   "Side notch depth = 20 mm"));
    expect_refusal(run_auxfem({"general.prm"}),
                   {"general.prm",
                    "'general star'",
                    "w > L cos(theta0)",
                    "Half width = 0.009 m",
                    "Side notch depth = 0.02 m"});
  }



  TEST_F(BadInput, ConnectorToAJointThatDoesNotExist)
  {
    expect_refusal_with({"Connectors/damper/Between=3 500"},
                        {"Connectors/damper/Between",
                         "there is no joint 500",
                         "numbered from 0 to 43"});
  }



  TEST_F(BadInput, UnsupportedStructureNamesTheJointThatMoves)
  {
    // On a roller the lattice slides, all joints equally far.
    expect_refusal_with(
      {"Time/Scheme=static", "Supports/foundation/Type=roller x"},
      {"not supported", "horizontal displacement of joint", "Supports"});

    // Joint 2 moves farthest: the two bars it hinges on lie in one line.
    write("bars.prm",
          "subsection Lattice\n"
          "  set Cell   = frame\n"
          "  set Joints = 0 0; 2 0; 1 0\n"
          "  set Struts = 0 2; 2 1\n"
          "end\n"
          "subsection Sections\n"
          "  subsection bar\n"
          "    set Shape = circle\n"
          "    set Radius = 1 cm\n"
          "    set Young's modulus = 1 GPa\n"
          "  end\n"
          "end\n"
          "subsection Joints\n"
          "  subsection hinge\n"
          "    set Joints = 2\n"
          "  end\n"
          "end\n"
          "subsection Supports\n"
          "  subsection ends\n"
          "    set Joints = 0, 1\n"
          "    set Type   = pin\n"
          "  end\n"
          "end\n"
          "subsection Time\n"
          "  set Scheme = static\n"
          "end\n");
    expect_refusal(run_auxfem({"bars.prm", "--output", "out"}),
                   {"not supported",
                    "vertical displacement of joint 2 at (1, 0)",
                    "hinges"});
  }



  TEST_F(BadInput, EmptySet)
  {
    expect_refusal_of("set Joints = bottom",
                      "set Joints = y > 5",
                      {"Supports/foundation/Joints",
                       "\"y > 5\" selects no joint",
                       "The joints lie between"});
    expect_refusal_of("set Joints = bottom",
                      "set Joints = botom",
                      {"Supports/foundation/Joints",
                       "no set of joints named \"botom\"",
                       "bottom",
                       "Known sets of joints:"});
  }



  TEST_F(BadInput, UnreadableTable)
  {
    fs::copy(AUXFEM_TEST_DATA_DIRECTORY "/unreadable.csv",
             path("unreadable.csv"));
    expect_refusal_of("= -4e3 * t",
                      "= table: unreadable.csv",
                      {position_of("subsection hit"),
                       "Loads/hit/Force y",
                       "line 4 of the table",
                       "unreadable.csv",
                       "'strong' in column 2",
                       "not a number"});
    expect_refusal_of("= -4e3 * t",
                      "= table: lost.csv",
                      {position_of("subsection hit"),
                       "Loads/hit/Force y",
                       "cannot read the table",
                       "lost.csv"});
  }



  TEST_F(BadInput, ExpressionThatIsNone)
  {
    expect_refusal_of("= -4e3 * t",
                      "= -4e3 * q",
                      {position_of("subsection hit"),
                       "Loads/hit/Force y",
                       "token \"q\"",
                       "Allowed is an expression of the time t"});
  }



  TEST_F(BadInput, OutputFolderThatCannotBeMade)
  {
    // Below a regular file not even root can make a folder.
    write("scene.prm", data_text("star.prm"));
    write("file", "");
    expect_refusal(run_auxfem({"scene.prm", "--output", "file/out"}),
                   {"file/out",
                    "cannot be used",
                    "Not a directory",
                    "--output",
                    "Output/Directory"});
    expect_refusal(run_auxfem({"scene.prm", "--output", "file"}),
                   {"output folder `file`", "cannot be used", "--output"});
  }



  TEST_F(BadInput, SendsNoCommandsToTheTerminal)
  {
    const std::string escape = "\x1b]0;title\x07";
    write("a" + escape + ".prm",
          "set " + escape + " = 1\n" + data_text("star.prm"));
    const ProgramRun refused = run_auxfem({"--check", "a" + escape + ".prm"});
    expect_refusal(refused, {"a?]0;title?.prm"});
    EXPECT_EQ(refused.errors.find_first_of("\x1b\x07"), std::string::npos);

    write("scene.prm",
          replaced(data_text("star.prm"), "Small star lattice", escape));
    const ProgramRun run = run_auxfem(
      {"scene.prm", "--output", "out", "--set", "Time/End time=40 us"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    for (const std::string &text : {run.output, read_text(path("out/log.txt"))})
      {
        expect_contains(text, {"?]0;title?"});
        EXPECT_EQ(text.find_first_of("\x1b\x07"), std::string::npos);
      }
  }



  TEST_F(BadInput, MissingFile)
  {
    expect_refusal(start_auxfem({"lost.prm"}),
                   {"\"lost.prm\" cannot be opened", "check its name"});
    expect_refusal(run_auxfem({"--check", "."}), {"\".\" cannot be opened"});
  }



  TEST_F(BadInput, RigidPartsThatCannotMoveOrBeSolved)
  {
    const std::string bars = R"(
subsection Lattice
  set Cell   = frame
  set Joints = 0 0; 1 0; 2 0.5
  set Struts = 0 1; 1 2
end
subsection Rigid parts
  subsection bars
    set Struts = all
    set Parts  = single struts
    set Mass   = 1 kg
  end
end
subsection Supports
  subsection ground
    set Joints = 0
    set Type   = pin
  end
end
subsection Time
  set End time  = 10 ms
  set Time step = 1 ms
end
)";
    write("scene.prm", bars);
    const auto run_with = [this](const Words &overrides) {
      Words arguments = {"scene.prm", "--output", "out"};
      for (const std::string &text : overrides)
        {
          arguments.push_back("--set");
          arguments.push_back(text);
        }
      return run_auxfem(arguments);
    };
    ASSERT_EQ(run_with({}).exit_code, 0);
    const std::string history = read_text(path("out/history.csv"));

    // Along the first bar, away from its hinge.
    write("scene.prm",
          bars +
            "subsection Initial velocities\n  subsection kick\n"
            "    set Joints = 1, 2\n    set Velocity x = 2 m/s\n"
            "  end\nend\n");
    expect_refusal(run_with({}),
                   {"Initial velocities",
                    "move apart with 2 m/s",
                    "one rigid motion"});

    expect_refusal(run_auxfem({"--check", "scene.prm"}), {"move apart"});
    // A mistake costs no results of an earlier run.
    EXPECT_EQ(read_text(path("out/history.csv")), history);

    write("scene.prm", bars);
    expect_refusal(run_with({"Supports/ground/Type=clamp"}),
                   {"Supports/ground/Rotation z",
                    "a rigid part is hinged there",
                    "Type = pin"});
    expect_refusal(run_with({"Joints/spring/Joints=1",
                             "Joints/spring/Type=rotational spring",
                             "Joints/spring/Stiffness=1"}),
                   {"Joints/spring/Joints",
                    "a rigid part is hinged at joint 1"});
    expect_refusal(run_with({"Supports/ground/Joints=0, 1"}),
                   {"rigid part of joints 0 1", "supports", "Remove"});
    Words check = {"--check",
                   "scene.prm",
                   "--set",
                   "Supports/ground/Joints=0, 1"};
    expect_refusal(run_auxfem(check), {"rigid part of joints 0 1"});
    expect_refusal(run_with({"Time/Scheme=static"}),
                   {"not supported", "move without any resistance"});
  }



  TEST_F(BadInput, CommandLine)
  {
    write("scene.prm", data_text("star.prm"));
    expect_refusal(start_auxfem({"--frobnicate", "scene.prm"}),
                   {"Unknown option '--frobnicate'",
                    "Usage: auxfem",
                    "--check"});
    expect_refusal(run_auxfem({}),
                   {"No parameter file given", "Usage: auxfem"});
    expect_refusal(run_auxfem({"scene.prm", "other.prm"}),
                   {"Two parameter files", "scene.prm", "other.prm"});
    expect_refusal(run_auxfem({"scene.prm", "--output"}),
                   {"--output", "required"});
  }



  TEST_F(BadInput, Overrides)
  {
    expect_refusal_with({"Time"},
                        {"command line",
                         "override \"Time\" not understood",
                         "\"Subsection/Parameter=value\""});
    expect_refusal_with({"Time/Tiem step=1 us"},
                        {"command line: Time/Tiem step",
                         "unknown parameter",
                         "\"Time step\""});
    expect_refusal_with({"Time/Time step=1 kg"},
                        {"command line: Time/Time step = 1 kg",
                         "does not fit",
                         "ms"});
  }



  TEST_F(BadInput, LeavesTheResultsOfAFormerRunAlone)
  {
    write("scene.prm", data_text("star.prm"));
    const Words run = {"scene.prm",
                       "--output",
                       "out",
                       "--set",
                       "Time/End time=40 us"};
    ASSERT_EQ(run_auxfem(run).exit_code, 0);
    const std::string history = read_text(path("out/history.csv"));

    expect_refusal_with({"Supports/foundation/Joints=y > 5"}, {"no joint"});
    expect_refusal_with({"Connectors/damper/Between=3 500"}, {"no joint 500"});
    EXPECT_EQ(read_text(path("out/history.csv")), history);
    EXPECT_TRUE(fs::exists(path("out/summary.json")));
    EXPECT_TRUE(fs::exists(path("out/solution.pvd")));
  }
} // namespace
