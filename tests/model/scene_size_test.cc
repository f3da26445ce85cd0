#include <auxfem/model/build_lattice.h>

#include <gtest/gtest.h>
#include <support/text_file.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** The shipped scene @p name with other parameters. */
  Scene scene_of_size(const std::string              &name,
                      const std::vector<std::string> &overrides)
  {
    const std::string file = AUXFEM_PRM_DIRECTORY "/" + name;
    return read_scene_from_text(read_text(file), file, overrides);
  }

  std::vector<std::string>
  cells(const unsigned int nx, const unsigned int ny, const unsigned int nz = 1)
  {
    return {"Lattice/Cells x=" + std::to_string(nx),
            "Lattice/Cells y=" + std::to_string(ny),
            "Lattice/Cells z=" + std::to_string(nz)};
  }
} // namespace

TEST(SceneSize, MatchesTheLattice)
{
  std::vector<Scene> scenes;
  for (const auto &[nx, ny] :
       {std::pair(1, 1), std::pair(1, 5), std::pair(2, 3), std::pair(7, 4)})
    for (const char *name : {"star-10x10.prm", "rigid-array.prm"})
      scenes.push_back(scene_of_size(name, cells(nx, ny)));
  scenes.push_back(scene_of_size("lattice-3d.prm", cells(3, 4, 5)));
  scenes.push_back(scene_of_size("lattice-3d.prm", cells(4, 1, 3)));
  scenes.push_back(scene_of_size("portal.prm", {}));
  for (const Scene &scene : scenes)
    {
      const Lattice lattice =
        make_array(scene.lattice.cell->build(), scene.lattice.n_cells);
      const SceneSize size = size_of(scene);
      EXPECT_EQ(size.joints, lattice.n_structural_joints()) << scene.file;
      EXPECT_EQ(size.struts, lattice.struts.size()) << scene.file;
    }
}

TEST(SceneSize, CountsUnknownsOfJointsAndNodes)
{
  // Five joints, four struts of two elements of order 3 with five inner nodes.
  EXPECT_EQ(size_of(scene_of_size("portal.prm", {})).unknowns, 3 * (5 + 4 * 5));
  EXPECT_EQ(size_of(scene_of_size("portal.prm", {"Dimension=3"})).unknowns,
            6 * (5 + 4 * 5));
}

TEST(SceneSize, IsReportedForLargeScenes)
{
  EXPECT_EQ(size_text(scene_of_size("star-10x10.prm", {})), "");
  const Scene     large = scene_of_size("star-10x10.prm", cells(500, 500));
  const SceneSize size  = size_of(large);
  EXPECT_GT(size.joints, 1e6);
  expect_parts(size_text(large),
               {std::to_string(static_cast<long>(size.joints)) + " joints",
                std::to_string(static_cast<long>(size.struts)) + " struts",
                std::to_string(static_cast<long>(size.unknowns)) + " unknowns",
                " GB"});
  const Scene enormous = scene_of_size("star-10x10.prm", cells(100000, 100000));
  expect_parts(input_error_of([&]() { size_text(enormous); }),
               {"Lattice: ", "more than can be numbered", "4294967295"});
}
