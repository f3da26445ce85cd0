#include <auxfem/struts/section_stresses.h>
#include <auxfem/struts/shapes/outline.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Forces = std::array<double, 6>;

  CrossSection rectangle(const double h, const double b)
  {
    CrossSection section;
    section.area               = b * h;
    section.second_moment_2    = h * b * b * b / 12;
    section.second_moment_3    = b * h * h * h / 12;
    section.make_stress_points = [b, h](const unsigned int dimension) {
      return rectangle_stress_points(h, b, dimension);
    };
    return section;
  }

  CrossSection tube(const double outer, const double inner)
  {
    CrossSection section;
    section.area            = pi * (outer * outer - inner * inner);
    section.second_moment_2 = section.second_moment_3 =
      pi / 4 * (std::pow(outer, 4) - std::pow(inner, 4));
    section.make_stress_points = [outer, inner](unsigned int) {
      return tube_stress_points(outer, inner);
    };
    return section;
  }
} // namespace

TEST(SectionStresses, OfARectangleInThePlane)
{
  const double          b = 0.01, h = 0.03, N = 40, Q = 25, M = 0.6;
  const SectionStresses section(rectangle(h, b), 2);
  const Stresses        all = section.at({{N, Q, 0, 0, 0, M}});
  EXPECT_NEAR(all.axial, N / (b * h), 1e-6);
  EXPECT_NEAR(all.bending, 6 * M / (b * h * h), 1e-6);
  EXPECT_NEAR(all.fibre, N / (b * h) + 6 * M / (b * h * h), 1e-6);
  EXPECT_NEAR(all.shear, 1.5 * Q / (b * h), 1e-6);
  EXPECT_EQ(all.torsion, 0);
  // The outer fibres have no shear, the middle no bending.
  EXPECT_NEAR(all.von_mises, all.fibre, 1e-6);
  EXPECT_NEAR(section.at({{0, Q, 0, 0, 0, 0}}).von_mises,
              std::sqrt(3.) * 1.5 * Q / (b * h),
              1e-6);
  EXPECT_NEAR(section.at({{-N, 0, 0, 0, 0, M}}).fibre, -all.fibre, 1e-6);
}

// Largest stress and its place from the derivative of (a y)^2 + 3 (1.5 Q / A)^2
// (1 - y^2)^2, between the axis and the outer fibre.
TEST(SectionStresses, OfARectangleBetweenAxisAndFibre)
{
  const double b = 0.01, h = 0.02, Q = 100;
  const double shear = 1.5 * Q / (b * h), bending = 1.2 * shear;
  const double M     = bending * b * h * h / 6;
  double       exact = 0;
  for (int i = 0; i <= 100000; ++i)
    {
      const double y = i / 100000.;
      exact =
        std::max(exact,
                 std::hypot(bending * y, std::sqrt(3.) * shear * (1 - y * y)));
    }
  EXPECT_NEAR(
    SectionStresses(rectangle(h, b), 2).at({{0, Q, 0, 0, 0, M}}).von_mises,
    exact,
    1e-3 * exact);
}

// Torsion of a square and of a rectangle 2 : 1: T / (0.208 a^3) and T / (0.246
// b t^2), Timoshenko & Goodier, table in section 109.
TEST(SectionStresses, OfTwistedRectangles)
{
  const double T = 3, a = 0.02;
  EXPECT_NEAR(
    SectionStresses(rectangle(a, a), 3).at({{0, 0, 0, T, 0, 0}}).torsion,
    T / (0.20817 * a * a * a),
    1e-4 * T / (0.208 * a * a * a) + 1);
  EXPECT_NEAR(
    SectionStresses(rectangle(2 * a, a), 3).at({{0, 0, 0, T, 0, 0}}).torsion,
    T / (0.2459 * 2 * a * a * a),
    5e-3 * T / (0.246 * 2 * a * a * a));
}

