#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace auxfem;

namespace
{
  /** A cell of the library and what it has per cell of an endless array. */
  struct LibraryCell
  {
    std::string  name, text;
    unsigned int dimension, joints, struts;
    double       density; ///< relative, of struts with `thickness` or `area`
  };

  constexpr double thickness = 0.05, area = dealii::numbers::PI * 0.01 / 4;

  /** Cells with struts of length 1; densities without the overlap at joints. */
  std::vector<LibraryCell> library()
  {
    const std::string unit = "set Strut length = 1\n";
    return {
      {"square", unit, 2, 1, 2, 0.1},
      {"triangular", unit, 2, 2, 6, 0.173205081},
      {"kagome", unit, 2, 6, 12, 0.0866025404},
      {"hexagonal",
       "set Vertical length = 1\nset Inclined length = 1\n",
       2,
       4,
       6,
       0.0577350269},
      {"re-entrant",
       "set Vertical length = 2\nset Inclined length = 1\n",
       2,
       4,
       6,
       0.0769800359},
      {"double arrowhead", "set Half width = 1\n", 2, 2, 4, 0.13660254},
      {"tetrachiral",
       "set Ligament length = 1\nset Ring radius = 0.2\n",
       2,
       4,
       6,
       0.140372287},
      {"anti-tetrachiral",
       "set Ring distance = 1\nset Ring radius = 0.2\n",
       2,
       16,
       24,
       0.162831853},
      {"hexachiral",
       "set Ligament length = 1\nset Ring radius = 0.2\n",
       2,
       12,
       18,
       0.21185953},
      {"cubic", unit, 3, 1, 3, 0.0235619449},
      {"body-centred cubic", unit, 3, 2, 8, 0.0408104857},
      {"face-centred cubic", unit, 3, 4, 12, 12 * area / (2 * std::sqrt(2.))},
      {"octet", unit, 3, 4, 24, 24 * area / (2 * std::sqrt(2.))},
      {"Kelvin", unit, 3, 12, 24, 24 * area / (16 * std::sqrt(2.))},
      {"diamond", unit, 3, 8, 16, 16 * area * 3 * std::sqrt(3.) / 64},
      {"space re-entrant",
       "set Vertical length = 2\nset Oblique length = 1\n",
       3,
       8,
       20,
       0.020943951}};
  }

  UnitCell unit_cell(const LibraryCell &cell)
  {
    return cell_from_text(cell.name, cell.text, ".", cell.dimension)->build();
  }

  /** Growth of @p count of an array per cell inside: the mixed difference of
   * arrays of two and three cells in each direction. */
  double per_cell(const LibraryCell                            &cell,
                  const std::function<double(const Lattice &)> &count)
  {
    double sum = 0;
    for (const unsigned int x : {2, 3})
      for (const unsigned int y : {2, 3})
        for (const unsigned int z : {2, 3})
          {
            if (cell.dimension == 2 && z == 2)
              continue;
            const Lattice lattice =
              make_array(unit_cell(cell),
                         {{x, y, cell.dimension == 2 ? 1 : z}});
            sum += ((x + y + z) % 2 == 0 ? -1 : 1) * count(lattice);
          }
    return sum;
  }

  double length_of_struts(const Lattice &lattice)
  {
    double sum = 0;
    for (const Strut &strut : lattice.struts)
      sum += lattice.length(strut);
    return sum;
  }

  unsigned int n_pieces(const Lattice &lattice)
  {
    std::vector<unsigned int> piece(lattice.joints.size());
    for (unsigned int j = 0; j < piece.size(); ++j)
      piece[j] = j;
    const std::function<unsigned int(unsigned int)> root =
      [&](const unsigned int j) { return piece[j] == j ? j : root(piece[j]); };
    for (const Strut &strut : lattice.struts)
      piece[root(strut.joints[0])] = root(strut.joints[1]);
    unsigned int n = 0;
    for (unsigned int j = 0; j < piece.size(); ++j)
      n += piece[j] == j;
    return n;
  }
} // namespace

