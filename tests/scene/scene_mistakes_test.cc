#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>

#include <support/messages.h>

namespace
{
  using namespace auxfem;
  using Words = std::vector<std::string>;

  const std::string lattice = "subsection Lattice\n"
                              "  set Cell = star\n"
                              "end\n";

  std::string subsection(const std::string &name, const std::string &content)
  {
    return "subsection " + name + "\n" + content + "\nend\n";
  }

  std::string group(const std::string &kind, const std::string &content)
  {
    return subsection(kind, subsection("name", content));
  }

  std::string section_text(const std::string &shape)
  {
    return group("Sections",
                 shape + "\nset Young's modulus = 1\nset Density = 1");
  }

  /** The message for a small scene (three lines) followed by @p text. */
  std::string message_for(const std::string &text, const Words &overrides = {})
  {
    return input_error_of(
      [&] { read_scene_from_text(lattice + text, "scene.prm", overrides); });
  }

  void expect_message(const std::string &text, const Words &parts)
  {
    expect_parts(message_for(text), parts);
  }

  TEST(SceneMistakes, TheSmallSceneHasNone)
  {
    EXPECT_EQ(message_for(""), "");
    EXPECT_EQ(message_for(section_text("set Shape = circle\nset Radius = 1")),
              "");
  }



  TEST(SceneMistakes, SupportsThatJumpWithInertia)
  {
    const auto support = [](const std::string &displacement) {
      return group("Supports",
                   "set Joints = top\nset Type = prescribed\n"
                   "set Displacement x = " +
                     displacement);
    };
    const std::string statics = subsection("Time", "set Scheme = static"),
                      from_equilibrium =
                        subsection("Time",
                                   "set Start from = static equilibrium");
    expect_message(support("0.01"),
                   {"Supports/name/Displacement x is 0.01",
                    "t = 0",
                    "Start from = static equilibrium"});
    expect_message(support("if(t < 0.5, t, t + 0.25)"),
                   {"Supports/name/Displacement x jumps at t = 0.5 s",
                    "from 0.5 to 0.75",
                    "Scheme = static"});
    expect_message(support("1/t"), {"Supports/name/Displacement x", "1/t"});
    EXPECT_EQ(message_for(support("0.01") + from_equilibrium), "");
    EXPECT_EQ(message_for(support("0.01 * cos(pi / 2)")), "");
    for (const std::string text : {"0.01", "if(t < 0.5, t, t + 0.25)"})
      EXPECT_EQ(message_for(support(text) + statics), "");
  }



  TEST(SceneMistakes, RigidParts)
  {
    EXPECT_EQ(message_for(group("Rigid parts", "set Struts = all")), "");
    EXPECT_EQ(message_for(group("Rigid parts",
                                "set Joints = all\nset Mass = 2 kg\n"
                                "set Rotary inertia = 3")),
              "");
    expect_message(group("Rigid parts", "set Mass = 1 kg"),
                   {"Rigid parts/name",
                    "either Struts or Joints",
                    "none of them is given"});
    expect_message(group("Rigid parts", "set Struts = all\nset Joints = all"),
                   {"Rigid parts/name", "either Struts or Joints", "both"});
    expect_message(group("Rigid parts",
                         "set Struts = all\nset Rotary inertia = 1"),
                   {"Rigid parts/name",
                    "Rotary inertia is given, but Mass = 0",
                    "Give the part a mass"});
    expect_message(group("Rigid parts",
                         "set Struts = all\nset Mass = 1 kg\n"
                         "set Rotary inertia = 0"),
                   {"Rigid parts/name/Rotary inertia = 0", "not be zero"});
    expect_message(group("Rigid parts", "set Struts = all\nset Mass = -1 kg"),
                   {"Rigid parts/name/Mass", "-1 kg", ">= 0"});
    expect_message(
      group("Rigid parts", "set Struts = all\nset Parts = bars"),
      {"Rigid parts/name/Parts", "bars", "struts that meet", "single struts"});
    expect_message(group("Rigid parts",
                         "set Struts = all\nset Elastic struts = glued"),
                   {"Rigid parts/name/Elastic struts", "hinged", "clamped"});
  }



