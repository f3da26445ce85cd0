#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/stat.h>

using namespace auxfem;

namespace
{
  const std::string portal_directory = AUXFEM_PRM_DIRECTORY "/../meshes";

  const std::string allow_script = "set Run gmsh script = true\n";

  using Indices = std::vector<unsigned int>;

  Lattice read(const std::string &file,
               const std::string &directory,
               const std::string &further_lines = "",
               const unsigned int dimension     = 2)
  {
    const auto cell =
      cell_from_text("mesh file",
                     "set File = " + file + "\n" + further_lines,
                     directory,
                     dimension);
    return make_array(cell->build(), {{1, 1, 1}});
  }

  /**
   * Writes @p text into a file with the name of the running test. gmsh ignores
   * a geometry of one line without line break.
   */
  std::string write(const std::string &text, const std::string &ending)
  {
    const auto *test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string file =
      "mesh_file_" + std::string(test->name()) + "." + ending;
    std::ofstream(AUXFEM_TEST_OUTPUT_DIRECTORY "/" + file) << text << '\n';
    return file;
  }

  Lattice lattice_of(const std::string &text,
                     const std::string &ending,
                     const unsigned int dimension = 2)
  {
    return read(write(text, ending),
                AUXFEM_TEST_OUTPUT_DIRECTORY,
                ending == "geo" ? allow_script : "",
                dimension);
  }

  std::string mesh_file_refusal(const std::string &text,
                                const std::string &ending)
  {
    return input_error_of([&]() { lattice_of(text, ending); });
  }

  /** A mesh in version 2.2 of gmsh's format from its nodes and elements. */
  std::string mesh(const std::vector<std::string> &nodes,
                   const std::vector<std::string> &elements,
                   const std::vector<std::string> &names = {})
  {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    const auto  add  = [&text](const std::string              &section,
                             const std::vector<std::string> &lines) {
      text += "$" + section + "\n" + std::to_string(lines.size()) + "\n";
      for (const auto &line : lines)
        text += line + "\n";
      text += "$End" + section + "\n";
    };
    if (!names.empty())
      add("PhysicalNames", names);
    add("Nodes", nodes);
    add("Elements", elements);
    return text;
  }

  void expect_portal(const Lattice &lattice)
  {
    const std::vector<dealii::Point<3>> joints = {{0, 0, 0},
                                                  {0, 1.5, 0},
                                                  {1.2, 1.9, 0},
                                                  {2.4, 1.5, 0},
                                                  {2.4, 0, 0}};
    ASSERT_EQ(lattice.joints.size(), joints.size());
    // Round-off of millimetres that become metres.
    for (unsigned int i = 0; i < joints.size(); ++i)
      EXPECT_NEAR(lattice.joints[i].distance(joints[i]), 0, 1e-15);

    ASSERT_EQ(lattice.struts.size(), 4u);
    for (unsigned int i = 0; i < 4; ++i)
      EXPECT_EQ(lattice.struts[i].joints,
                (std::array<unsigned int, 2>{{i, i + 1}}));
    EXPECT_EQ(lattice.struts[0].sagitta, 0);
    EXPECT_EQ(lattice.struts[3].sagitta, 0);
    // gmsh leaves the middle node on the circle of radius 2 m up to round-off
    // of coordinates of 2000 mm (4e-16 m), seen from the middle of the arc ten
    // times as far away as the arc rises over its chord.
    const double length = 2. * std::acos(0.8);
    EXPECT_NEAR(lattice.length(lattice.struts[1]), length, 1e-13);
    EXPECT_NEAR(lattice.length(lattice.struts[2]), length, 1e-13);
    EXPECT_GT(lattice.struts[1].sagitta, 0);
    EXPECT_GT(lattice.struts[2].sagitta, 0);

    EXPECT_EQ(lattice.joint_sets.at("feet"), (Indices{0, 4}));
    EXPECT_EQ(lattice.joint_sets.at("crown"), (Indices{2}));
    EXPECT_EQ(lattice.joint_sets.at("bottom"), (Indices{0, 4}));
    EXPECT_EQ(lattice.joint_sets.at("top"), (Indices{2}));
    EXPECT_EQ(lattice.strut_sets.at("all"), (Indices{0, 1, 2, 3}));
    EXPECT_EQ(lattice.strut_sets.at("legs"), (Indices{0, 3}));
    EXPECT_EQ(lattice.strut_sets.at("arch"), (Indices{1, 2}));
    EXPECT_EQ(lattice.strut_sets.at("left half"), (Indices{0, 1}));
  }
} // namespace

