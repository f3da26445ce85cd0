#include <auxfem/parameters/text.h>
#include <auxfem/version.h>

#include <support/graphics_series.h>
#include <support/run_program.h>

#include <nlohmann/json.hpp>

namespace
{
  using namespace auxfem;
  using auxfem::Json;
  using namespace auxfem::testing_support;
  namespace fs = std::filesystem;

  class CommandLineProgram : public ProgramTest
  {};

  /** Whether a line is a parameter, as opposed to a comment or a subsection. */
  bool is_parameter(const std::string &line)
  {
    return line.find_first_not_of(' ') != std::string::npos &&
      line.compare(line.find_first_not_of(' '), 4, "set ") == 0;
  }

  /** @p text with every run of blanks as one: parameters are aligned. */
  std::string single_blanks(const std::string &text)
  {
    return std::regex_replace(text, std::regex(" +"), " ");
  }



  TEST_F(CommandLineProgram, Help)
  {
    const ProgramRun run = start_auxfem({"--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    expect_contains(run.output,
                    {"Usage: auxfem",
                     "mpirun",
                     "--help",
                     "--version",
                     "--check",
                     "--print-parameters",
                     "--set",
                     "--output",
                     "Exit code"});
    EXPECT_LE(count_lines(run.output), 25u) << "more than a screen";
  }



  TEST_F(CommandLineProgram, Version)
  {
    const ProgramRun run = start_auxfem({"--version"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_EQ(run.output, std::string("auxfem ") + version + "\n");
  }



  TEST_F(CommandLineProgram, ReferenceInDocIsThePrintedOne)
  {
    const ProgramRun run = run_auxfem({"--print-parameters=markdown"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.output,
              read_text(std::string(AUXFEM_PRM_DIRECTORY) +
                        "/../doc/user/parameters.md"))
      << "run: auxfem --print-parameters=markdown > doc/user/parameters.md";
  }



  TEST_F(CommandLineProgram, OtherProgramsCanReadTheReference)
  {
    const ProgramRun run = run_auxfem({"--print-parameters=json"});
    EXPECT_EQ(run.exit_code, 0);

    std::vector<Json> parameters;
    const auto        add_parameters = [&](const Json &owner) {
      for (const Json &parameter : owner.at("parameters"))
        parameters.push_back(parameter);
    };
    const Json reference = Json::parse(run.output);
    for (const Json &subsection : reference.at("subsections"))
      {
        add_parameters(subsection);
        if (subsection.contains("variants"))
          for (const Json &variant : subsection.at("variants"))
            add_parameters(variant);
      }
    // One entry for each row in the tables of the page.
    const std::string page = run_auxfem({"--print-parameters=markdown"}).output;
    std::size_t       n_rows = 0;
    for (auto at = page.find("\n| `"); at != std::string::npos;
         at      = page.find("\n| `", at + 1))
      ++n_rows;
    EXPECT_EQ(parameters.size(), n_rows);

    const auto step = std::find_if(parameters.begin(),
                                   parameters.end(),
                                   [](const Json &parameter) {
                                     return parameter.at("name") == "Time step";
                                   });
    ASSERT_NE(step, parameters.end());
    EXPECT_EQ(step->at("unit"), "s");
    EXPECT_EQ(step->at("required"), false);
    EXPECT_EQ(step->at("default"), "10 ms");
    EXPECT_EQ(step->at("allowed"), "a number > 0 in s");
  }



  TEST_F(CommandLineProgram, EveryPrintedParameterHasItsRange)
  {
    const ProgramRun run = run_auxfem({"--print-parameters"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");

    // Free text has no range; its description names the allowed values.
    const Words        free_text = {"set Title",
                                    "set Objective",
                                    "set Constraints",
                                    "set Method",
                                    "set Material",
                                    "set Constants",
                                    "set Joints",
                                    "set Struts",
                                    "set Between",
                                    "set Interlayer joints",
                                    "set Directory",
                                    "set File",
                                    "set Folder",
                                    "set Displacement x = 0",
                                    "set Displacement y = 0",
                                    "set Displacement z = 0",
                                    "set Schemes",
                                    "set Distribution",
                                    "set Profile",
                                    "set Components",
                                    "set Relation",
                                    "set Taper",
                                    "set Base",
                                    "set Grading",
                                    "set Path =",
                                    "set Joint sets",
                                    "set Strut sets",
                                    "set Pairs",
                                    "set Neighbour struts",
                                    "set Region",
                                    "set Missing struts",
                                    "set Map x",
                                    "set Map y",
                                    "set Map z",
                                    "set Force =",
                                    "set Moment =",
                                    "set NAME = TEXT",
                                    "set SUBSECTION/PARAMETER = TEXT",
                                    "set Results",
                                    "set Bodies",
                                    "set Input",
                                    "set Output ="};
    std::istringstream stream(run.output);
    std::string        line, comment, all_comments;
    unsigned int       n_parameters = 0;
    while (std::getline(stream, line))
      {
        const std::size_t start = line.find_first_not_of(' ');
        if (start == std::string::npos)
          comment.clear();
        else if (line[start] == '#')
          {
            comment += line.substr(start + 1);
            all_comments += line.substr(start + 1);
          }
        else if (is_parameter(line))
          {
            ++n_parameters;
            EXPECT_FALSE(comment.empty()) << line;
            const bool is_free_text =
              std::any_of(free_text.begin(),
                          free_text.end(),
                          [&](const std::string &name) {
                            return line.compare(start, name.size(), name) == 0;
                          });
            EXPECT_TRUE(is_free_text ||
                        comment.find("Allowed:") != std::string::npos)
              << line << comment;
            comment.clear();
          }
      }
    // The loop above has seen every subsection.
    EXPECT_GT(n_parameters, 17u);

    expect_contains(
      all_comments,
      {"a number > 0 in Pa",
       "a number > 0 in N/m",
       "a number > 0 in deg",
       "a whole number >= 1 and <= 6",
       "one of newmark, hht, generalized-alpha, energy-momentum"});
  }



  TEST_F(CommandLineProgram, CheckCountsAndDrawsTheLattice)
  {
    write("star.prm", data_text("star.prm"));
    const ProgramRun run =
      run_auxfem({"--check", "star.prm", "--output", "out"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");

    // 4 cells of 12 struts and 12 joints; of the 4 stub ends of a cell, the 4
    // inner ones of this array are shared by two. An element of order 3 has two
    // inner nodes, a node three unknowns, and 2 joints are clamped.
    for (const char *pattern : {"Joints +44\n",
                                "Struts +48\n",
                                "Elements +48 of order 3\n",
                                "Connectors +4\n",
                                "Unknowns +420, 414 of them free\n",
                                "MPI ranks +1\n"})
      EXPECT_TRUE(std::regex_search(run.output, std::regex(pattern)))
        << pattern << run.output;

    EXPECT_FALSE(fs::exists(path("output")));
    EXPECT_EQ(std::distance(fs::directory_iterator(path("out")), {}), 1);
    const GraphicsSeries lattice(path("out/lattice.vtu"), path("tables"));
    const Table         &points = lattice.points.at(0);
    // Two ends of each strut and each connector.
    EXPECT_EQ(points.n_rows, 2 * (48 + 4));
    unsigned int n_connectors = 0;
    for (unsigned int i = 0; i < points.n_rows; ++i)
      {
        n_connectors += points["connectors"][i] == 0;
        EXPECT_EQ(points["strut"][i] < 0, points["connectors"][i] == 0);
        EXPECT_EQ(points["height"][i] > 0, points["strut"][i] >= 0);
      }
    EXPECT_EQ(n_connectors, 8u);
  }



  TEST_F(CommandLineProgram, CheckRefusesAFolderThatCannotBe)
  {
    write("star.prm", data_text("star.prm"));
    write("file", "not a folder");
    const ProgramRun run =
      run_auxfem({"--check", "star.prm", "--output", "file/out"});
    EXPECT_EQ(run.exit_code, 1);
    expect_contains(run.errors,
                    {"Cannot write file/out/lattice.vtu", "--output DIR"});
  }



  TEST_F(CommandLineProgram, OverridesCountInOrderAndReachTheRun)
  {
    write("star.prm", data_text("star.prm"));
    const ProgramRun run = run_auxfem({"--set",
                                       "Time/End time=40 us",
                                       "--set",
                                       "Loads/hit/Force y=0",
                                       "star.prm",
                                       "--set=Time/End time=60 us",
                                       "--output=out",
                                       "--set",
                                       "Loads/side/Joints=top",
                                       "--set",
                                       "Loads/side/Force x=1 N"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.errors, "");

    const Table table = history();
    ASSERT_EQ(table.n_rows, 4u);
    EXPECT_DOUBLE_EQ(table["time"].back(), 60e-6);
    EXPECT_GT(table["top.ux"].back(), 0);
    expect_contains(single_blanks(read_text(path("out/parameters.prm"))),
                    {"set End time = 60 us",
                     "set Force x = 1 N",
                     "set Global refinements = default",
                     "set Directory = out"});
  }



  TEST_F(CommandLineProgram, OutputFolderOfTheSceneIsRelativeToTheCaller)
  {
    fs::create_directory(path("scenes"));
    write("scenes/star.prm",
          data_text("star.prm") +
            "\nsubsection Output\n  set Directory = a/b\nend\n");
    const ProgramRun run =
      run_auxfem({"scenes/star.prm", "--set", "Time/End time=40 us"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_TRUE(fs::exists(path("a/b/history.csv")));
  }



  TEST_F(CommandLineProgram, ARunRecordsItself)
  {
    write("star.prm", data_text("star.prm"));
    const Words overrides = {"--set",
                             "Time/End time=200 us",
                             "--set",
                             "Connectors/damper/Law=maxwell"};
    Words       arguments = {"star.prm", "--output", "out"};
    arguments.insert(arguments.end(), overrides.begin(), overrides.end());
    const ProgramRun run = run_auxfem(arguments);
    ASSERT_EQ(run.exit_code, 0) << run.errors;

    EXPECT_EQ(read_text(path("out/original.prm")), data_text("star.prm"));
    EXPECT_EQ(summary("exit_state"), "completed");
    EXPECT_EQ(summary("steps"), "10");
    EXPECT_DOUBLE_EQ(std::stod(summary("time_reached")), 200e-6);
    EXPECT_EQ(summary("joints"), "44");

    // The log has the printed lines, except for progress, which may be denser.
    std::istringstream stream(run.output);
    const std::string  log = read_text(path("out/log.txt"));
    for (std::string line; std::getline(stream, line);)
      if (line.find("  it ") == std::string::npos)
        expect_contains(log, {line + "\n"});

    // One rank does the same operations in the same order again.
    const ProgramRun again =
      run_auxfem({"out/parameters.prm", "--output", "again"});
    ASSERT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_text(path("again/history.csv")),
              read_text(path("out/history.csv")));
    expect_contains(single_blanks(read_text(path("again/parameters.prm"))),
                    {"set Law = maxwell"});
  }



  TEST_F(CommandLineProgram, RecordedParametersFindTheTablesOfTheScene)
  {
    fs::create_directory(path("scenes"));
    fs::copy(AUXFEM_TEST_DATA_DIRECTORY "/force.csv", path("scenes/force.csv"));
    write("scenes/star.prm",
          replaced(data_text("star.prm"), "= -4e3 * t", "= table: force.csv"));
    const ProgramRun run = run_auxfem({"scenes/star.prm",
                                       "--output",
                                       "results/out",
                                       "--set",
                                       "Time/End time=0.2 ms"});
    ASSERT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(history("results/out")["top.uy"].back(), 0);

    const ProgramRun again =
      run_auxfem({"results/out/parameters.prm", "--output", "again"});
    ASSERT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_EQ(read_text(path("again/history.csv")),
              read_text(path("results/out/history.csv")));
  }



  TEST_F(CommandLineProgram, ARunLeavesNothingOfAFormerOneInItsFolder)
  {
    write("star.prm", data_text("star.prm"));
    const auto run = [this](const std::string &interval) {
      return run_auxfem({"star.prm",
                         "--output",
                         "out",
                         "--set",
                         "Time/End time=80 us",
                         "--set",
                         "Output/Graphics interval=" + interval});
    };
    ASSERT_EQ(run("20 us").exit_code, 0);
    EXPECT_TRUE(fs::exists(path("out/solution/solution_00004.vtu")));
    write("out/notes.txt", "mine");

    ASSERT_EQ(run("0").exit_code, 0);
    EXPECT_TRUE(fs::exists(path("out/solution/solution_00001.vtu")));
    EXPECT_FALSE(fs::exists(path("out/solution/solution_00002.vtu")));
    EXPECT_EQ(read_text(path("out/notes.txt")), "mine");
  }
} // namespace
