#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace auxfem;

namespace
{
  // Positions are compared to a few units of round-off of a cell of some 10 mm.
  constexpr double space_star_round_off = 1e-15;

  const double strut_length  = 0.010;
  const double opening_angle = dealii::numbers::PI * 70 / 180;
  const double tip_distance =
    strut_length * std::sin(opening_angle) / std::sqrt(2.);
  const double vertex_distance =
    tip_distance - strut_length * std::cos(opening_angle);
  const double stub_distance = vertex_distance + strut_length;

  std::unique_ptr<Cell> space_star(const std::string &opening_angle = "70 deg")
  {
    return cell_from_text("space star",
                          "set Strut length = 10 mm\nset Opening angle = " +
                            opening_angle,
                          ".",
                          3);
  }

  Lattice
  stars(const unsigned int nx, const unsigned int ny, const unsigned int nz)
  {
    return make_array(space_star()->build(), {{nx, ny, nz}});
  }

  /** Joint at a position; invalid_index if there is none. */
  unsigned int joint_at(const Lattice          &lattice,
                        const dealii::Point<3> &position)
  {
    for (unsigned int i = 0; i < lattice.joints.size(); ++i)
      if (lattice.joints[i].distance(position) < 10 * space_star_round_off)
        return i;
    return invalid_index;
  }

  bool is_in(const Lattice          &lattice,
             const std::string      &set,
             const dealii::Point<3> &position)
  {
    const auto &members = lattice.joint_sets.at(set);
    return std::binary_search(members.begin(),
                              members.end(),
                              joint_at(lattice, position));
  }

  dealii::Point<3> on_axis(const unsigned int axis, const double distance)
  {
    dealii::Point<3> position;
    position[axis] = distance;
    return position;
  }

  std::string space_star_refusal(const std::string &opening_angle)
  {
    return input_error_of([&]() { space_star(opening_angle); });
  }
} // namespace

TEST(SpaceStarCell, JointsLieAtTheirFormulas)
{
  const auto lattice = stars(1, 1, 1);
  EXPECT_EQ(lattice.joints.size(), 20u);
  EXPECT_EQ(lattice.joint_sets.at("tips").size(), 8u);
  EXPECT_EQ(lattice.joint_sets.at("notches").size(), 6u);
  for (const double x : {-tip_distance, tip_distance})
    for (const double y : {-tip_distance, tip_distance})
      for (const double z : {-tip_distance, tip_distance})
        EXPECT_TRUE(is_in(lattice, "tips", {x, y, z}));
  const char *sides[3][2] = {{"left", "right"},
                             {"bottom", "top"},
                             {"back", "front"}};
  for (unsigned int axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1})
      {
        EXPECT_TRUE(
          is_in(lattice, "notches", on_axis(axis, sign * vertex_distance)));
        const char *side = sides[axis][sign > 0 ? 1 : 0];
        EXPECT_EQ(lattice.joint_sets.at(side).size(), 1u);
        EXPECT_TRUE(is_in(lattice, side, on_axis(axis, sign * stub_distance)));
      }
}

TEST(SpaceStarCell, ThirtyStrutsOfEqualLength)
{
  const auto lattice = stars(1, 1, 1);
  EXPECT_EQ(lattice.struts.size(), 30u);
  EXPECT_EQ(lattice.strut_sets.at("edges").size(), 24u);
  EXPECT_EQ(lattice.strut_sets.at("stubs").size(), 6u);
  for (const auto &strut : lattice.struts)
    EXPECT_NEAR(lattice.length(strut), strut_length, 5 * space_star_round_off);
}

TEST(SpaceStarCell, EveryTipHasThreeEdgesAndEveryVertexFourAndAStub)
{
  const auto                lattice = stars(1, 1, 1);
  std::vector<unsigned int> n_struts(lattice.joints.size(), 0);
  std::set<std::pair<unsigned int, unsigned int>> ends;
  for (const auto &strut : lattice.struts)
    {
      ends.insert(std::minmax(strut.joints[0], strut.joints[1]));
      for (const unsigned int joint : strut.joints)
        ++n_struts[joint];
    }
  EXPECT_EQ(ends.size(), 30u);
  for (const unsigned int tip : lattice.joint_sets.at("tips"))
    EXPECT_EQ(n_struts[tip], 3u);
  for (const unsigned int vertex : lattice.joint_sets.at("notches"))
    EXPECT_EQ(n_struts[vertex], 5u);
  EXPECT_EQ(n_struts[lattice.joint_sets.at("front")[0]], 1u);
}

TEST(SpaceStarCell, EdgesMakeTheOpeningAngleWithTheAxisOfTheirVertex)
{
  const auto lattice = stars(1, 1, 1);
  for (const unsigned int number : lattice.strut_sets.at("edges"))
    {
      const auto &joints = lattice.struts[number].joints;
      const auto &tip    = lattice.joints[joints[0]];
      const auto &vertex = lattice.joints[joints[1]];
      const auto  edge   = tip - vertex;
      // Tips lie outwards of their vertices.
      const double cosine = edge * vertex / edge.norm() / vertex.norm();
      EXPECT_NEAR(std::acos(cosine), opening_angle, 1e-14);
    }
}