TEST(MeshFileCell, Portal)
{
  expect_portal(read("portal.msh", portal_directory, "set Length unit = 1 mm"));
}

TEST(MeshFileCell, MeshesAGeometry)
{
  expect_portal(read("portal.geo",
                     portal_directory,
                     allow_script + "set Length unit = 1 mm"));
}

TEST(MeshFileCell, OptionsOfOneGeometryDoNotReachTheNext)
{
  read("portal.geo", portal_directory, allow_script);
  const auto lattice = lattice_of("Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0};"
                                  "Point(3) = {1, 0, 0};"
                                  "Circle(1) = {1, 3, 2};"
                                  "Transfinite Curve {1} = 3;",
                                  "geo");
  ASSERT_EQ(lattice.struts.size(), 2u);
  for (const auto &strut : lattice.struts)
    EXPECT_EQ(strut.sagitta, 0);
}

TEST(MeshFileCell, NumbersJointsByNodeAndStrutsByElement)
{
  const auto lattice =
    lattice_of(mesh({"9 0 0 0", "4 1 0 0", "7 1 1 0", "2 5 5 0"},
                    {"8 1 2 0 1 7 9", "3 1 2 0 2 4 7"}),
               "msh");
  ASSERT_EQ(lattice.joints.size(), 3u);
  EXPECT_EQ(lattice.joints[0], dealii::Point<3>(1, 0, 0));
  EXPECT_EQ(lattice.joints[1], dealii::Point<3>(1, 1, 0));
  EXPECT_EQ(lattice.joints[2], dealii::Point<3>(0, 0, 0));
  ASSERT_EQ(lattice.struts.size(), 2u);
  EXPECT_EQ(lattice.struts[0].joints, (std::array<unsigned int, 2>{{0, 1}}));
  EXPECT_EQ(lattice.struts[1].joints, (std::array<unsigned int, 2>{{1, 2}}));
}

TEST(MeshFileCell, LinesRepeatedForTheirGroupsAreOneStrut)
{
  const auto lattice = lattice_of(
    mesh({"1 0 0 0", "2 1 0 0", "3 2 0 0"},
         {"1 1 2 5 1 1 2", "2 1 2 6 1 2 1", "3 1 2 6 2 2 3", "4 15 2 3 3 3"},
         {"1 5 \"web\""}),
    "msh");
  ASSERT_EQ(lattice.struts.size(), 2u);
  EXPECT_EQ(lattice.strut_sets.at("web"), (Indices{0}));
  EXPECT_EQ(lattice.strut_sets.at("group 6"), (Indices{0, 1}));
  EXPECT_EQ(lattice.joint_sets.at("group 3"), (Indices{2}));
}

TEST(MeshFileCell, AGroupTakesTheNameOfASide)
{
  const auto lattice =
    lattice_of(mesh({"1 0 0 0", "2 1 0 0", "3 1 1 0"},
                    {"1 1 2 0 1 1 2", "2 1 2 0 2 2 3", "3 15 2 8 3 2"},
                    {"0 8 \"right\""}),
               "msh");
  EXPECT_EQ(lattice.joint_sets.at("right"), (Indices{1}));
  EXPECT_EQ(lattice.joint_sets.at("left"), (Indices{0}));
}

