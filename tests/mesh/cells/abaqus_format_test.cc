#include <auxfem/mesh/cells/line_mesh.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Names   = std::vector<std::string>;
  using Numbers = std::vector<std::size_t>;

  std::string abaqus_mistake(const std::string &text)
  {
    try
      {
        read_abaqus(text);
        return "";
      }
    catch (const MeshMistake &mistake)
      {
        return mistake.text;
      }
  }

  const std::string bar = "*NODE\n1, 0, 0\n2, 1, 0\n3, 2, 0\n"
                          "*ELEMENT, TYPE=B21\n1, 1, 2\n2, 2, 3\n";
} // namespace

TEST(AbaqusFormat, ReadsNodesElementsAndSets)
{
  const LineMesh mesh =
    read_abaqus(read_text(AUXFEM_TEST_DATA_DIRECTORY "/portal.inp"));
  EXPECT_EQ(mesh.positions.size(), 7u);
  EXPECT_EQ(mesh.positions.at(3), dealii::Point<3>(1200, 1900, 0));
  ASSERT_EQ(mesh.lines.size(), 4u);
  const std::vector<Numbers> nodes = {{1, 2, 0},
                                      {2, 3, 11},
                                      {3, 4, 12},
                                      {4, 5, 0}};
  const std::vector<Names>   sets  = {{"B21", "left half", "legs", "whole"},
                                      {"B22", "arch", "left half", "whole"},
                                      {"B22", "arch", "right", "whole"},
                                      {"B21", "legs", "whole"}};
  for (unsigned int i = 0; i < 4; ++i)
    {
      const LineMesh::Line &line = mesh.lines[i];
      EXPECT_EQ(line.tag, i + 1);
      EXPECT_EQ((Numbers{line.first, line.second, line.middle}), nodes[i]);
      EXPECT_EQ(line.sets, sets[i]) << i;
    }
  EXPECT_EQ(mesh.node_sets.at("feet"), (Numbers{1, 5}));
  EXPECT_EQ(mesh.node_sets.at("crown"), (Numbers{3}));
  EXPECT_EQ(mesh.node_sets.at("every node"), (Numbers{1, 2, 3, 4, 5}));
}

TEST(AbaqusFormat, ReportsSkippedParts)
{
  const LineMesh mesh =
    read_abaqus(read_text(AUXFEM_TEST_DATA_DIRECTORY "/portal.inp"));
  ASSERT_EQ(mesh.notes.size(), 2u);
  expect_parts(mesh.notes[0], {"every node", "2 nodes at which no strut ends"});
  expect_parts(mesh.notes[1],
               {"*BEAM SECTION",
                "*MATERIAL",
                "*ELASTIC",
                "*BOUNDARY",
                "*STEP",
                "*CLOAD",
                "Sections, Supports, Loads"});
  EXPECT_FALSE(contains(mesh.notes[1], "HEADING"));

  EXPECT_TRUE(read_abaqus(bar).notes.empty());
  const LineMesh truss = read_abaqus(
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n"
    "*ELEMENT, TYPE=T3D2\n1, 1, 2\n*ELEMENT, TYPE=B31H\n2, 2, 3, 1\n"
    "*ELEMENT, TYPE=S3\n3, 1, 2, 3\n");
  ASSERT_EQ(truss.lines.size(), 2u);
  ASSERT_EQ(truss.notes.size(), 2u);
  expect_parts(truss.notes[0], {"T3D2", "axial forces", "hinges"});
  expect_parts(truss.notes[1],
               {"elements of type S3", "nodes for the direction of sections"});
}

TEST(AbaqusFormat, RefusesFilesThatWouldLoseAPart)
{
  const std::vector<std::pair<std::string, std::string>> lines = {
    {"*PART, NAME=a", "parts and instances are not read"},
    {"*INSTANCE, NAME=a, PART=b", "parts and instances"},
    {"*Assembly, name=x", "parts and instances"},
    {"*NSET, NSET=a, INSTANCE=b\n1", "parts and instances"},
    {"*NGEN\n1, 3", "*NGEN is not read"},
    {"*include, input=other.inp", "*INCLUDE is not read"},
    {"*NODE, INPUT=other.inp", "*NODE with INPUT"},
    {"*NODE, SYSTEM=C\n4, 1, 90", "*NODE with SYSTEM"},
    {"*ELEMENT, TYPE=B31OS\n3, 1, 3", "type B31OS"},
    {"*ELEMENT, TYPE=PIPE21\n3, 1, 3", "type PIPE21"},
    {"*NSET\n1", "has no name"},
    {"*NSET, NSET=a\nlost", "no set lost"},
    {"*NSET, NSET=a, GENERATE\n1", "GENERATE needs"},
    {"*NSET, NSET=a, GENERATE\n1, 18446744073709551615", "from 1 to"},
    {"*NODE\n4, 1x, 0", "'1x'"},
    {"*NODE\n4, inf", "'inf'"},
    {"*NODE\n-4, 1", "'-4'"},
    {"*NODE\n1, 7, 7", "node 1 is given a second time"},
    {"*ELEMENT, TYPE=B21\n2, 1, 3", "element 2 is given a second time"},
    {"*ELEMENT, TYPE=B21\n3, 1", "has 1 nodes; needed are 2"},
    {"*ELEMENT, TYPE=B21\n3, 1, 9", "element 3 has node 9"},
    {"*", "keyword is expected"}};
  for (const auto &[line, reason] : lines)
    expect_parts(abaqus_mistake(bar + line + "\n"), {"line ", reason});
  expect_parts(abaqus_mistake("Point(1) = {0, 0, 0};"),
               {"line 1", "does not begin with a keyword"});
  expect_parts(abaqus_mistake("** comment\n"), {"no keyword"});
}