TEST(CellLibrary, HasTheConnectivityOfEndlessLattices)
{
  for (const LibraryCell &cell : library())
    {
      EXPECT_EQ(per_cell(cell,
                         [](const Lattice &lattice) {
                           return lattice.joints.size();
                         }),
                cell.joints)
        << cell.name;
      EXPECT_EQ(per_cell(cell,
                         [](const Lattice &lattice) {
                           return lattice.struts.size();
                         }),
                cell.struts)
        << cell.name;
    }
}

TEST(CellLibrary, HasTheDensityOfClosedForms)
{
  for (const LibraryCell &cell : library())
    {
      const UnitCell unit   = unit_cell(cell);
      double         volume = 1;
      for (unsigned int d = 0; d < cell.dimension; ++d)
        volume *= unit.vectors[d][d];
      EXPECT_NEAR(per_cell(cell, length_of_struts) *
                    (cell.dimension == 2 ? thickness : area) / volume,
                  cell.density,
                  1e-9)
        << cell.name;
    }
}

TEST(CellLibrary, ArraysAreOnePiece)
{
  for (const LibraryCell &cell : library())
    for (const unsigned int n : {1, 2, 3})
      {
        const Lattice lattice =
          make_array(unit_cell(cell), {{n, n, cell.dimension == 2 ? 1 : n}});
        EXPECT_EQ(n_pieces(lattice), 1u) << cell.name << ' ' << n;
      }
}

TEST(CellLibrary, RotatingSquaresMeetAtShortStruts)
{
  const UnitCell unit =
    cell_from_text("rotating squares",
                   "set Square side = 1\nset Hinge length = 0.1\n")
      ->build();
  const double D = std::sqrt(2.) * std::cos(dealii::numbers::PI / 9) + 0.1;
  EXPECT_NEAR(unit.vectors[0][0], 2 * D, 1e-15);
  const Lattice lattice = make_array(unit, {{3, 2, 1}});
  EXPECT_EQ(lattice.joints.size(), 6u * 20);
  // Four squares each; hinges inside, and across to right and upper cells.
  EXPECT_EQ(lattice.struts.size(), 6u * (32 + 4) + 2 * 2 * 2 + 2 * 3 * 1);
  for (const unsigned int hinge : lattice.strut_sets.at("hinges"))
    EXPECT_NEAR(lattice.length(lattice.struts[hinge]), 0.1, 1e-14);
  for (const unsigned int edge : lattice.strut_sets.at("edges"))
    EXPECT_NEAR(lattice.length(lattice.struts[edge]), 1, 1e-14);
  EXPECT_EQ(n_pieces(lattice), 1u);
}

TEST(CellLibrary, RefusesImpossibleShapes)
{
  const auto refusal = [](const std::string &name,
                          const std::string &text,
                          const unsigned int dimension = 2) {
    return input_error_of([&] { cell_from_text(name, text, ".", dimension); });
  };
  expect_parts(refusal("re-entrant",
                       "set Vertical length = 1\nset Inclined length = 1\n"),
               {"Lattice/Vertical length = 1", "meet or cross", "2 l sin"});
  expect_parts(refusal("hexagonal", "set Wall angle = 90 deg\n"),
               {"Lattice/Wall angle = 90 deg", "less than 90 deg"});
  expect_parts(refusal("double arrowhead", "set Short angle = 60 deg\n"),
               {"Lattice/Short angle = 60 deg", "Long angle = 60 deg"});
  expect_parts(refusal("anti-tetrachiral", "set Ring radius = 5 mm\n"),
               {"Lattice/Ring radius = 5 mm", "Ring distance = 10 mm"});
  expect_parts(refusal("rotating squares", "set Turn angle = 45 deg\n"),
               {"Lattice/Turn angle = 45 deg", "less than 45 deg"});
  expect_parts(refusal("space re-entrant", "set Vertical length = 12 mm\n", 3),
               {"Lattice/Vertical length = 12 mm", "2 L cos"});
  for (const std::string name : {"cubic", "octet", "Kelvin", "diamond"})
    expect_parts(refusal(name, ""), {name, "Dimension = 3"});
}