TEST(MeshFileCell, ArcsLeadThroughTheirMiddleNode)
{
  // Unit circle: a quarter to the left of its direction with its node off the
  // middle, a half to the right, three quarters; then a straight line. A node
  // at 16 digits is off the circle by round-off, which the sagitta shows up to
  // ten times as large.
  const auto lattice = lattice_of(mesh({"1 1 0 0",
                                        "2 0 1 0",
                                        "3 0 -1 0",
                                        "4 0.8 0.6 0",
                                        "5 -1 0 0",
                                        "6 -0.6 0.8 0",
                                        "7 0.6 -0.8 0",
                                        "8 3 2 0",
                                        "9 2.1 1.4 0",
                                        "10 0 0 0"},
                                       {"1 8 2 0 1 2 1 4",
                                        "2 8 2 0 2 3 2 7",
                                        "3 8 2 0 3 1 3 6",
                                        "4 8 2 0 4 10 8 9",
                                        "5 8 2 0 5 3 2 5"}),
                                  "msh");
  ASSERT_EQ(lattice.struts.size(), 5u);
  const double root = std::sqrt(0.5);
  EXPECT_NEAR(lattice.struts[0].sagitta, 1 - root, 1e-15);
  EXPECT_NEAR(lattice.struts[1].sagitta, -1, 2e-15);
  EXPECT_NEAR(lattice.struts[2].sagitta, -(1 + root), 1e-14);
  EXPECT_EQ(lattice.struts[3].sagitta, 0);
  EXPECT_NEAR(lattice.struts[4].sagitta, 1, 2e-15);
  EXPECT_NEAR(lattice.length(lattice.struts[2]),
              1.5 * dealii::numbers::PI,
              1e-14);
}

TEST(MeshFileCell, InSpaceArcsKeepTheirPlane)
{
  // A strut along z; quarters of unit circles in the planes x-z and at
  // 45 deg to it; an arc in the plane z = 2.
  const double h      = std::sqrt(0.5);
  const auto   number = [](const double x) {
    std::ostringstream text;
    text.precision(17);
    text << x;
    return text.str();
  };
  const auto lattice =
    lattice_of(mesh({"1 1 0 0",
                     "2 0 0 1",
                     "3 " + number(h) + " 0 " + number(h),
                     "4 " + number(h) + ' ' + number(h) + " 0",
                     "5 0.5 0.5 " + number(h),
                     "6 0 0 2",
                     "7 2 0 2",
                     "8 1 1 2"},
                    {"1 1 2 0 1 2 6",
                     "2 8 2 0 2 1 2 3",
                     "3 8 2 0 3 4 2 5",
                     "4 8 2 0 4 6 7 8"}),
               "msh",
               3);
  ASSERT_EQ(lattice.struts.size(), 4u);
  EXPECT_EQ(lattice.struts[0].sagitta, 0);
  EXPECT_NEAR(lattice.struts[3].sagitta, 1, 1e-15);
  EXPECT_EQ(lattice.struts[3].normal, dealii::Point<3>(0, 0, 1));
  // Middles of the quarters; round-off as for arcs in the plane.
  const std::vector<dealii::Point<3>> middles = {{h, 0, h}, {0.5, 0.5, h}};
  for (const unsigned int arc : {1, 2})
    {
      const Strut &strut = lattice.struts[arc];
      EXPECT_NEAR(std::abs(strut.sagitta), 1 - h, 1e-15);
      EXPECT_NEAR(strut.normal.norm(), 1, 1e-15);
      EXPECT_NEAR(lattice.length(strut), dealii::numbers::PI_2, 1e-14);
      dealii::Point<3>     position;
      dealii::Tensor<1, 3> tangent;
      lattice.axis(strut, 0.5, position, tangent);
      EXPECT_NEAR(position.distance(middles[arc - 1]), 0, 1e-15);
    }
  EXPECT_EQ(lattice.joint_sets.at("back"), (Indices{0, 2}));
  EXPECT_EQ(lattice.joint_sets.at("front"), (Indices{3, 4}));
}

TEST(MeshFileCell, APlanarMeshIsTheSameInSpace)
{
  const std::string lines   = "set Length unit = 1 mm";
  const auto        planar  = read("portal.msh", portal_directory, lines);
  const auto        spatial = read("portal.msh", portal_directory, lines, 3);
  EXPECT_EQ(spatial.joints, planar.joints);
  ASSERT_EQ(spatial.struts.size(), planar.struts.size());
  for (unsigned int i = 0; i < planar.struts.size(); ++i)
    {
      EXPECT_EQ(spatial.struts[i].joints, planar.struts[i].joints);
      EXPECT_EQ(spatial.struts[i].sagitta, planar.struts[i].sagitta);
      EXPECT_EQ(spatial.struts[i].normal, planar.struts[i].normal);
    }
}