  TEST(SceneMistakes, UnknownNames)
  {
    expect_message(subsection("Tiem", ""),
                   {"scene.prm:4",
                    "unknown subsection \"Tiem\"",
                    "did you mean \"Time\"",
                    "Discretization"});
    expect_message("set Titel = x\n", {"scene.prm:4: Titel", "\"Title\""});
    expect_message(subsection("Time", "set End tiem = 3"),
                   {"scene.prm:5: Time/End tiem",
                    "unknown parameter",
                    "did you mean \"End time\"",
                    "Allowed here:",
                    "Spectral radius"});
    expect_message(group("Masses", "set Joints = all\nset Mas = 1 kg"),
                   {"scene.prm:7: Masses/name/Mas", "\"Mass\""});
  }



  TEST(SceneMistakes, MisplacedEntriesAndSubsections)
  {
    expect_message(subsection("Sections", "set Struts = all"),
                   {"scene.prm:5: Sections/Struts", "name of your choice"});
    expect_message(subsection("Time", subsection("More", "")),
                   {"scene.prm:5: Time/More", "no subsection"});
    expect_message(subsection("Probes", subsection("More", "")),
                   {"scene.prm:5: Probes/More", "no subsection"});
    expect_message(group("Masses", subsection("More", "")),
                   {"scene.prm:6: Masses/name/More", "no subsection"});
  }



  TEST(SceneMistakes, ValuesThatAreNotAllowed)
  {
    expect_message(subsection("Time", "set Time step = -1 ms"),
                   {"scene.prm:5: Time/Time step = -1 ms",
                    "(-0.001 s)",
                    "out of range",
                    "a number > 0 in s"});
    expect_message(subsection("Time", "set Time step = soon"),
                   {"\"soon\" is not a number"});
    expect_message(subsection("Time", "set Time step ="),
                   {"scene.prm:5: Time/Time step", "no value"});
    expect_message(subsection("Time", "set Scheme = newmrak"),
                   {"Time/Scheme = newmrak",
                    "did you mean newmark",
                    "generalized-alpha"});
    expect_message(subsection("Discretization", "set Order = 7"),
                   {"Discretization/Order = 7", ">= 1 and <= 6"});
    expect_message(subsection("Discretization", "set Order = 2.5"),
                   {"not a whole number"});
    expect_message(subsection("Output", "set Graphics = maybe"),
                   {"one of true, false"});
    expect_message("set Dimension = 4\n",
                   {"scene.prm:4: Dimension = 4", "one of 2, 3"});
  }



  TEST(SceneMistakes, WrongUnitWords)
  {
    expect_message(section_text("set Shape = circle\nset Radius = 2 kg"),
                   {"scene.prm:7: Sections/name/Radius = 2 kg",
                    "unit word \"kg\" does not fit",
                    "unit words allowed: m, mm, cm, um, km, in, ft"});
    expect_message(section_text("set Shape = circle\nset Radius = 2 milimeter"),
                   {"unit word \"milimeter\" is not known"});
    expect_message(group("Loads", "set Joints = all\nset Force x = 2 mm"),
                   {"Loads/name/Force x", "\"mm\" does not fit", "kN"});
  }



  TEST(SceneMistakes, MissingEntries)
  {
    expect_message(
      group("Sections", "set Shape = circle"),
      {"scene.prm:5: Sections/name/Radius must be given: Radius of the circle."});
    expect_message(group("Sections", "set Shape = circle\nset Radius = 1 mm"),
                   {"Sections/name/Young's modulus",
                    "must be given",
                    "Material = NAME"});
    expect_message(subsection("Supports", subsection("a", "set Joints =")),
                   {"scene.prm:6: Supports/a/Joints must be given"});
    expect_message(subsection("Probes", "set top ="),
                   {"scene.prm:5: Probes/top", "no value"});
    try
      {
        read_scene_from_text("", "empty.prm");
        FAIL();
      }
    catch (const InputError &error)
      {
        expect_parts(error.what(),
                     {"empty.prm: Lattice/Cell must be given", "star"});
      }
  }



