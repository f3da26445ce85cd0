#include <gtest/gtest.h>

#include <algorithm>

#include "cell_from_text.h"

using namespace auxfem;

namespace
{
  using Indices = std::vector<unsigned int>;

  constexpr double layer_distance = 0.02;

  Lattice layers(const UnitCell                    &cell,
                 const std::array<unsigned int, 3> &n_cells,
                 const std::string                 &columns = "all")
  {
    return make_array(extrude(cell, layer_distance, columns, "Lattice"),
                      n_cells);
  }

  UnitCell planar(const std::string &name, const std::string &text = "")
  {
    return cell_from_text(name, text, ".", 3)->build();
  }

  /** Expects every column to lead from a joint to the one a layer above it. */
  void expect_columns_along_z(const Lattice &lattice, const std::size_t number)
  {
    const Indices &columns = lattice.strut_sets.at("columns");
    EXPECT_EQ(columns.size(), number);
    for (const unsigned int column : columns)
      {
        const Strut &strut = lattice.struts[column];
        EXPECT_EQ(strut.sagitta, 0.);
        const auto chord =
          lattice.joints[strut.joints[1]] - lattice.joints[strut.joints[0]];
        EXPECT_EQ(chord[0], 0.);
        EXPECT_EQ(chord[1], 0.);
        EXPECT_NEAR(chord[2], layer_distance, 1e-17);
      }
  }
} // namespace

TEST(Extrude, EqualJointsOfNeighbouringLayersAreLinked)
{
  const auto cell  = planar("star");
  const auto layer = make_array(cell, {{3, 2, 1}});
  const auto solid = layers(cell, {{3, 2, 4}});
  // Stub ends that two cells share have one column.
  const std::size_t n_columns = 3 * layer.joints.size();
  EXPECT_EQ(solid.n_cells, 24u);
  EXPECT_EQ(solid.joints.size(), 4 * layer.joints.size());
  EXPECT_EQ(solid.struts.size(), 4 * layer.struts.size() + n_columns);
  EXPECT_EQ(solid.strut_sets.at("edges").size(),
            4 * layer.strut_sets.at("edges").size());
  expect_columns_along_z(solid, n_columns);
  for (unsigned int i = 0; i < solid.joints.size(); ++i)
    // Layers are numbered one after the other.
    EXPECT_NEAR(solid.joints[i][2],
                layer_distance * (i / layer.joints.size()),
                1e-17);
}

TEST(Extrude, ColumnsOnlyAtTheJointsNamed)
{
  const auto cell = planar("star");
  expect_columns_along_z(layers(cell, {{3, 2, 2}}, "tips"), 6 * 4);
  expect_columns_along_z(layers(cell, {{3, 2, 3}}, "tips + notches"),
                         2 * 6 * 8);
  // A side of the cell: stub ends, shared along x.
  expect_columns_along_z(layers(cell, {{3, 2, 2}}, "left + right"), 2 * 4);
  expect_columns_along_z(layers(cell, {{3, 2, 2}}, "left, right"), 2 * 4);
}

TEST(Extrude, FacesAreSets)
{
  const auto cell  = planar("star");
  const auto layer = make_array(cell, {{3, 2, 1}});
  const auto solid = layers(cell, {{3, 2, 4}});
  for (const auto side : {"left", "right", "bottom", "top"})
    EXPECT_EQ(solid.joint_sets.at(side).size(),
              4 * layer.joint_sets.at(side).size());
  for (const auto &[side, z] : {std::make_pair("back", 0.),
                                std::make_pair("front", 3 * layer_distance)})
    {
      const auto &face = solid.joint_sets.at(side);
      EXPECT_EQ(face.size(), layer.joints.size());
      for (const unsigned int joint : face)
        EXPECT_NEAR(solid.joints[joint][2], z, 1e-17);
    }
}

TEST(Extrude, OneLayerHasNoColumns)
{
  const auto lattice = layers(planar("star"), {{2, 2, 1}});
  EXPECT_EQ(lattice.strut_sets.count("columns"), 0u);
  EXPECT_EQ(lattice.struts.size(), 48u);
}

TEST(Extrude, EveryPlanarCell)
{
  for (const auto name : {"star", "general star", "hinged star"})
    {
      const auto cell  = planar(name);
      const auto layer = make_array(cell, {{2, 2, 1}});
      const auto solid = layers(cell, {{2, 2, 2}});
      EXPECT_EQ(solid.joints.size(), 2 * layer.joints.size()) << name;
      expect_columns_along_z(solid, layer.joints.size());
      for (const auto &[set, pairs] : layer.pair_sets)
        EXPECT_EQ(solid.pair_sets.at(set).size(), 2 * pairs.size())
          << name << ", " << set;
    }
  // The hinged star names its joints.
  expect_columns_along_z(layers(planar("hinged star"), {{2, 2, 2}}, "A + D"),
                         8);
}

TEST(Extrude, APlanarFrame)
{
  const auto lattice =
    layers(planar("frame", "set Joints = 0 0; 1 0\nset Struts = 0 1 0.2"),
           {{1, 1, 3}});
  EXPECT_EQ(lattice.joints.size(), 6u);
  EXPECT_EQ(lattice.struts.size(), 3u + 4u);
  expect_columns_along_z(lattice, 4);
  EXPECT_EQ(lattice.joint_sets.at("back"), (Indices{0, 1}));
  EXPECT_EQ(lattice.joint_sets.at("front"), (Indices{4, 5}));
}

TEST(Extrude, ColumnsBelongToTheLowerCell)
{
  const auto  lattice = layers(planar("star"), {{2, 1, 2}}, "tips");
  const auto &columns = lattice.strut_sets.at("columns");
  ASSERT_EQ(columns.size(), 8u);
  for (unsigned int i = 0; i < columns.size(); ++i)
    EXPECT_EQ(lattice.struts[columns[i]].cell, i / 4);
}

TEST(Extrude, RefusesUnknownJoints)
{
  const auto message = input_error_of([]() {
    layers(planar("star"), {{1, 1, 2}}, "tip");
  });
  expect_parts(message,
               {"Lattice/Interlayer joints",
                "no set of joints named \"tip\"; did you mean \"tips\"",
                "\"all\"",
                "\"notches\"",
                "\"left\""});
  EXPECT_TRUE(contains(input_error_of([]() {
                         layers(planar("star"), {{1, 1, 2}}, "");
                       }),
                       "names no joints"));
}

TEST(Extrude, RefusesCellsThatAreNotPlanar)
{
  for (const auto &cell :
       {planar("space star"),
        planar("frame", "set Joints = 0 0; 1 0 1\nset Struts = 0 1"),
        planar("frame", "set Joints = 0 0; 1 0\nset Struts = 0 1 1 0 1 0")})
    EXPECT_TRUE(contains(input_error_of([&cell]() {
                           layers(cell, {{1, 1, 1}});
                         }),
                         "Lattice/Layer distance: only planar cells"));
}

TEST(Extrude, PlanarCellsWithoutLayersCannotBeRepeatedAlongZ)
{
  const auto message = input_error_of([]() {
    make_array(planar("star"), {{1, 1, 2}});
  });
  expect_parts(message, {"2 cells along z", "no Layer distance"});
}