TEST(MeshFileCell, RefusesFilesItCannotRead)
{
  const auto missing =
    input_error_of([]() { read("no such.msh", portal_directory); });
  EXPECT_TRUE(contains(missing, "Lattice/File: cannot read the mesh file"))
    << missing;
  EXPECT_TRUE(contains(missing, "/no such.msh")) << missing;
  EXPECT_TRUE(contains(missing, "folder of the parameter file")) << missing;
  EXPECT_TRUE(contains(input_error_of([]() { read(".", portal_directory); }),
                       "cannot read the mesh file"));
}

TEST(MeshFileCell, ReportsErrorsOfGmsh)
{
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto syntax =
    mesh_file_refusal("Point(1) = {0, 0, 0};\nPoint(2) = {0, 1;\n"
                      "\x01\x02",
                      "geo");
  const auto node =
    mesh_file_refusal(mesh({"1 0 0 0", "2 1 0 0"}, {"1 1 2 0 1 1 5"}), "msh");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");

  EXPECT_TRUE(contains(syntax, "Lattice/File: gmsh cannot read")) << syntax;
  EXPECT_TRUE(contains(syntax, "line 2: syntax error")) << syntax;
  EXPECT_TRUE(contains(node, "line 11: element 1 has node 5")) << node;

  // A file that cannot be read leaves no traces in gmsh.
  read("portal.geo", portal_directory, allow_script);
}

TEST(MeshFileCell, RefusesMeshesWithoutLines)
{
  const auto triangle =
    mesh_file_refusal(mesh({"1 0 0 0", "2 1 0 0", "3 0 1 0"},
                           {"1 2 2 0 1 1 2 3"}),
                      "msh");
  EXPECT_TRUE(contains(triangle, "no line elements")) << triangle;
  EXPECT_TRUE(contains(mesh_file_refusal("Point(1) = {0, 0, 0};", "geo"),
                       "no line elements"));
  EXPECT_TRUE(
    contains(mesh_file_refusal(mesh({}, {}), "msh"), "no line elements"));
}

TEST(MeshFileCell, RefusesLinesOfHigherOrder)
{
  const auto message =
    mesh_file_refusal(mesh({"1 0 0 0", "2 3 0 0", "3 1 0 0", "4 2 0 0"},
                           {"6 26 2 0 1 1 2 3 4"}),
                      "msh");
  EXPECT_TRUE(contains(message, "line elements of 4 nodes")) << message;
  EXPECT_TRUE(contains(message, "element 6")) << message;
  EXPECT_TRUE(contains(message, "Mesh.ElementOrder")) << message;
}

TEST(MeshFileCell, RefusesNodesOutsideThePlane)
{
  const auto message =
    mesh_file_refusal(mesh({"1 0 0 0", "2 1 0 0.25"}, {"1 1 2 0 1 1 2"}),
                      "msh");
  EXPECT_TRUE(contains(message, "node 2 lies at (1, 0, 0.25) m")) << message;
  EXPECT_TRUE(contains(message, "Dimension = 3")) << message;
  EXPECT_TRUE(
    contains(mesh_file_refusal(mesh({"1 0 0 0", "2 1 0 0", "3 0.5 0 1"},
                                    {"1 8 2 0 1 1 2 3"}),
                               "msh"),
             "node 3 lies at"));
}

TEST(MeshFileCell, RefusesStrutsWithoutLength)
{
  const auto message =
    mesh_file_refusal(mesh({"1 0 0 0", "2 1 0 0", "3 1 0 0"},
                           {"1 1 2 0 1 1 2", "2 1 2 0 1 2 3"}),
                      "msh");
  EXPECT_TRUE(contains(message, "line element 2 (from node 2 to node 3)"))
    << message;
  EXPECT_TRUE(contains(message, "zero length")) << message;
  EXPECT_TRUE(
    contains(mesh_file_refusal(mesh({"1 0 0 0"}, {"1 1 2 0 1 1 1"}), "msh"),
             "zero length"));
}

