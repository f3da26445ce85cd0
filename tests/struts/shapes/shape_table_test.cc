#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>
#include <struts/shapes/shape_on_trial.h>

#include <cmath>

#include <support/messages.h>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;
  using dealii::numbers::PI;

  std::string refusal(const std::string &name, const Entries &entries)
  {
    return input_error_of([&] { shape(name, entries); });
  }

  Entries rolled(const std::string &height,
                 const std::string &width,
                 const std::string &web,
                 const std::string &flange,
                 const std::string &fillet = "0 m")
  {
    return {{"Height", height},
            {"Width", width},
            {"Web thickness", web},
            {"Flange thickness", flange},
            {"Fillet radius", fillet}};
  }

  TEST(ShapeTable, EllipseIsACircleForEqualDiameters)
  {
    const CrossSection round =
      shape("ellipse", {{"Width", "2"}, {"Height", "2"}});
    EXPECT_NEAR(round.area, PI, 1e-15);
    EXPECT_NEAR(round.second_moment_2, PI / 4, 1e-15);
    EXPECT_NEAR(round.torsion_constant, PI / 2, 1e-15);
    EXPECT_NEAR(round.shear_area_3, PI * 6 / 7, 1e-15);
  }

  TEST(ShapeTable, EllipseHasTheConstantsOfAPolygonInIt)
  {
    std::string corners;
    for (int i = 0; i < 24; ++i)
      corners += (i == 0 ? "" : ", ") +
        std::to_string(3 * std::cos(i * PI / 12)) + ", " +
        std::to_string(std::sin(i * PI / 12));
    const CrossSection polygon = shape("polygon", {{"Corners", corners}}),
                       ellipse =
                         shape("ellipse", {{"Width", "2"}, {"Height", "6"}});
    EXPECT_NEAR(polygon.area / ellipse.area, 1, 0.012);
    EXPECT_NEAR(polygon.shear_area_2 / polygon.area,
                ellipse.shear_area_2 / ellipse.area,
                2e-3);
    EXPECT_NEAR(polygon.shear_area_3 / polygon.area,
                ellipse.shear_area_3 / ellipse.area,
                2e-3);
    EXPECT_NEAR(polygon.torsion_constant / std::pow(polygon.area, 2),
                ellipse.torsion_constant / std::pow(ellipse.area, 2),
                2e-3);
  }

  /** Torsion constant of a thin box over Bredt's, minus one. */
  double excess_over_bredt(const double t)
  {
    const CrossSection box = shape("box",
                                   {{"Width", "4"},
                                    {"Height", "8"},
                                    {"Wall thickness", std::to_string(t)}});
    EXPECT_NEAR(box.area, 32 - (4 - 2 * t) * (8 - 2 * t), 1e-12);
    EXPECT_NEAR(box.second_moment_3,
                (4 * 512 - (4 - 2 * t) * std::pow(8 - 2 * t, 3)) / 12,
                1e-10);
    // 4 A_m^2 t / perimeter of the middle line.
    const double b = 4 - t, h = 8 - t;
    return box.torsion_constant * (b + h) / (2 * b * b * h * h * t) - 1;
  }

  TEST(ShapeTable, TorsionOfThinBoxesTendsToBredts)
  {
    // Corners stiffen a box by a part proportional to the thickness.
    const double thick = excess_over_bredt(0.04),
                 thin  = excess_over_bredt(0.02);
    EXPECT_LT(thin, 2e-3);
    EXPECT_NEAR(thick / thin, 2, 0.1);
  }

  TEST(ShapeTable, WallsOfABoxMayDiffer)
  {
    const CrossSection box = shape("box",
                                   {{"Width", "4"},
                                    {"Height", "8"},
                                    {"Wall thickness", "1"},
                                    {"Flange thickness", "2"}});
    EXPECT_NEAR(box.area, 32 - 2 * 4, 1e-12);
    EXPECT_NEAR(box.second_moment_3, (4 * 512 - 2 * 64) / 12., 1e-11);
    EXPECT_NEAR(box.second_moment_2, (8 * 64 - 4 * 8) / 12., 1e-11);
  }

  TEST(ShapeTable, ThinOpenSectionsTwistLikeTheirStrips)
  {
    // J -> sum b t^3 / 3 for thin walls; the corners add a little.
    const CrossSection c      = shape("C", rolled("10", "5", "0.02", "0.02"));
    const double       strips = 20 * 8e-6 / 3;
    EXPECT_NEAR(c.torsion_constant, strips, 3e-3 * strips);
  }

  TEST(ShapeTable, FilletsOfAnIEnterAreaAndMoments)
  {
    // IPE 200 from its dimensions, cm.
    const CrossSection beam =
      shape("I", rolled("20", "10", ".56", ".85", "1.2"));
    EXPECT_TRUE(agrees(beam.area, 28.48, 4)) << beam.area;
    EXPECT_TRUE(agrees(beam.second_moment_3, 1943, 4)) << beam.second_moment_3;
    EXPECT_TRUE(agrees(beam.second_moment_2, 142.4, 4)) << beam.second_moment_2;
    EXPECT_EQ(beam.principal_angle, 0);
    EXPECT_NEAR(beam.half_thicknesses[0], 5, 1e-13);
    EXPECT_NEAR(beam.half_thicknesses[1], 10, 1e-13);
  }

  TEST(ShapeTable, AnglesHaveTheirPrincipalAxesTurned)
  {
    // L 100 x 10 of EN 10056: A, I_u and I_v in cm.
    const CrossSection angle = shape("L",
                                     {{"Height", "10"},
                                      {"Width", "10"},
                                      {"Thickness", "1"},
                                      {"Fillet radius", "1.2"},
                                      {"Toe radius", "0.6"}});
    EXPECT_TRUE(agrees(angle.area, 19.2, 3)) << angle.area;
    EXPECT_NEAR(std::abs(angle.principal_angle), PI / 4, 1e-12);
    EXPECT_TRUE(
      agrees(std::max(angle.second_moment_2, angle.second_moment_3), 280, 3))
      << angle.second_moment_2 << " " << angle.second_moment_3;
    EXPECT_NEAR(angle.second_moment_2 + angle.second_moment_3, 2 * 177, 1);
  }

  TEST(ShapeTable, TeesBendAboutTheirCentroid)
  {
    const CrossSection tee = shape("T", rolled("5", "4", "1", "1"));
    EXPECT_NEAR(tee.area, 8, 1e-13);
    // Foot at -3.25, flange from 0.75 to 1.75.
    EXPECT_NEAR(tee.second_moment_3,
                64 / 12. + 4 * 1.25 * 1.25 + 4 / 12. + 4 * 1.25 * 1.25,
                1e-12);
    EXPECT_EQ(tee.principal_angle, 0);
  }

  TEST(ShapeTable, TorsionConstantsMayBeGiven)
  {
    Entries entries = rolled("20", "10", ".56", ".85", "1.2");
    entries.push_back({"Torsion constant", "6.98"});
    EXPECT_EQ(shape("I", entries).torsion_constant, 6.98);
  }

  TEST(ShapeTable, RefusesWallsThatFillTheSection)
  {
    expect_parts(refusal("I", rolled("20", "10", ".5", "10")),
                 {"Sections/s/Flange thickness = 10", "Height = 20", "half"});
    expect_parts(refusal("T", rolled("20", "10", ".5", "20")),
                 {"Sections/s/Flange thickness = 20", "Height = 20"});
    expect_parts(refusal("C", rolled("20", "10", "10", "1")),
                 {"Sections/s/Web thickness = 10", "Width = 10", "rectangle"});
    expect_parts(refusal("L",
                         {{"Height", "3"}, {"Width", "2"}, {"Thickness", "2"}}),
                 {"Sections/s/Thickness = 2", "3 and 2 long"});
    expect_parts(
      refusal("box",
              {{"Width", "4"}, {"Height", "8"}, {"Wall thickness", "2"}}),
      {"Sections/s/Wall thickness = 2", "4 wide", "rectangle"});
    expect_parts(refusal("box",
                         {{"Width", "4"},
                          {"Height", "8"},
                          {"Wall thickness", "1"},
                          {"Flange thickness", "4"}}),
                 {"Sections/s/Flange thickness = 4", "8 high"});
  }

  TEST(ShapeTable, RefusesFilletsThatDoNotFit)
  {
    expect_parts(refusal("I", rolled("20", "10", "1", "1", "5")),
                 {"Sections/s/Fillet radius = 5", "at most 4.5 m"});
    expect_parts(refusal("C", rolled("6", "10", "1", "1", "3")),
                 {"Sections/s/Fillet radius = 3", "at most 2 m"});
    expect_parts(refusal("L",
                         {{"Height", "10"},
                          {"Width", "10"},
                          {"Thickness", "1"},
                          {"Toe radius", "2"}}),
                 {"Sections/s/Toe radius = 2", "at most 1 m"});
    EXPECT_NEAR(shape("I", rolled("20", "10", "1", "1", "4.5")).area,
                38 + (4 - PI) * 4.5 * 4.5,
                1e-12);
  }

  TEST(ShapeTable, RefusesPolygonsByTheirCorners)
  {
    expect_parts(refusal("polygon", {{"Corners", "0 0 1 1 1 0 0 1"}}),
                 {"Sections/s/Corners = ", "1 - 2 and 3 - 4", "cross"});
    expect_parts(refusal("polygon", {{"Corners", "0 0 1 0 1 1 2"}}),
                 {"Sections/s/Corners = ", "7 numbers"});
    expect_parts(refusal("polygon", {{"Corners", "0 0 1 0 1 1 0 0"}}),
                 {"Sections/s/Corners = ", "corners 4 - 1 are the same"});
  }

  TEST(ShapeTable, PolygonsMayGoEitherWay)
  {
    const CrossSection one = shape("polygon", {{"Corners", "0 0 2 0 2 1 0 1"}}),
                       other =
                         shape("polygon", {{"Corners", "0 0 0 1 2 1 2 0"}});
    EXPECT_NEAR(one.area, 2, 1e-15);
    EXPECT_NEAR(other.area, 2, 1e-15);
    EXPECT_NEAR(one.second_moment_3, other.second_moment_3, 1e-15);
  }
} // namespace