// Shear in the middle of a circle is (3 + 2 nu) / (2 (1 + nu)) of the mean
// (Timoshenko & Goodier, section 122), bending of the resultant moment.
TEST(SectionStresses, OfRoundSections)
{
  const double          r = 0.01, A = pi * r * r;
  const SectionStresses rod(tube(r, 0), 3);
  EXPECT_NEAR(rod.at({{0, 3, 4, 0, 0, 0}}).shear, 1.5 * 5 / A, 1e-6);
  EXPECT_NEAR(rod.at({{0, 0, 0, 0, 3, 4}}).bending,
              4 * 5 / (pi * r * r * r),
              1e-4);
  EXPECT_NEAR(rod.at({{0, 0, 0, 7, 0, 0}}).torsion,
              2 * 7 / (pi * r * r * r),
              1e-4);
  // A shaft: bending and torque are largest at the same fibre.
  const Stresses shaft = rod.at({{0, 0, 0, 7, 3, 4}});
  EXPECT_NEAR(shaft.von_mises,
              std::sqrt(shaft.bending * shaft.bending +
                        3 * shaft.torsion * shaft.torsion),
              1e-3);
  // A thin tube has twice the mean shear.
  const double thin = pi * (r * r - 0.99 * 0.99 * r * r);
  EXPECT_NEAR(
    SectionStresses(tube(r, 0.99 * r), 3).at({{0, 0, 5, 0, 0, 0}}).shear,
    2 * 5 / thin,
    0.02 * 5 / thin);
}

TEST(SectionStresses, OfAnEllipse)
{
  const double a = 0.02, b = 0.01;
  CrossSection ellipse;
  ellipse.area               = pi * a * b;
  ellipse.second_moment_2    = pi / 4 * a * b * b * b;
  ellipse.second_moment_3    = pi / 4 * a * a * a * b;
  ellipse.make_stress_points = [a, b](unsigned int) {
    return ellipse_stress_points(2 * a, 2 * b);
  };
  const SectionStresses section(ellipse, 3);
  EXPECT_NEAR(section.at({{0, 0, 0, 5, 0, 0}}).torsion,
              2 * 5 / (pi * a * b * b),
              1e-4);
  // The resultant of a circle, which is an ellipse too.
  const StressPoints circle = ellipse_stress_points(2 * b, 2 * b);
  for (const StressPoint &point : circle.points)
    {
      if (std::hypot(point.y, point.z) > 1e-9)
        continue;
      EXPECT_NEAR(point.by_shear_2[0], 1.5 / (pi * b * b), 1e-6);
      EXPECT_NEAR(point.by_shear_3[1], 1.5 / (pi * b * b), 1e-6);
    }
}

// A polygon has the stresses of the rectangle that it is.
TEST(SectionStresses, OfAnOutlineAreThoseOfTheRectangle)
{
  const double          h = 0.03, b = 0.02;
  const SectionStresses polygon(section_in_outline(
                                  {{0, 0}, {h, 0}, {h, b}, {0, b}}),
                                3),
    exact(rectangle(h, b), 3);
  const Forces bending = {{10, 0, 0, 0, 2, 3}}, twist = {{0, 0, 0, 4, 0, 0}},
               shear = {{0, 30, 0, 0, 0, 0}};
  EXPECT_NEAR(polygon.at(bending).fibre, exact.at(bending).fibre, 1);
  EXPECT_NEAR(polygon.at(twist).torsion,
              exact.at(twist).torsion,
              2e-3 * exact.at(twist).torsion);
  EXPECT_NEAR(polygon.at(shear).shear,
              exact.at(shear).shear,
              2e-3 * exact.at(shear).shear);
}

// Bredt's formula is the mean over the wall; inside, stresses grow towards the
// corners.
TEST(SectionStresses, OfABoxAreThoseOfBredt)
{
  const double          a = 0.1, t = 0.002, T = 50;
  const SectionStresses box(section_in_outline({{0, 0},
                                                {a, 0},
                                                {a, a},
                                                {0, a},
                                                {0, 0},
                                                {t, t},
                                                {t, a - t},
                                                {a - t, a - t},
                                                {a - t, t},
                                                {t, t}}),
                            3);
  const double          bredt   = T / (2 * (a - t) * (a - t) * t);
  const double          torsion = box.at({{0, 0, 0, T, 0, 0}}).torsion;
  EXPECT_GT(torsion, bredt);
  EXPECT_LT(torsion, 1.15 * bredt);
}

TEST(SectionStresses, AreNotKnownWithoutAShape)
{
  CrossSection given;
  given.area = 2;
  const SectionStresses section(given, 3);
  EXPECT_FALSE(section.has_shape());
  const Stresses stresses = section.at({{6, 0, 0, 0, 0, 1}});
  EXPECT_EQ(stresses.axial, 3);
  EXPECT_TRUE(std::isnan(stresses.bending));
  EXPECT_TRUE(std::isnan(stresses.von_mises));
  EXPECT_EQ(section.at({{6, 0, 0, 0, 0, 0}}).von_mises, 3);
}