TEST(MeshFileCell, RefusesImpossibleArcs)
{
  const auto behind = mesh_file_refusal(mesh({"1 0 0 0", "2 1 0 0", "3 2 0 0"},
                                             {"1 8 2 0 1 1 2 3"}),
                                        "msh");
  EXPECT_TRUE(contains(behind, "turns back: its middle node 3")) << behind;
  const auto joined =
    mesh_file_refusal(mesh({"1 0 0 0", "2 2 0 0", "3 1 1 0", "4 1 2 0"},
                           {"1 8 2 0 1 1 2 3", "2 1 2 0 2 3 4"}),
                      "msh");
  EXPECT_TRUE(contains(joined, "node 3 in its middle")) << joined;
}

TEST(MeshFileCell, RefusesImpossibleGroups)
{
  const std::vector<std::string> nodes = {"1 0 0 0", "2 1 0 0", "3 0 1 0"};
  const auto                     loose = mesh_file_refusal(mesh(nodes,
                                            {"1 1 2 0 1 1 2", "2 15 2 4 2 3"},
                                            {"0 4 \"load\""}),
                                       "msh");
  EXPECT_TRUE(contains(loose, "group \"load\" has node 3")) << loose;
  const auto all =
    mesh_file_refusal(mesh(nodes, {"1 1 2 4 1 1 2"}, {"1 4 \"all\""}), "msh");
  EXPECT_TRUE(contains(all, "named \"all\"")) << all;
}

TEST(MeshFileCell, BinaryFilesAreReadToTheLastDigit)
{
  // Made by gmsh 4.8 of portal.geo, with Mesh.Binary = 1.
  for (const std::string file : {"portal-binary-2.msh", "portal-binary-4.msh"})
    expect_portal(
      read(file, AUXFEM_TEST_DATA_DIRECTORY, "set Length unit = 1 mm"));
}

TEST(MeshFileCell, KnowsItsOwnFormatByTheBeginning)
{
  EXPECT_EQ(lattice_of(mesh({"1 0 0 0", "2 1 0 0"}, {"1 1 2 0 1 1 2"}), "txt")
              .struts.size(),
            1u);
}

TEST(MeshFileCell, ReadsAFrameOfAbaqus)
{
  const auto lattice =
    read("portal.inp", AUXFEM_TEST_DATA_DIRECTORY, "set Length unit = 1 mm");
  expect_portal(lattice);
  EXPECT_EQ(lattice.strut_sets.at("whole"), (Indices{0, 1, 2, 3}));
  EXPECT_EQ(lattice.strut_sets.at("B22"), (Indices{1, 2}));
  EXPECT_EQ(lattice.notes.size(), 2u);
}

TEST(MeshFileCell, NodesAtOnePlaceAreNamedOrMerged)
{
  const std::string text =
    mesh({"1 0 0 0", "2 0 1 0", "3 0 1 0", "4 1 1 0"},
         {"1 1 2 7 1 1 2", "2 1 2 8 1 3 4", "3 15 2 9 2 3"},
         {"0 9 \"corner\""});
  const auto as_it_is = lattice_of(text, "msh");
  EXPECT_EQ(as_it_is.joints.size(), 4u);
  ASSERT_EQ(as_it_is.notes.size(), 1u);
  EXPECT_TRUE(contains(as_it_is.notes[0],
                       "joint 1 (node 2) and joint 2 (node 3) at (0, 1) m"))
    << as_it_is.notes[0];

  const auto merged = read(write(text, "msh"),
                           AUXFEM_TEST_OUTPUT_DIRECTORY,
                           "set Merge distance = 1 um");
  ASSERT_EQ(merged.joints.size(), 3u);
  ASSERT_EQ(merged.struts.size(), 2u);
  EXPECT_EQ(merged.struts[1].joints, (std::array<unsigned int, 2>{{1, 2}}));
  EXPECT_EQ(merged.joint_sets.at("corner"), (Indices{1}));
  EXPECT_EQ(merged.strut_sets.at("group 8"), (Indices{1}));
}

