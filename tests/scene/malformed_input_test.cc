#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>
#include <auxfem/simulation.h>

#include <gtest/gtest.h>
#include <support/run_program.h>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;

  /** An override of tests/data/star.prm and what the message must have. */
  struct Override
  {
    const char *assignment, *part;
  };

  /** A change of the text of that file and what the message must have. */
  struct Change
  {
    const char *from, *to, *part;
  };

  // clang-format off
  const Override overrides[] = {
    {"Dimension=4",
     "Dimension = 4: \"4\" is not among the choices"},
    {"Dimension=two",
     "Dimension = two: \"two\" is not among the choices"},
    {"Model=latice",
     "Model = latice: \"latice\" is not among the choices (did you mean lattice?)"},
    {"Constants=a = ",
     "Constants = ... a = ...: \"\" is not a number; allowed: a number, with or"},
    {"Constants=a = b",
     "Constants = ... a = b ...: \"b\" is not a number; allowed: a number, with or"},
    {"Constants=t = 3",
     "Constants = ... t = 3 ...: the name \"t\" has a meaning in expressions"},
    {"Constants=1a = 3",
     "Constants = ... 1a = 3 ...: not understood; write name = number, the name"},
    {"Constants=a = 1, a = 2",
     "Constants: \"a\" is given twice; remove one of them"},
    {"Titel=x",
     "Titel: unknown parameter; did you mean \"Title\"?"},
    {"Lattice/Cell=stra",
     "Lattice/Cell = stra: \"stra\" is not among the choices (did you mean star?)"},
    {"Lattice/Cells x=0",
     "Lattice/Cells x = 0: \"0\" is out of range"},
    {"Lattice/Cells x=-3",
     "Lattice/Cells x = -3: \"-3\" is out of range"},
    {"Lattice/Cells x=2.5",
     "Lattice/Cells x = 2.5: \"2.5\" is not a whole number"},
    {"Lattice/Cells x=",
     "Lattice/Cells x = : there is no value"},
    {"Lattice/Cells x=1e9",
     "Lattice/Cells x = 1e9: \"1e9\" is not a whole number"},
    {"Lattice/Cells x=99999999999999999999",
     "Lattice/Cells x = 99999999999999999999: \"99999999999999999999\" is not a"},
    {"Lattice/Cells y=two",
     "Lattice/Cells y = two: \"two\" is not a whole number"},
    {"Lattice/Cells z=2",
     "Lattice/Cells z = 2: this has a meaning in space only, but here Dimension"},
    {"Lattice/Opening angle=60 rad",
     "Lattice: the cell 'star' cannot have an opening angle theta0 = 3437.75"},
    {"Lattice/Opening angle=0 deg",
     "Lattice/Opening angle = 0 deg: \"0 deg\" (0 deg) is out of range"},
    {"Lattice/Opening angle=91 deg",
     "Lattice: the cell 'star' cannot have an opening angle theta0 = 91 deg."},
    {"Lattice/Opening angle=nan deg",
     "Lattice/Opening angle = nan deg: \"nan deg\" is not a number"},
    {"Lattice/Opening angle=60 deg deg",
     "Lattice/Opening angle = 60 deg deg: unit word \"deg deg\" does not fit"},
    {"Lattice/Opening angle=1e400 deg",
     "Lattice/Opening angle = 1e400 deg: \"1e400 deg\" is not a number"},
    {"Lattice/Rib length=-1 mm",
     "Lattice/Rib length: unknown parameter; did you mean \"Strut length\"?"},
    {"Lattice/File=x.msh",
     "Lattice/File: belongs to Cell = mesh file, but here Cell = star."},
    {"Sections/steel/Shape=cirkle",
     "Sections/steel/Shape = cirkle: \"cirkle\" is not among the choices (did you"},
    {"Sections/steel/Radius=",
     "Sections/steel/Radius must be given: Radius of the circle."},
    {"Sections/steel/Radius=0 mm",
     "Sections/steel/Radius = 0 mm: \"0 mm\" (0 m) is out of range"},
    {"Sections/steel/Radius=0.2 kg",
     "Sections/steel/Radius = 0.2 kg: unit word \"kg\" does not fit"},
    {"Sections/steel/Radius=0,2 mm",
     "Sections/steel/Radius = 0,2 mm: \",2 mm\" is no unit; write units like mm, N"},
    {"Sections/steel/Radius=inf mm",
     "Sections/steel/Radius = inf mm: \"inf mm\" is not a number"},
    {"Sections/steel/Radius=0x10 mm",
     "Sections/steel/Radius = 0x10 mm: \"x10 mm\" is no unit; write units like mm,"},
    {"Sections/steel/Radius=two mm",
     "Sections/steel/Radius = two mm: \"two mm\" is not a number"},
    {"Sections/steel/Width=2 mm",
     "Sections/steel/Width: belongs to Shape = rectangle, "},
    {"Sections/steel/Young's modulus=-200 GPa",
     "Sections/steel/Young's modulus = -200 GPa: \"-200 GPa\" (-2e+11 Pa) is out"},
    {"Sections/steel/Young's modulus=200 GPA",
     "Sections/steel/Young's modulus = 200 GPA: unit word \"GPA\" is not known;"},
    {"Sections/steel/Density=-1 kg/m3",
     "Sections/steel/Density = -1 kg/m3: \"-1 kg/m3\" (-1 kg/m3) is out of range"},
    {"Sections/steel/Poisson's ratio=0.7",
     "Sections/steel/Poisson's ratio = 0.7: \"0.7\" is out of range"},
    {"Sections/steel/Struts=edgse",
     "Sections/steel: there is no set of struts named \"edgse\"; did you mean"},
    {"Sections/steel/Struts=y > ymax",
     "Sections/steel: \"y > ymax\" selects no strut. The joints lie between"},
    {"Sections/steel/Struts=5000",
     "Sections/steel: there is no strut 5000. The lattice has 48 struts,"},
    {"Sections/steel/Struts=1 two",
     "Sections/steel: \"two\" in \"1 two\" is not the number of a strut. Allowed: the"},
    {"Connectors/damper/Law=",
     "Connectors/damper/Law must be given: Relation between force and extension."},
    {"Connectors/damper/Law=maxwel",
     "Connectors/damper/Law = maxwel: \"maxwel\" is not among the choices (did you"},
    {"Connectors/damper/Spring stiffness=-1 N/m",
     "Connectors/damper/Spring stiffness = -1 N/m: \"-1 N/m\" (-1 N/m) is out of"},
    {"Connectors/damper/Spring stiffness=200 N m",
     "Connectors/damper/Spring stiffness = 200 N m: unit word \"N m\" does not fit"},
    {"Connectors/damper/Damping coefficient=0.05 N/m",
     "Connectors/damper/Damping coefficient = 0.05 N/m: unit word \"N/m\" does not"},
    {"Connectors/damper/Between=3",
     "Connectors/damper/Between: \"3\" in \"3\" is not a pair of joint numbers."},
    {"Connectors/damper/Between=3 3",
     "Connectors/damper/Between: \"3 3\" links a joint with itself. Give two"},
    {"Connectors/damper/Between=3 4 5",
     "Connectors/damper/Between: \"3 4 5\" in \"3 4 5\" is not a pair of joint"},
    {"Connectors/damper/Between=3 -4",
     "Connectors/damper/Between: \"3 -4\" in \"3 -4\" is not a pair of joint"},
    {"Connectors/damper/Between=in-cel",
     "Connectors/damper/Between: this cell offers no joint pairs named \"in-cel\";"},
    {"Connectors/damper/Between=ground: nowhere",
     "Connectors/damper: a line from a joint to itself has no direction. Give a"},
    {"Connectors/damper/Between=ground:",
     "Connectors/damper: a line from a joint to itself has no direction. Give a"},
    {"Connectors/damper/Geometry=lin",
     "Connectors/damper/Geometry = lin: \"lin\" is not among the choices (did you"},
    {"Connectors/damper/Relaxation times=1 s",
     "Connectors/damper/Relaxation times: belongs to Law = generalized-maxwell,"},
    {"Supports/foundation/Joints=",
     "Supports/foundation/Joints must be given: Set of joints."},
    {"Supports/foundation/Joints=botom",
     "Supports/foundation/Joints: there is no set of joints named \"botom\"; did"},
    {"Supports/foundation/Joints=bottom + botom",
     "Supports/foundation/Joints: there is no set of joints named \"botom\"; did"},
    {"Supports/foundation/Joints=-1",
     "Supports/foundation/Joints: \"-1\" in \"-1\" is not the number of a joint."},
    {"Supports/foundation/Joints=1.5",
     "Supports/foundation/Joints: \"1.5\" in \"1.5\" is not the number of a joint."},
    {"Supports/foundation/Joints=y > 5",
     "Supports/foundation/Joints: \"y > 5\" selects no joint. The joints lie"},
    {"Supports/foundation/Joints=y >",
     "Supports/foundation/Joints: the condition \"y >\" cannot be used: Unexpected"},
    {"Supports/foundation/Joints=q > 0",
     "Supports/foundation/Joints: the condition \"q > 0\" cannot be used:"},
    {"Supports/foundation/Joints=y > 0 &&",
     "Supports/foundation/Joints: the condition \"y > 0 &&\" cannot be used:"},
    {"Supports/foundation/Joints=nearst: 0, 0",
     "Supports/foundation/Joints: \"nearst:\" in \"nearst: 0, 0\" is not known."},
    {"Supports/foundation/Joints=nearest: 0",
     "Supports/foundation/Joints: \"nearest: 0\": 1 coordinates are given. Write"},
    {"Supports/foundation/Joints=nearest: 0, 0, 0, 0",
     "Supports/foundation/Joints: \"nearest: 0, 0, 0, 0\": 4 coordinates are"},
    {"Supports/foundation/Joints=nearest: a, b",
     "Supports/foundation/Joints: \"nearest: a, b\": \"a\" is not a number. Write"},
    {"Supports/foundation/Joints=nearest: 1 kg, 0",
     "Supports/foundation/Joints: \"nearest: 1 kg, 0\": unit word \"kg\" does not"},
    {"Supports/foundation/Type=clmap",
     "Supports/foundation/Type = clmap: \"clmap\" is not among the choices (did"},
    {"Supports/foundation/Displacement x=1",
     "Supports/foundation/Displacement x: belongs to Type = prescribed, but here"},
    {"Supports/foundation/Rotation x=1",
     "Supports/foundation/Rotation x: belongs to Type = prescribed, but here"},
    {"Loads/hit/Joints=",
     "Loads/hit/Joints must be given: Set of joints."},
    {"Loads/hit/Force=1",
     "Loads/hit/Force: unknown parameter; did you mean \"Force x\" or \"Force y\" or"},
    {"Loads/hit/Force y=-4e3 * q",
     "Loads/hit/Force y: cannot understand '-4e3 * q': Unexpected token \"q\""},
    {"Loads/hit/Force y=(t",
     "Loads/hit/Force y: cannot understand '(t': Missing parenthesis"},
    {"Loads/hit/Force y=t)",
     "Loads/hit/Force y: cannot understand 't)': Unexpected parenthesis \")\" at"},
    {"Loads/hit/Force y=1 +",
     "Loads/hit/Force y: cannot understand '1 +': Unexpected end of expression"},
    {"Loads/hit/Force y=sin()",
     "Loads/hit/Force y: cannot understand 'sin()': Too few parameters for"},
    {"Loads/hit/Force y=sinus(t)",
     "Loads/hit/Force y: cannot understand 'sinus(t)': Unexpected token \"sinus\""},
    {"Loads/hit/Force y=3 t",
     "Loads/hit/Force y = 3 t: unit word \"t\" does not fit (in an expression,"},
    {"Loads/hit/Force y=t = 3",
     "Loads/hit/Force y: cannot understand 't = 3': = assigns; to compare, write"},
    {"Loads/hit/Force y=if(t > 0, 1)",
     "Loads/hit/Force y: cannot understand 'if(t > 0, 1)': Too few parameters"},
    {"Loads/hit/Force y=1,5",
     "Loads/hit/Force y: cannot understand '1,5': A comma stands outside of a"},
    {"Loads/hit/Force y=table:",
     "Loads/hit/Force y: 'table:' must be followed by the name of a file, e.g."},
    {"Loads/hit/Force y=table: lost.csv",
     "Loads/hit/Force y: cannot read the table ./lost.csv."},
    {"Loads/hit/Force y=table: lost.csv, 1",
     "Loads/hit/Force y: '1' is not a column of a table."},
    {"Loads/hit/Force y=table: lost.csv, two",
     "Loads/hit/Force y: 'two' is not a column of a table."},
    {"Loads/hit/Force y=table: /",
     "Loads/hit/Force y: cannot read the table /."},
    {"Loads/hit/Force z=1",
     "Loads/hit/Force z = 1: this has a meaning in space only, but here"},
    {"Loads/hit/Type=lines",
     "Loads/hit/Type = lines: \"lines\" is not among the choices (did you mean"},
    {"Loads/hit/Type=line",
     "Loads/hit/Joints: belongs to Type = joint, but here Type = line."},
    {"Loads/hit/Direction=follows",
     "Loads/hit/Direction = follows: \"follows\" is not among the choices (did you"},
    {"Masses/m/Mass=1",
     "Masses/m/Joints must be given: Set of joints."},
    {"Masses/m/Joints=top",
     "Masses/m/Mass must be given: Mass on every joint of the set."},
    {"Initial velocities/v/Velocity x=fast",
     "Initial velocities/v/Velocity x = fast: \"fast\" is not a number"},
    {"Gravity/Acceleration=1",
     "Gravity/Acceleration: unknown parameter; did you mean \"Acceleration x\" or"},
    {"Effects/Inertia=maybe",
     "Effects/Inertia = maybe: \"maybe\" is not among the choices"},
    {"Effects/Large rotations=maybe",
     "Effects/Large rotations: unknown parameter; did you mean \"Large rotation\"?"},
    {"Joints/h/Type=hing",
     "Joints/h/Type = hing: \"hing\" is not among the choices (did you mean hinge?)"},
    {"Joints/h/Stiffness=1 N m",
     "Joints/h/Stiffness: belongs to Type = rotational spring, but here Type ="},
    {"Rigid parts/r/Mass=-1 kg",
     "Rigid parts/r/Mass = -1 kg: \"-1 kg\" (-1 kg) is out of range"},
    {"Sets/s=joints bottom",
     "Sets/s: \"joints bottom\" does not say what it selects. Begin with \"joints:\""},
    {"Sets/s=knots: bottom",
     "Sets/s: \"knots: bottom\" does not say what it selects. Begin with \"joints:\""},
    {"Sets/s=joints:",
     "Sets/s: no joints are named. Allowed: the name of a set of joints, several"},
    {"Sets/all=joints: 1",
     "Sets/all: the lattice has a set of joints named \"all\" already. Choose"},
    {"Time/End time=0 s",
     "Time/End time = 0 s: \"0 s\" (0 s) is out of range"},
    {"Time/End time=-1 s",
     "Time/End time = -1 s: \"-1 s\" (-1 s) is out of range"},
    {"Time/End time=1 m",
     "Time/End time = 1 m: unit word \"m\" does not fit"},
    {"Time/Time step=0 s",
     "Time/Time step = 0 s: \"0 s\" (0 s) is out of range"},
    {"Time/Time step=2 ms",
     "Time/Time step = 0.002 s is longer than Time/End time = 0.001 s. Reduce"},
    {"Time/Smallest time step=1 s",
     "Time/Smallest time step = 1 s is longer than Time/Time step = 2e-05 s."},
    {"Time/Scheme=newmrak",
     "Time/Scheme = newmrak: \"newmrak\" is not among the choices (did you mean"},
    {"Time/Beta=0.25",
     "Time/Beta: unknown parameter."},
    {"Time/Spectral radius=2",
     "Time/Spectral radius = 2: \"2\" is out of range"},
    {"Time/Largest energy error=-1",
     "Time/Largest energy error = -1: \"-1\" is out of range"},
    {"Newton/Tolerance=0",
     "Newton/Tolerance = 0: \"0\" is out of range"},
    {"Newton/Tolerance=2",
     "Newton/Tolerance = 2: \"2\" is out of range"},
    {"Newton/Maximum iterations=0",
     "Newton/Maximum iterations = 0: \"0\" is out of range"},
    {"Newton/Maximum iterations=1000000000000",
     "Newton/Maximum iterations = 1000000000000: \"1000000000000\" is out of range"},
    {"Discretization/Order=0",
     "Discretization/Order = 0: \"0\" is out of range"},
    {"Discretization/Order=7",
     "Discretization/Order = 7: \"7\" is out of range"},
    {"Discretization/Global refinements=-1",
     "Discretization/Global refinements = -1: \"-1\" is out of range"},
    {"Discretization/Global refinements=40",
     "Discretization/Global refinements = 40: \"40\" is out of range"},
    {"Solver/Type=lu",
     "Solver/Type = lu: \"lu\" is not among the choices (did you mean klu?)"},
    {"Output/Graphics=maybe",
     "Output/Graphics = maybe: \"maybe\" is not among the choices"},
    {"Output/Graphics interval=-1 s",
     "Output/Graphics interval = -1 s: \"-1 s\" (-1 s) is out of range"},
    {"Output/History interval=0",
     "Output/History interval = 0: \"0\" is out of range"},
    {"Output/Time between rows=0 s",
     "Output/Time between rows = 0 s: \"0 s\" (0 s) is out of range"},
    {"Output/Segments per element=0",
     "Output/Segments per element = 0: \"0\" is out of range"},
    {"Output/Directory=",
     "Output/Directory = : there is no value"},
    {"Probes/apex=",
     "Probes/apex: there is no value"},
    {"Probes/apex=rigid:",
     "Probes/apex: no struts are named. Allowed: the name of a set of struts,"},
    {"Probes/apex=rigid: edges",
     "Probes/apex: none of the struts \"edges\" is rigid. Name struts of Rigid"},
    {"Reduced cell/Load=1",
     "subsection \"Reduced cell\" has no meaning with Model = lattice. Remove it"},
    {"Tiem/End time=1",
     "unknown subsection \"Tiem\"; did you mean \"Time\"?"},
    {"Time",
     "override \"Time\" not understood; expected \"Subsection/Parameter=value\" on"},
    {"Time/=1",
     "override \"Time/=1\" not understood; expected \"Subsection/Parameter=value\""},
    {"/=1",
     "override \"/=1\" not understood; expected \"Subsection/Parameter=value\" on"},
    {"=",
     "override \"=\" not understood; expected \"Subsection/Parameter=value\" on one"},
    {"a#b=1",
     "override \"a#b=1\" not understood; expected \"Subsection/Parameter=value\" on"},
    {"Supports/foundation/Joints=nearest: 1e30, 0",
     "\"nearest: 1e30, 0\" lies far from the lattice"},
    {"Supports/foundation/Joints=nearest: 1e200, 0",
     "\"nearest: 1e200, 0\" lies far from the lattice"},
    {"Supports/foundation/Joints=nearest: 0, 10",
     "\"nearest: 0, 10\" lies far from the lattice"},
    {"Time/Time step=1e-30 s",
     "Time/Time step = 1e-30 s makes 1e+27 steps until Time/End time"},
    {"Loads/hit/Force y=0/0",
     "'0/0' is not a finite number at t = 0"},
    {"Loads/hit/Force y=log(t)",
     "'log(t)' is not a finite number at t = 0"}};

  const Change changes[] = {
    {"subsection Time",
     "subsection Tiem",
     "unknown subsection \"Tiem\"; did you mean \"Time\"?"},
    {"subsection Time",
     "subsection",
     "line not understood: \"subsection\""},
    {"subsection Time",
     "subsecton Time",
     "line not understood: \"subsecton Time\""},
    {"subsection Time",
     "set Time",
     "line not understood: \"set Time\""},
    {"subsection Time",
     "end\nsubsection Time",
     "\"end\" without a subsection to close"},
    {"  set Time step = 20 us\nend",
     "  set Time step = 20 us",
     "subsection \"Time\" is not closed"},
    {"set End time  = 1 ms",
     "set End time  = 1 ms\n  set End time = 2 ms",
     "Time/End time is given a second time"},
    {"set End time  = 1 ms",
     "set End time  1 ms",
     "line not understood: \"set End time  1 ms\""},
    {"set End time  = 1 ms",
     "set = 1 ms",
     "line not understood: \"set = 1 ms\""},
    {"set End time  = 1 ms",
     "End time  = 1 ms",
     "line not understood: \"End time  = 1 ms\""},
    {"subsection Time",
     "include lost.prm\nsubsection Time",
     "the parameter file \"lost.prm\" cannot be opened"},
    {"subsection Time",
     "include .\nsubsection Time",
     "the parameter file \".\" cannot be opened"},
    {"set Graphics interval = 0.2 ms",
     "set Time between rows = 0.2 ms\n  set History interval = 3",
     "Output/Time between rows = 0.0002 s and Output/History interval = 3 "
     "steps both set the rows of history.csv. Remove one"},
    {"set Graphics interval = 0.2 ms\nend",
     "set Graphics interval = 0.2 ms\nend \\",
     "within a line continued by"},
    {"subsection steel",
     "subsection",
     "line not understood: \"subsection\""},
    {"set Radius          = 0.2 mm",
     "# none",
     "Sections/steel/Radius must be given"},
    {"set Cell          = star",
     "# none",
     "Lattice/Cell must be given"},
    {"subsection damper",
     "subsection damper\n    subsection inner\n    end",
     "inner"},
    {"set Title = Small star lattice",
     "set Title = Small\n\x01\x02",
     "line not understood"}};
  // clang-format on

  std::string scene_text()
  {
    return data_text("star.prm");
  }

  /** Error message of `auxfem --check`; empty if it accepts the scene. */
  std::string refusal(const std::string &text, const Words &assignments)
  {
    try
      {
        check(read_scene_from_text(text, "star.prm", assignments),
              MPI_COMM_WORLD);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    catch (const ComputationError &error)
      {
        return error.what();
      }
    return "";
  }

  void expect_message(const std::string &message,
                      const std::string &part,
                      const std::string &input)
  {
    EXPECT_NE(message.find(part), std::string::npos)
      << input << " is refused with: " << message;
    EXPECT_LE(count_lines(message), 24u) << input << ": " << message;
  }
} // namespace

TEST(MalformedInput, OverridesAreRefusedWithWords)
{
  EXPECT_EQ(refusal(scene_text(), {}), "");
  for (const auto &[assignment, part] : overrides)
    expect_message(refusal(scene_text(), {assignment}), part, assignment);
}

TEST(MalformedInput, FilesAreRefusedWithWords)
{
  for (const auto &[from, to, part] : changes)
    expect_message(refusal(replaced(scene_text(), from, to), {}), part, to);
  // An empty file lacks everything that a scene needs.
  for (const char *text : {"", "\n\n", "# a comment", "\xEF\xBB\xBF"})
    EXPECT_NE(refusal(text, {}), "") << text;
}

TEST(MalformedInput, LongValuesAreQuotedInPart)
{
  const std::string value(4000, 'y');
  for (const std::string name : {"Time/End time",
                                 "Sections/steel/Shape",
                                 "Lattice/Cells x",
                                 "Loads/hit/Force y"})
    {
      const std::string message = refusal(scene_text(), {name + "=" + value});
      EXPECT_NE(message, "");
      EXPECT_LT(message.size(), 3000u) << name;
      expect_message(message, name, name);
    }
}
