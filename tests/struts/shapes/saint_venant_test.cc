#include <auxfem/struts/shapes/saint_venant.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace auxfem;
  using dealii::numbers::PI;

  Outline regular_polygon(const unsigned int n, const double inner_radius)
  {
    Outline outline;
    for (unsigned int i = 0; i < n; ++i)
      outline.emplace_back(inner_radius / std::cos(PI / n) *
                             std::cos(2 * PI * i / n),
                           inner_radius / std::cos(PI / n) *
                             std::sin(2 * PI * i / n));
    return outline;
  }

  TEST(SaintVenant, TorsionOfTrianglesHasClosedForms)
  {
    // Equilateral triangle: sqrt(3) / 80 a^4. The warping is a cubic
    // polynomial, which elements of degree 4 contain.
    EXPECT_NEAR(
      section_in_outline({{0, 0}, {2, 0}, {1, std::sqrt(3.)}}).torsion_constant,
      std::sqrt(3.) / 80 * 16,
      1e-12);
    // Isosceles right triangle: 0.02609 a^4 (Timoshenko and Goodier).
    EXPECT_NEAR(section_in_outline({{0, 0}, {1, 0}, {0, 1}}).torsion_constant,
                0.02609,
                5e-6);
  }

  TEST(SaintVenant, TorsionOfRegularPolygonsIsThatOfRoarksTable)
  {
    // Roark's Formulas for Stress and Strain: hexagon of side s 1.0353 s^4,
    // octagon 3.6568 s^4; the latter with an area of 4.8284 s^2.
    const double hexagon =
      section_in_outline(regular_polygon(6, std::sqrt(0.75))).torsion_constant;
    EXPECT_NEAR(hexagon, 1.0353, 1e-3);
    const double octagon =
      section_in_outline(regular_polygon(8, 0.5 + std::sqrt(0.5)))
        .torsion_constant;
    EXPECT_NEAR(octagon, 3.6568, 0.004);
  }

  TEST(SaintVenant, TorsionOfRectanglesIsTheSeries)
  {
    for (const double ratio : {1., 2., 7.5})
      {
        double sum = 0;
        for (int n = 99; n > 0; n -= 2)
          sum += std::tanh(n * PI * ratio / 2) / std::pow(n, 5);
        const double J = ratio / 3 * (1 - 192 / std::pow(PI, 5) / ratio * sum);
        EXPECT_NEAR(section_in_outline({{0, 0}, {ratio, 0}, {ratio, 1}, {0, 1}})
                      .torsion_constant,
                    J,
                    1e-4 * J)
          << ratio;
      }
  }

  TEST(SaintVenant, ShearOfRectanglesIsFiveSixths)
  {
    const CrossSection bar =
      section_in_outline({{0, 0}, {3, 0}, {3, 1}, {0, 1}});
    EXPECT_NEAR(bar.shear_area_2, 2.5, 1e-12);
    EXPECT_NEAR(bar.shear_area_3, 2.5, 1e-12);
  }

  TEST(SaintVenant, ShearOfACircleIsSixSevenths)
  {
    const CrossSection circle = section_in_outline(regular_polygon(24, 1));
    EXPECT_NEAR(circle.shear_area_2 / circle.area, 6. / 7, 2e-4);
    EXPECT_NEAR(circle.torsion_constant * 2 * PI / std::pow(circle.area, 2),
                1,
                5e-4);
  }

  TEST(SaintVenant, ReentrantCornersAreResolved)
  {
    // Stresses at the sharp corner are singular. Reference: the same problems
    // on a finer mesh with degree 5 and 14 halvings at the corner. Two strips
    // with free ends would have 19 / 3 - 0.21, to which the corner adds.
    const CrossSection angle =
      section_in_outline({{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}});
    EXPECT_NEAR(angle.torsion_constant, 6.19574, 1e-4 * 6.19574);
    EXPECT_GT(angle.torsion_constant, 19. / 3 - 0.21);
    EXPECT_NEAR(angle.shear_area_2, 8.23398, 1e-4 * 8.23398);
    EXPECT_NEAR(angle.shear_area_3, 8.32086, 1e-4 * 8.32086);
  }

  TEST(SaintVenant, ConstantsScaleWithTheSection)
  {
    const Outline unit = {{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
    Outline       tiny;
    for (const dealii::Point<2> &corner : unit)
      tiny.push_back(1e-7 * corner + dealii::Point<2>(1e-5, 0));
    EXPECT_NEAR(section_in_outline(tiny).torsion_constant /
                  section_in_outline(unit).torsion_constant,
                1e-28,
                1e-34);
  }
} // namespace