TEST(MeshFileCell, ReadsOtherFormatsThroughGmsh)
{
  const auto lattice =
    lattice_of("# vtk DataFile Version 2.0\nframe\nASCII\n"
               "DATASET UNSTRUCTURED_GRID\nPOINTS 3 double\n"
               "0 0 0\n1 0 0\n1 2 0\nCELLS 2 6\n2 0 1\n2 1 2\n"
               "CELL_TYPES 2\n3\n3\n",
               "vtk");
  ASSERT_EQ(lattice.joints.size(), 3u);
  EXPECT_EQ(lattice.struts.size(), 2u);
  EXPECT_EQ(lattice.joints[2], dealii::Point<3>(1, 2, 0));
}

TEST(MeshFileCell, OnlyAScriptThatIsAllowedRuns)
{
  namespace fs               = std::filesystem;
  const std::string evidence = AUXFEM_TEST_OUTPUT_DIRECTORY "/script_has_run";
  const std::string script =
    "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nLine(1) = {1, 2};\n"
    "SystemCall \"touch " +
    evidence + "\";\nPrintf(\"x\") > \"" + evidence +
    "\";\nTransfinite Curve {1} = 2;\n";
  fs::remove(evidence);
  for (const std::string ending : {"geo",
                                   "GEO",
                                   "msh",
                                   "txt",
                                   "pos",
                                   "vtk",
                                   "unv",
                                   "mesh",
                                   "stl",
                                   "gz",
                                   "geo_unrolled",
                                   "opt",
                                   "inp",
                                   "py",
                                   "med",
                                   "step",
                                   "dat"})
    {
      // gmsh runs the options beside a file with it.
      write(script, ending + ".opt");
      const std::string message = input_error_of(
        [&]() { read(write(script, ending), AUXFEM_TEST_OUTPUT_DIRECTORY); });
      EXPECT_TRUE(contains(message, "Lattice/File: ")) << message;
      EXPECT_FALSE(fs::exists(evidence)) << ending;
    }
  EXPECT_TRUE(contains(input_error_of([&]() {
                         read(write(script, "geo"),
                              AUXFEM_TEST_OUTPUT_DIRECTORY);
                       }),
                       "Run gmsh script = true"));
  fs::remove(AUXFEM_TEST_OUTPUT_DIRECTORY "/" + write("", "geo.opt"));
  EXPECT_EQ(lattice_of(script, "geo").struts.size(), 1u);
  EXPECT_TRUE(fs::exists(evidence));
}

TEST(MeshFileCell, ScriptsEndAfterTheirTime)
{
  for (const std::string endless : {"Macro a\nx = 1;\nCall a;\nReturn\nCall a;",
                                    "For i In {0:1e9}\nx = i;\nEndFor",
                                    "SystemCall \"sleep 1000\";"})
    {
      const std::string file = write(
        "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nLine(1) = {1, 2};\n" +
          endless,
        "geo");
      const std::string message = input_error_of([&]() {
        read(file,
             AUXFEM_TEST_OUTPUT_DIRECTORY,
             allow_script + "set Gmsh time limit = 0.2 s");
      });
      EXPECT_TRUE(contains(message, "no end after 0.2 s") ||
                  contains(message, "crash"))
        << message;
    }
}

TEST(MeshFileCell, RefusesPipes)
{
  const std::string pipe = AUXFEM_TEST_OUTPUT_DIRECTORY "/mesh_pipe.msh";
  std::filesystem::remove(pipe);
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string message = input_error_of(
    [&]() { read("mesh_pipe.msh", AUXFEM_TEST_OUTPUT_DIRECTORY); });
  EXPECT_TRUE(contains(message, "it is a pipe")) << message;
}

TEST(MeshFileCell, CannotBeRepeated)
{
  const auto cell =
    cell_from_text("mesh file", "set File = portal.msh", portal_directory);
  const auto message = input_error_of([&]() {
    make_array(cell->build(), {{2, 1, 1}});
  });
  EXPECT_TRUE(contains(message, "2 cells along x")) << message;
  EXPECT_TRUE(contains(message, "no Vector x to the next cell")) << message;
}
