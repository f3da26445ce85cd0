#include <auxfem/mesh/cells/line_mesh.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/text_file.h>

#include <fstream>
#include <sstream>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string directory = AUXFEM_TEST_OUTPUT_DIRECTORY;

  std::string portal()
  {
    return read_text(AUXFEM_PRM_DIRECTORY "/../meshes/portal.msh");
  }

  const std::string planar_square = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                                    "$PhysicalNames\n1\n1 1 \"all sides\"\n"
                                    "$EndPhysicalNames\n"
                                    "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 1 1 0\n"
                                    "$EndNodes\n"
                                    "$Elements\n2\n1 1 2 1 1 1 2\n"
                                    "2 1 2 1 1 2 3\n$EndElements\n";

  /** @p text with the first @p from, which must be there, replaced by @p to. */
  std::string
  changed(std::string text, const std::string &from, const std::string &to)
  {
    const std::size_t position = text.find(from);
    EXPECT_NE(position, std::string::npos) << from;
    return text.replace(position, from.size(), to);
  }

  std::string write(const std::string &text)
  {
    const std::string name = "msh_format.msh";
    std::ofstream(directory + "/" + name, std::ios::binary) << text;
    return name;
  }

  std::string mistake_in(const std::string &text)
  {
    try
      {
        read_msh(text);
        return "";
      }
    catch (const MeshMistake &mistake)
      {
        return mistake.text;
      }
  }

  /** Error message for a scene with the mesh @p text. */
  std::string msh_refusal(const std::string &text)
  {
    const std::string file = write(text);
    return input_error_of(
      [&]() { cell_from_text("mesh file", "set File = " + file, directory); });
  }

  struct Damage
  {
    std::string              from, to;
    std::vector<std::string> parts;
  };
} // namespace

TEST(MshFormat, WholeFilesAreAccepted)
{
  EXPECT_EQ(mistake_in(portal()), "");
  EXPECT_EQ(mistake_in(planar_square), "");
  EXPECT_EQ(mistake_in(changed(planar_square,
                               "$Nodes",
                               "$Comments\nof 1 2 3\n$EndComments\n$Nodes")),
            "");
}

TEST(MshFormat, OtherFilesAreRefused)
{
  for (const std::string text :
       {"", "\n", "Point(1) = {0, 0, 0};\n", "$NOD\n1\n1 0 0 0\n$ENDNOD\n"})
    expect_parts(mistake_in(text), {"line", "does not begin with $MeshFormat"});
  expect_parts(mistake_in(changed(planar_square, "2.2 0", "4 0")),
               {"line 2", "version '4'", "2 and 4.1"});
  expect_parts(mistake_in("$MeshFormat\n2.2 1 8\n\0\0\0\1$End"), {"byte"});
}

TEST(MshFormat, DamagesOfFormat4AreFoundWithTheirLine)
{
  const std::vector<Damage> damages = {
    {"5 2 3 7 ", "5 2 -1 7 ", {"line 66", "element 5 has node -1"}},
    {"5 2 3 7 ", "5 2 99 7 ", {"line 66", "element 5 has node 99"}},
    {"0 3 15 1\n", "0 3 15 99999999\n", {"line 59", "99999999"}},
    {"0 4 0 1\n4\n", "4\n", {"line 36", "dimension 4"}},
    {"9 9 1 9", "9 -9 1 9", {"line 26", "number of nodes is -9"}},
    {"9 9 1 9", "9 8 1 9", {"8 nodes are announced", "have 9"}},
    {"9 9 1 9", "10 9 1 9", {"'$EndNodes'", "is expected"}},
    {"9 9 1 9", "8 9 1 9", {"9 nodes are announced", "have 8"}},
    {"1200 1900 0\n", "1200 nineteen 0\n", {"'nineteen'", "a number"}},
    {"1200 1900 0\n", "1200 inf 0\n", {"not finite"}},
    {"6 4 0 0", "6 4 0 x", {"line 13", "'x'"}},
    {"1 0 0 0 1 1 \n", "1 0 0 0 99999 1 \n", {"line 14", "99999"}},
    {"0 1 \"feet\"", "0 1 feet", {"line 6", "double quotes"}},
    {"0 1 \"feet\"", "0 1 \"feet", {"line 6", "closing double quote"}},
    {"1 3 \"legs\"", "7 3 \"legs\"", {"line 8", "dimension 7"}},
    {"0 3 15 1\n", "0 4 0 1\n0 3 15 1\n", {"line 60", "type 0"}},
    {"$EndNodes", "$EndNode", {"'$EndNode'", "$EndNodes"}},
    {"$EndElements\n", "", {"the file ends", "$EndElements"}}};
  for (const Damage &damage : damages)
    {
      const std::string text    = changed(portal(), damage.from, damage.to);
      const std::string mistake = mistake_in(text);
      expect_parts(mistake, damage.parts);
      expect_parts(msh_refusal(text),
                   {"Lattice/File: the mesh file",
                    "msh_format.msh is damaged",
                    mistake,
                    "write it anew with gmsh"});
    }
}

TEST(MshFormat, DamagesOfFormat2AreFoundWithTheirLine)
{
  const std::vector<Damage> damages = {
    {"1 1 2 1 1 1 2", "1 1 2 1 1 1 7", {"line 16", "element 1 has node 7"}},
    {"1 1 2 1 1 1 2", "1 1 -2 1 1 1 2", {"line 16", "number of tags is -2"}},
    {"1 1 2 1 1 1 2", "1 1 2 1 1 1", {"line 18"}},
    {"3\n1 0 0 0", "2\n1 0 0 0", {"line 12", "'3'", "$EndNodes"}},
    {"3\n1 0 0 0", "4\n1 0 0 0", {"line 13", "'$EndNodes'"}},
    {"3\n1 0 0 0", "3e9\n1 0 0 0", {"'3e9'", "a whole number"}},
    {"2 1 0 0\n", "0 1 0 0\n", {"line 11", "node number 0"}}};
  for (const Damage &damage : damages)
    expect_parts(mistake_in(changed(planar_square, damage.from, damage.to)),
                 damage.parts);
}

TEST(MshFormat, TruncatedFilesAreRefused)
{
  // Never a crash, wherever the file ends; at a few places it is whole.
  const std::string text      = portal();
  unsigned int      n_refused = 0;
  for (std::size_t size = 1; size < text.size(); size += 7)
    n_refused += !msh_refusal(text.substr(0, size)).empty();
  EXPECT_GT(n_refused, text.size() / 7 - 2);
}
