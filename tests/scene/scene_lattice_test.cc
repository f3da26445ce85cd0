#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>

#include <support/messages.h>

using namespace auxfem;

namespace
{
  Scene scene_of(const unsigned int dimension, const std::string &lattice)
  {
    return read_scene_from_text("set Dimension = " + std::to_string(dimension) +
                                  "\nsubsection Lattice\n" + lattice +
                                  "\nend\n",
                                "scene.prm");
  }

  Lattice lattice_of(const std::string &text)
  {
    const Scene scene = scene_of(3, text);
    return make_array(scene.lattice.cell->build(), scene.lattice.n_cells);
  }

  std::string refusal(const unsigned int dimension, const std::string &lattice)
  {
    return input_error_of([&]() { scene_of(dimension, lattice); });
  }
} // namespace

TEST(SceneLattice, CellsAlongZ)
{
  const auto lattice = lattice_of("set Cell = space star\nset Cells x = 2\n"
                                  "set Cells z = 3");
  EXPECT_EQ(lattice.n_cells, 6u);
  EXPECT_EQ(lattice.joint_sets.at("front").size(), 2u);
  EXPECT_EQ(lattice.joint_sets.at("right").size(), 3u);
}

TEST(SceneLattice, LayersOfPlanarCells)
{
  const auto lattice = lattice_of("set Cell = star\nset Cells y = 2\n"
                                  "set Cells z = 3\n"
                                  "set Layer distance = 15 mm\n"
                                  "set Interlayer joints = tips");
  EXPECT_EQ(lattice.n_cells, 6u);
  EXPECT_EQ(lattice.strut_sets.at("columns").size(), 2u * 2u * 4u);
  const unsigned int front = lattice.joint_sets.at("front")[0];
  EXPECT_NEAR(lattice.joints[front][2], 0.03, 1e-17);
}

TEST(SceneLattice, ThePlaneHasOneLayer)
{
  expect_parts(refusal(2, "set Cell = star\nset Cells z = 3"),
               {"Lattice/Cells z = 3", "Dimension = 3"});
  expect_parts(refusal(2, "set Cell = star\nset Layer distance = 1 mm"),
               {"Lattice/Layer distance = 1 mm", "Dimension = 3"});
  expect_parts(refusal(2, "set Cell = space star"),
               {"'space star'", "Dimension = 3"});
  EXPECT_EQ(refusal(2, "set Cell = star\nset Cells z = 1"), "");
}

TEST(SceneLattice, ColumnsNeedLayersAndJoints)
{
  expect_parts(refusal(3, "set Cell = star\nset Interlayer joints = tips"),
               {"Lattice/Interlayer joints = tips", "Layer distance"});
  expect_parts(refusal(3,
                       "set Cell = star\nset Layer distance = 1 mm\n"
                       "set Interlayer joints = tip"),
               {"Lattice/Interlayer joints", "did you mean \"tips\""});
  expect_parts(refusal(3, "set Cell = space star\nset Layer distance = 1 mm"),
               {"Lattice/Layer distance", "planar"});
}