  TEST(SceneMistakes, EntriesOfAnotherChoice)
  {
    expect_message(section_text("set Shape = circle\nset Radius = 1\n"
                                "set Wall thickness = 0.1"),
                   {"scene.prm:8: Sections/name/Wall thickness",
                    "belongs to Shape = tube",
                    "here Shape = circle",
                    "Radius"});
    expect_message(group("Supports",
                         "set Joints = all\nset Displacement x = 1 mm"),
                   {"Supports/name/Displacement x",
                    "belongs to Type = prescribed",
                    "here Type = clamp"});
    expect_message(group("Connectors",
                         "set Law = spring\nset Spring stiffness = 1\n"
                         "set Damping coefficient = 1"),
                   {"Connectors/name/Damping coefficient",
                    "kelvin-voigt",
                    "here Law = spring"});
    // a misspelt choice is one mistake, its entries are not more of them
    const std::string message =
      message_for(section_text("set Shape = cirle\nset Radius = 1"));
    expect_parts(message, {"cirle"});
    EXPECT_EQ(message.find("Radius"), std::string::npos) << message;
  }



  TEST(SceneMistakes, NamesOfTheUser)
  {
    expect_message(
      subsection("Masses", subsection("a.b", "set Joints = all\nset Mass = 1")),
      {"scene.prm:5: Masses/a.b", "letters, digits"});
    expect_message(subsection("Probes", "set a/b = top"),
                   {"scene.prm:5: Probes/a/b", "letters, digits"});
    EXPECT_EQ(message_for(subsection("Probes", "set My probe_1-2 = top")), "");
  }



  TEST(SceneMistakes, Constants)
  {
    for (const char *text : {"F0",
                             "F0 = x",
                             "0F = 1",
                             "t = 1",
                             "xmin = 1",
                             "a = 1, a = 2",
                             "a = 1 furlong",
                             "a = 1,, b = 2"})
      expect_message("set Constants = " + std::string(text) + "\n",
                     {"scene.prm", "Constants"});
  }



  TEST(SceneMistakes, ContradictionsWithinASubsection)
  {
    expect_message(section_text("set Shape = tube\nset Outer radius = 1 mm\n"
                                "set Wall thickness = 2 mm"),
                   {"scene.prm:5: Sections/name", "2 mm", "1 mm"});
    expect_message(group("Supports", "set Joints = all\nset Type = prescribed"),
                   {"Supports/name", "everything is free"});
    const std::string spring = "set Law = spring\nset Spring stiffness = 1\n";
    for (const char *text : {"set Direction = 1 0",
                             "set Geometry = direction",
                             "set Ground offset = 1 0",
                             "set Between = ground: all"})
      expect_message(group("Connectors", spring + text), {"Connectors/name: "});
    EXPECT_EQ(message_for(group("Connectors",
                                spring +
                                  "set Between = ground: all\n"
                                  "set Ground offset = 0 -1 cm")),
              "");
  }



  TEST(SceneMistakes, TimeFunctionsThatCannotBeRead)
  {
    expect_message(group("Loads", "set Joints = all\nset Force x = 2*q"),
                   {"scene.prm:5", "Loads/name", "Force x", "2*q"});
  }



