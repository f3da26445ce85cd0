#include <auxfem/mesh/position_function.h>

#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <string>
#include <vector>

using namespace auxfem::testing_support;

namespace
{
  /** A library cell, Young's modulus along y of the infinite lattice and the
   * difference that is allowed after extrapolation. */
  struct FiniteArrayCase
  {
    std::string cell, sizes;
    double      modulus, allowed;
  };

  // Walls of t = 0.05, E = 1, nu = 0.3, unit depth, with shear flexibility. The
  // moduli come from an independent code for periodic cells.
  const std::vector<FiniteArrayCase> finite_array_cases = {
    {"triangular", "Strut length = 1", 0.057830428, 2e-3},
    {"hexagonal",
     "Vertical length = 1 | Inclined length = 1",
     0.00028432496,
     2e-3},
    {"re-entrant",
     "Vertical length = 2 | Inclined length = 1",
     0.00028247021,
     0.03},
    {"anti-tetrachiral",
     "Ring distance = 1 | Ring radius = 0.2",
     0.00047923355,
     2e-3},
    // Its upper tips bend more than the others.
    {"double arrowhead",
     "Half width = 1 | Long angle = 60 deg | Short angle = 30 deg",
     0.00029142131,
     0.05}};

  /** Force over width and strain of n x n cells that are pulled with free
   * sides. */
  double modulus_of_array(const FiniteArrayCase &array, const unsigned int n)
  {
    SceneText scene = static_scene();
    scene.cells(array.cell, n, n)
      .add("Lattice", array.sizes)
      .rectangle("wall", 1, 0.05, {1, "", 0.3})
      .set("Effects/Shear flexibility", "on")
      .prescribe("foot", "bottom", {"free", "0", "free"})
      .prescribe("side", "0", {"0", "free", "free"})
      .prescribe("top", "top", {"free", "1e-3", "free"})
      .linear();
    SceneRun run(scene.str());
    run.run();
    const auto box = auxfem::bounding_box(run.model.lattice);
    return run.reaction("top", 1) / (box[1][0] - box[0][0]) *
      (box[1][1] - box[0][1]) / 1e-3;
  }
} // namespace

// The error of an array is that of its edges, so it falls with the number of
// cells along a side.
TEST(FiniteArrays, TendToTheConstantsOfInfiniteLattices)
{
  ResultTable table(
    "Modulus of pulled arrays over that of the infinite lattice",
    {"cell", "4 x 4", "8 x 8", "16 x 16", "extrapolated", "allowed"});
  for (const FiniteArrayCase &array : finite_array_cases)
    {
      std::vector<double> found;
      for (const unsigned int n : {4, 8, 16})
        found.push_back(modulus_of_array(array, n) / array.modulus);
      const double limit = 2 * found[2] - found[1];
      EXPECT_NEAR(limit, 1, array.allowed) << array.cell;
      table.row({array.cell,
                 formatted("%.4f", found[0]),
                 formatted("%.4f", found[1]),
                 formatted("%.4f", found[2]),
                 formatted("%.4f", limit),
                 formatted("1 +- %.2g", array.allowed)});
    }
}
