#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <scene/expect_close.h>

#include <cmath>

#include <support/messages.h>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;
  using dealii::numbers::PI;

  Section section(const std::string &entries, const std::string &dimension)
  {
    return read_scene_from_text("subsection Lattice\n set Cell = star\nend\n"
                                "subsection Sections\n subsection name\n"
                                "set Young's modulus = 26\nset Density = 2\n" +
                                  entries + "\n end\nend\n",
                                "scene.prm",
                                {"Dimension=" + dimension})
      .sections.at(0)
      .section;
  }

  Section section(const std::string &entries)
  {
    return section(entries, "3");
  }

  Section rectangle(const double width, const double height)
  {
    return section(
      "set Shape = rectangle\nset Width = " + std::to_string(width) +
      "\nset Height = " + std::to_string(height));
  }

  const std::string given = "set Shape = given\nset Area = 12\n"
                            "set Shear area = 10\n"
                            "set Second moment of area = 36\n";

  TEST(StrutSections, RectangleBendsAboutBothAxes)
  {
    const Section bar = rectangle(2, 6);
    expect_close(bar.second_moment_3, 2. * 6 * 6 * 6 / 12);
    expect_close(bar.second_moment_2, 6. * 2 * 2 * 2 / 12);
    expect_close(bar.shear_area_2, 10);
    expect_close(bar.shear_area_3, 10);
    // G = 26 / 2.6
    expect_close(bar.torsion_stiffness(), 10 * bar.torsion_constant);
    expect_close(bar.rotary_inertia_per_length()[0], 2 * (36 + 4));
    expect_close(bar.rotary_inertia_per_length()[1], 2 * 4);
    expect_close(bar.rotary_inertia_per_length()[2], 2 * 36);
  }



  TEST(StrutSections, TorsionOfRectanglesIsSaintVenants)
  {
    // Timoshenko and Goodier, Theory of Elasticity, section 109: J / (b t^3)
    // to the digits of the table; the square to six digits from the series.
    EXPECT_NEAR(rectangle(1, 1).torsion_constant, 0.140577, 5e-7);
    const std::vector<std::pair<double, double>> table = {{1, 0.1406},
                                                          {1.2, 0.166},
                                                          {1.5, 0.196},
                                                          {2, 0.229},
                                                          {2.5, 0.249},
                                                          {3, 0.263},
                                                          {4, 0.281},
                                                          {5, 0.291},
                                                          {10, 0.312}};
    for (const auto &[ratio, expected] : table)
      {
        const double tolerance = expected == 0.1406 ? 5e-5 : 5e-4;
        EXPECT_NEAR(rectangle(8 * ratio, 8).torsion_constant /
                      (ratio * std::pow(8, 4)),
                    expected,
                    tolerance)
          << ratio;
      }
  }



  TEST(StrutSections, TorsionOfAThinStrip)
  {
    // 1 - 0.63 t/b is the series with all tanh set to 1, which at b/t = 50 is
    // exact; the factor is 192/pi^5 31/32 zeta(5) = 0.630249.
    const double thin = 30 * std::pow(0.6, 3) / 3;
    EXPECT_NEAR(rectangle(30, 0.6).torsion_constant / thin,
                1 - 0.63 * 0.02,
                0.00025 * 0.02);
    EXPECT_NEAR(rectangle(30, 0.6).torsion_constant,
                rectangle(0.6, 30).torsion_constant,
                1e-15);
  }



  TEST(StrutSections, TorsionOfTheSquareIsExactToRoundOff)
  {
    // the series as printed, summed from its small terms to its large ones;
    // beyond n = 20000 it adds less than 1e-18
    double sum = 0;
    for (int n = 19999; n > 0; n -= 2)
      sum += std::tanh(n * PI / 2) / std::pow(n, 5);
    expect_close(rectangle(1, 1).torsion_constant,
                 (1 - 192 / std::pow(PI, 5) * sum) / 3);
  }



  TEST(StrutSections, RoundSectionsAreTheSameAboutEveryAxis)
  {
    const Section circle = section("set Shape = circle\nset Radius = 2");
    expect_close(circle.second_moment_2, 4 * PI);
    expect_close(circle.torsion_constant, 8 * PI);
    expect_close(circle.shear_area_3, 3.6 * PI);
    const Section tube =
      section("set Shape = tube\nset Outer radius = 2\nset Wall thickness = 1\n"
              "set Shear correction = 0.6");
    expect_close(tube.second_moment_2, 15 * PI / 4);
    expect_close(tube.second_moment_3, 15 * PI / 4);
    expect_close(tube.torsion_constant, 15 * PI / 2);
    expect_close(tube.shear_area_3, 1.8 * PI);
  }



  TEST(StrutSections, GivenNumbersAreTheSameBothWaysUnlessSaid)
  {
    const Section automatic = section(given);
    expect_close(automatic.shear_area_3, 10);
    expect_close(automatic.second_moment_2, 36);
    expect_close(automatic.torsion_constant, 72);
    expect_close(automatic.rotary_inertia_per_length()[0], 144);

    const Section full =
      section(given +
              "set Shear area 3 = 9\nset Second moment of area 2 = 4\n"
              "set Torsion constant = 11\n"
              "set Rotary inertia = 1, 2, 3");
    expect_close(full.shear_area_2, 10);
    expect_close(full.shear_area_3, 9);
    expect_close(full.second_moment_3, 36);
    expect_close(full.second_moment_2, 4);
    expect_close(full.torsion_constant, 11);
    EXPECT_EQ(full.rotary_inertia_per_length(),
              (std::array<double, 3>{{1, 2, 3}}));
    expect_close(
      section(given + "set Second moment of area 2 = 4").torsion_constant,
      40);
  }



  TEST(StrutSections, TorsionConstantOfARectangleMayBeGiven)
  {
    expect_close(section("set Shape = rectangle\nset Width = 1\n"
                         "set Height = 1\nset Torsion constant = 0.2")
                   .torsion_constant,
                 0.2);
  }



  TEST(StrutSections, ReferenceVectorIsOptional)
  {
    EXPECT_FALSE(section(given).reference);
    const Section turned = section(given + "set Reference vector = 0 3 4");
    ASSERT_TRUE(turned.reference);
    // a square root and quotients
    EXPECT_LT((*turned.reference - dealii::Tensor<1, 3>({0, 0.6, 0.8})).norm(),
              4e-16);
    expect_parts(input_error_of(
                   [] { section(given + "set Reference vector = 0 0 0"); }),
                 {"Sections/name/Reference vector = 0 0 0", "zero vector"});
    expect_parts(input_error_of(
                   [] { section(given + "set Reference vector = 0 1"); }),
                 {"Sections/name/Reference vector", "auto, or 3 numbers"});
  }



  TEST(StrutSections, ThePlaneRefusesTurnedPrincipalAxes)
  {
    const std::string angle =
      "set Shape = L\nset Height = 10\nset Width = 10\nset Thickness = 1";
    expect_parts(input_error_of([&] { section(angle, "2"); }),
                 {"Sections/name/Shape = L",
                  "turned by 45 degrees",
                  "Dimension = 3",
                  "Second moment of area = 180 m4"});
    EXPECT_NEAR(section(angle).orientation().principal_angle, PI / 4, 1e-12);
    const Section upright =
      section("set Shape = polygon\nset Corners = 0 -1, 0 1, 3 0", "2");
    expect_close(upright.area, 3);
  }



  TEST(StrutSections, ThePlaneAcceptsParametersOfSpace)
  {
    const Section plane =
      section(given +
                "set Torsion constant = 11\nset Shear area 3 = 9\n"
                "set Reference vector = 0 1 0",
              "2");
    expect_close(plane.torsion_constant, 11);
    expect_close(plane.second_moment_3, 36);
  }
} // namespace