TEST(SpaceStarCell, IsSymmetricUnderTheGroupOfTheCube)
{
  const auto lattice = stars(1, 1, 1);
  // A mirror and two permutations of the axes generate the whole group.
  const auto expect_symmetric = [&](const auto &map) {
    for (const auto &strut : lattice.struts)
      {
        const unsigned int first =
          joint_at(lattice, map(lattice.joints[strut.joints[0]]));
        const unsigned int second =
          joint_at(lattice, map(lattice.joints[strut.joints[1]]));
        EXPECT_TRUE(std::any_of(lattice.struts.begin(),
                                lattice.struts.end(),
                                [&](const auto &other) {
                                  return std::minmax(first, second) ==
                                    std::minmax(other.joints[0],
                                                other.joints[1]);
                                }));
      }
  };
  using P = dealii::Point<3>;
  expect_symmetric([](const P &p) { return P(-p[0], p[1], p[2]); });
  expect_symmetric([](const P &p) { return P(p[1], p[2], p[0]); });
  expect_symmetric([](const P &p) { return P(p[1], p[0], p[2]); });
}

TEST(SpaceStarCell, ArraysShareStubEnds)
{
  for (const auto &n : {std::array<unsigned int, 3>{{2, 2, 2}},
                        std::array<unsigned int, 3>{{3, 3, 3}},
                        std::array<unsigned int, 3>{{4, 1, 2}}})
    {
      const auto         lattice = stars(n[0], n[1], n[2]);
      const unsigned int n_cells = n[0] * n[1] * n[2];
      // Where two cells meet they share one joint.
      const unsigned int n_meetings = (n[0] - 1) * n[1] * n[2] +
        n[0] * (n[1] - 1) * n[2] + n[0] * n[1] * (n[2] - 1);
      EXPECT_EQ(lattice.n_cells, n_cells);
      EXPECT_EQ(lattice.struts.size(), 30 * n_cells);
      EXPECT_EQ(lattice.joints.size(), 20 * n_cells - n_meetings);
      EXPECT_EQ(lattice.joint_sets.at("tips").size(), 8 * n_cells);
      EXPECT_EQ(lattice.joint_sets.at("notches").size(), 6 * n_cells);
      for (const auto side : {"left", "right"})
        EXPECT_EQ(lattice.joint_sets.at(side).size(), n[1] * n[2]);
      for (const auto side : {"bottom", "top"})
        EXPECT_EQ(lattice.joint_sets.at(side).size(), n[0] * n[2]);
      for (const auto side : {"back", "front"})
        EXPECT_EQ(lattice.joint_sets.at(side).size(), n[0] * n[1]);
      EXPECT_TRUE(
        is_in(lattice,
              "front",
              {0, 0, 2 * stub_distance * (n[2] - 1) + stub_distance}));
    }
}

TEST(SpaceStarCell, PairsSpanTheCellAlongTheAxes)
{
  const auto lattice = stars(1, 2, 1);
  const std::vector<std::tuple<std::string, unsigned int, int>> expected =
    {{"in-cell", 1, 1}, {"in-cell x", 0, -1}, {"in-cell z", 2, -1}};
  for (const auto &[name, axis, sign] : expected)
    {
      const auto &pairs = lattice.pair_sets.at(name);
      ASSERT_EQ(pairs.size(), 2u);
      for (unsigned int cell = 0; cell < 2; ++cell)
        {
          const dealii::Tensor<1, 3> centre =
            on_axis(1, 2 * stub_distance * cell);
          const auto vertex = on_axis(axis, sign * vertex_distance);
          EXPECT_EQ(pairs[cell].cell, cell);
          EXPECT_EQ(pairs[cell].first, joint_at(lattice, vertex + centre));
          EXPECT_EQ(pairs[cell].second,
                    joint_at(lattice, dealii::Point<3>(centre - vertex)));
        }
    }
  EXPECT_EQ(lattice.pair_sets.at("in-cell all").size(), 6u);
}

TEST(SpaceStarCell, TipsOfNeighboursStayApart)
{
  for (const double degrees : {54.8, 60., 90.})
    {
      const auto   cell = space_star(std::to_string(degrees))->build();
      const double tip  = std::abs(cell.joints[0][0]);
      const double gap =
        2 * strut_length * (1 - std::cos(degrees / 180 * dealii::numbers::PI));
      for (unsigned int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(cell.vectors[axis][axis] - 2 * tip,
                    gap,
                    10 * space_star_round_off);
    }
}

TEST(SpaceStarCell, RefusesCrossingNotches)
{
  expect_parts(space_star_refusal("54 deg"),
               {"Lattice: the cell 'space star'",
                "theta0 = 54 deg",
                "L (sin(theta0) / sqrt(2) - cos(theta0)) > 0 fails",
                "54.74 deg (tan(theta0) > sqrt(2))"});
  // tan(theta0) = sqrt(2): the vertices meet in the centre.
  EXPECT_NE(space_star_refusal("54.735610317245346 deg"), "");
  EXPECT_EQ(space_star_refusal("54.7357 deg"), "");
  EXPECT_EQ(space_star_refusal("90 deg"), "");
  EXPECT_TRUE(
    contains(space_star_refusal("90.001 deg"), "theta0 <= 90 deg fails"));
}

TEST(SpaceStarCell, NeedsSpace)
{
  const auto message =
    input_error_of([]() { cell_from_text("space star", ""); });
  expect_parts(message, {"'space star'", "Set Dimension = 3", "'star'"});
}
