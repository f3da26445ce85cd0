#include <auxfem/struts/shapes/outline.h>
#include <auxfem/struts/shapes/triangulation.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
  using namespace auxfem;
  using dealii::numbers::PI;

  const Outline star = {{2, 0},
                        {0.5, 0.5},
                        {0, 2},
                        {-0.5, 0.5},
                        {-2, 0},
                        {-0.5, -0.5},
                        {0, -2},
                        {0.5, -0.5}};

  double area_of_triangles(const Outline &outline)
  {
    const TriangulatedSection section = triangulate(outline);
    double                    area    = 0;
    for (const auto &[a, b, c] : section.triangles)
      {
        const double twice =
          twice_area(section.points[a], section.points[b], section.points[c]);
        EXPECT_GT(twice, 0);
        area += twice / 2;
      }
    return area;
  }

  TEST(Outline, TrianglesFillThePolygonAndLeaveHolesFree)
  {
    EXPECT_NEAR(area_of_triangles(star), signed_area(star), 1e-14);
    EXPECT_NEAR(area_of_triangles({{0, 0},
                                   {3, 0},
                                   {3, 3},
                                   {0, 3},
                                   {0, 0},
                                   {1, 1},
                                   {1, 2},
                                   {2, 2},
                                   {2, 1},
                                   {1, 1}}),
                8,
                1e-14);
    // Corners on straight sides.
    EXPECT_NEAR(
      area_of_triangles(
        {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}),
      4,
      1e-14);
  }

  TEST(Outline, OnlyCornersWellBeyondPiAreReentrant)
  {
    EXPECT_EQ(triangulate(star).reentrant_corners.size(), 4u);
    EXPECT_TRUE(
      triangulate(
        rounded_outline({{0, 0}, {3, 0}, {3, 1}, {1, 1, 0.5}, {1, 3}, {0, 3}}))
        .reentrant_corners.empty());
  }

  TEST(Outline, ArcsKeepTheArea)
  {
    const Outline rounded =
      rounded_outline({{0, 0, 1}, {4, 0, 1}, {4, 3, 1}, {0, 3, 1}});
    EXPECT_NEAR(signed_area(rounded), 12 - (4 - PI), 1e-13);
    const Outline fillet =
      rounded_outline({{0, 0}, {4, 0}, {4, 1}, {1, 1, 2}, {1, 4}, {0, 4}});
    EXPECT_NEAR(signed_area(fillet), 7 + (4 - PI), 1e-13);
    // Arcs that meet, a circle.
    EXPECT_NEAR(signed_area(rounded_outline(
                  {{0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}})),
                PI,
                1e-13);
  }

  TEST(Outline, ArcsMayTakeUpWholeSides)
  {
    // Half circles at both ends of a strip; a fillet up to the tip.
    const Outline strip =
      rounded_outline({{0, 0, 1}, {5, 0, 1}, {5, 2, 1}, {0, 2, 1}});
    EXPECT_NEAR(area_of_triangles(strip), 6 + PI, 1e-13);
    const Outline angle = rounded_outline(
      {{0, 0}, {1.1, 0}, {1.1, 0.1}, {0.1, 0.1, 1}, {0.1, 1.1}, {0, 1.1}});
    for (std::size_t i = 0; i < angle.size(); ++i)
      EXPECT_GT(angle[i].distance(angle[(i + 1) % angle.size()]), 0.01);
    EXPECT_NEAR(area_of_triangles(angle), 0.21 + 1 - PI / 4, 1e-13);
  }

  TEST(Outline, SidesThatCrossOrTouchAreFound)
  {
    EXPECT_FALSE(crossing_sides(star));
    EXPECT_TRUE(crossing_sides({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
    // A corner on another side.
    EXPECT_TRUE(crossing_sides({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));
    // A side that goes back on the one before.
    EXPECT_TRUE(crossing_sides({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));
    EXPECT_TRUE(crossing_sides({{0, 0}, {1, 0}, {2, 0}}));
  }

  TEST(Outline, MomentsAreThoseOfRectangles)
  {
    const CrossSection bar =
      section_in_outline({{7, 5}, {13, 5}, {13, 7}, {7, 7}});
    EXPECT_NEAR(bar.area, 12, 1e-12);
    EXPECT_NEAR(bar.second_moment_3, 36, 1e-11);
    EXPECT_NEAR(bar.second_moment_2, 4, 1e-11);
    EXPECT_EQ(bar.principal_angle, 0);
    EXPECT_NEAR(bar.half_thicknesses[0], 1, 1e-13);
    EXPECT_NEAR(bar.half_thicknesses[1], 3, 1e-13);
    EXPECT_EQ(bar.outer_fibres.size(), 4u);
  }

  TEST(Outline, AxesTurnWithTheSection)
  {
    // The bar above, turned by 0.3 rad about axis 1 from axis 2 to axis 3.
    const double c = std::cos(0.3), s = std::sin(0.3);
    Outline      turned;
    for (const auto &[y, z] :
         {std::array<double, 2>{{-3, -1}}, {{3, -1}}, {{3, 1}}, {{-3, 1}}})
      turned.emplace_back(c * y - s * z, s * y + c * z);
    const CrossSection bar = section_in_outline(turned);
    EXPECT_NEAR(bar.principal_angle, 0.3, 1e-13);
    EXPECT_NEAR(bar.second_moment_3, 36, 1e-11);
    EXPECT_NEAR(bar.second_moment_2, 4, 1e-11);
    EXPECT_NEAR(bar.half_thicknesses[1], 3, 1e-13);
  }

  TEST(Outline, FibresOfAnUnsymmetricSectionLieAtItsHull)
  {
    // T: flange 4 x 1 on a web 1 x 4, centroid 3.25 above the foot.
    const CrossSection tee = section_in_outline({{0, -0.5},
                                                 {4, -0.5},
                                                 {4, -2},
                                                 {5, -2},
                                                 {5, 2},
                                                 {4, 2},
                                                 {4, 0.5},
                                                 {0, 0.5}});
    EXPECT_EQ(tee.outer_fibres.size(), 6u);
    double lowest = 0, highest = 0;
    for (const dealii::Point<2> &fibre : tee.outer_fibres)
      {
        lowest  = std::min(lowest, fibre[0]);
        highest = std::max(highest, fibre[0]);
      }
    EXPECT_NEAR(lowest, -3.25, 1e-13);
    EXPECT_NEAR(highest, 1.75, 1e-13);
    EXPECT_NEAR(tee.half_thicknesses[1], 2.5, 1e-13);
  }
} // namespace