  TEST(SceneMistakes, StepsAndSchemes)
  {
    expect_message(subsection("Time", "set End time = 1 ms"),
                   {"Time/Time step = 0.01 s", "Time/End time = 0.001 s"});
    expect_message(subsection("Time", "set Smallest time step = 0.1"),
                   {"Time/Smallest time step = 0.1 s", "Time/Time step"});
    expect_message(subsection("Time", "set Time step = 1e-30"),
                   {"Time/Time step = 1e-30 s",
                    "makes 1e+30 steps",
                    "at most 1e+12 are allowed"});
    expect_message(subsection("Time", "set Newmark gamma = 0.4"),
                   {"Newmark gamma = 0.4", "2 beta >= gamma >= 1/2"});
    expect_message(subsection("Time", "set Newmark beta = 0.2"),
                   {"Newmark beta = 0.2", "2 beta >= gamma >= 1/2"});
    EXPECT_EQ(message_for(subsection("Time",
                                     "set Newmark beta = 0.3\n"
                                     "set Newmark gamma = 0.6")),
              "");
    EXPECT_EQ(message_for(subsection("Time",
                                     "set Scheme = hht\n"
                                     "set Newmark beta = 0")),
              "");
  }



  TEST(SceneMistakes, InertiaAndSchemes)
  {
    const std::string statics = subsection("Time", "set Scheme = static");
    expect_message(statics + subsection("Effects", "set Inertia = on"),
                   {"Effects/Inertia = on", "Time/Scheme = static"});
    expect_message(subsection("Effects", "set Inertia = off"),
                   {"Effects/Inertia = off", "Set Time/Scheme = static"});
    expect_message(statics + group("Initial velocities", "set Joints = all"),
                   {"Initial velocities/name", "static"});
    EXPECT_EQ(message_for(statics + subsection("Effects", "set Inertia = off")),
              "");
  }



  TEST(SceneMistakes, DensityIsNeededForInertiaAndWeight)
  {
    const std::string massless =
      group("Sections",
            "set Shape = circle\nset Radius = 1\nset Young's modulus = 1");
    const std::string statics = subsection("Time", "set Scheme = static");
    const std::string weight =
      subsection("Gravity", "set Acceleration y = -9.81");
    expect_message(massless,
                   {"Sections/name/Density must be given", "newmark"});
    expect_message(massless + statics + weight,
                   {"Sections/name/Density must be given", "Gravity"});
    EXPECT_EQ(message_for(massless + statics), "");
    EXPECT_EQ(message_for(massless + statics + weight +
                          subsection("Effects", "set Gravity = off")),
              "");
  }



  TEST(SceneMistakes, NamesOfColumns)
  {
    const std::string ball =
      subsection("Plates",
                 subsection("top",
                            "set Shape = sphere\nset Radius = 1\n"
                            "set Position = 0, 9"));
    expect_message(ball + subsection("Probes", "set top = top"),
                   {"Probes/top", "Plates/top", "same name"});
    expect_message(ball +
                     subsection("Supports",
                                subsection("top", "set Joints = top")),
                   {"Plates/top", "Supports/top", "same name"});
    // Displacements and reactions have different columns.
    EXPECT_EQ(message_for(
                subsection("Supports", subsection("top", "set Joints = top")) +
                subsection("Probes", "set top = top")),
              "");
  }



  TEST(SceneMistakes, OverridesAreNamedAsSuch)
  {
    expect_parts(message_for("", {"Time/Tiem step=1"}),
                 {"command line: Time/Tiem step", "\"Time step\""});
    expect_parts(message_for("", {"Time/Time step=1 kg"}),
                 {"command line: Time/Time step = 1 kg", "does not fit"});
    expect_parts(message_for("", {"Time step"}),
                 {"command line", "Subsection/Parameter=value"});
  }



  TEST(SceneMistakes, AllAreReportedAtOnce)
  {
    expect_message(subsection("Time",
                              "set Time step = 2 s\nset End time = 1 s") +
                     subsection("Tiem", "") +
                     group("Masses", "set Mass = heavy"),
                   {"scene.prm has 4 mistakes",
                    "Time/Time step",
                    "Tiem",
                    "Masses/name/Mass = heavy",
                    "Masses/name/Joints must be given"});
    std::string many;
    for (unsigned int i = 0; i < 50; ++i)
      many += "set Unknown " + std::to_string(i) + " = 1\n";
    expect_message(many, {"50 mistakes", "... and 40 more"});
  }
} // namespace
