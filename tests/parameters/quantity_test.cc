#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/quantity.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

namespace
{
  using namespace auxfem;
  using Dimension = std::array<int, 5>;
  using Words     = std::vector<std::string>;

  struct UnitCase
  {
    const char *text;
    Dimension   dimension; // length, mass, time, angle
    double      factor;
  };

  TEST(Quantity, UnitsReduceToSI)
  {
    const double degree = dealii::numbers::PI / 180;
    for (const UnitCase &unit : std::vector<UnitCase>{
           {"1", {{0, 0, 0, 0, 0}}, 1},
           {"%", {{0, 0, 0, 0, 0}}, 0.01},
           {"K", {{0, 0, 0, 0, 1}}, 1},
           {"m", {{1, 0, 0, 0, 0}}, 1},
           {"mm", {{1, 0, 0, 0, 0}}, 1e-3},
           {"in", {{1, 0, 0, 0, 0}}, 0.0254},
           {"us", {{0, 0, 1, 0, 0}}, 1e-6},
           {"min", {{0, 0, 1, 0, 0}}, 60},
           {"1/s", {{0, 0, -1, 0, 0}}, 1},
           {"/s", {{0, 0, -1, 0, 0}}, 1},
           {"Hz", {{0, 0, -1, 0, 0}}, 1},
           {"deg", {{0, 0, 0, 1, 0}}, degree},
           {"rad/s", {{0, 0, -1, 1, 0}}, 1},
           {"m/s2", {{1, 0, -2, 0, 0}}, 1},
           {"m/s^2", {{1, 0, -2, 0, 0}}, 1},
           {"m s^-2", {{1, 0, -2, 0, 0}}, 1},
           {"mm^4", {{4, 0, 0, 0, 0}}, 1e-12},
           {"kg/m3", {{-3, 1, 0, 0, 0}}, 1},
           {"g/cm3", {{-3, 1, 0, 0, 0}}, 1e3},
           {"GPa", {{-1, 1, -2, 0, 0}}, 1e9},
           {"N/mm2", {{-1, 1, -2, 0, 0}}, 1e6},
           {"kN/m", {{0, 1, -2, 0, 0}}, 1e3},
           {"N s/m", {{0, 1, -1, 0, 0}}, 1},
           {"N*s/m", {{0, 1, -1, 0, 0}}, 1},
           {"N / m * s", {{0, 1, -1, 0, 0}}, 1},
           {"N m/rad", {{2, 1, -2, -1, 0}}, 1},
           {"lbf", {{1, 1, -2, 0, 0}}, 4.4482216152605},
           {"kip", {{1, 1, -2, 0, 0}}, 4448.2216152605},
           {"psi", {{-1, 1, -2, 0, 0}}, 6894.757293168361},
           {"ksi", {{-1, 1, -2, 0, 0}}, 6894757.293168361},
           {"Msi", {{-1, 1, -2, 0, 0}}, 6894757293.168361},
           {"lbf/in2", {{-1, 1, -2, 0, 0}}, 6894.757293168361},
           {"psf", {{-1, 1, -2, 0, 0}}, 47.88025898033584},
           {"slug/ft3", {{-3, 1, 0, 0, 0}}, 515.3788183931961},
           {"lb/ft3", {{-3, 1, 0, 0, 0}}, 16.01846337396014},
           {"kip/ft", {{0, 1, -2, 0, 0}}, 14593.90293720636}})
      {
        const Unit result = parse_unit(unit.text);
        EXPECT_EQ(result.dimension, unit.dimension) << unit.text;
        // Products of powers of ten are exact up to a few roundings.
        EXPECT_NEAR(result.factor / unit.factor, 1, 1e-14) << unit.text;
      }
  }



  TEST(Quantity, OtherTextIsNoUnit)
  {
    for (const char *text :
         {"", "furlong", "m//s", "m/", "*m", "2 m", "m^", "m23", "m+s", ",5"})
      EXPECT_THROW(parse_unit(text), InputError) << text;
  }



  TEST(Quantity, UnknownUnitWordGetsASuggestion)
  {
    try
      {
        parse_unit("GPA");
        FAIL();
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("GPa"), std::string::npos)
          << error.what();
      }
  }



  TEST(Quantity, ValuesAreConvertedToSI)
  {
    // One multiplication away from the exact number.
    EXPECT_DOUBLE_EQ(parse_quantity("10 mm", "m"), 0.01);
    EXPECT_DOUBLE_EQ(parse_quantity("10mm", "m"), 0.01);
    EXPECT_DOUBLE_EQ(parse_quantity(" +2.5e-3 ", "m"), 2.5e-3);
    EXPECT_DOUBLE_EQ(parse_quantity("70 GPa", "Pa"), 70e9);
    EXPECT_DOUBLE_EQ(parse_quantity("3", "mm"), 3e-3);
    EXPECT_DOUBLE_EQ(parse_quantity("180", "deg"), dealii::numbers::PI);
    EXPECT_DOUBLE_EQ(parse_quantity("2 rad", "deg"), 2);
    EXPECT_DOUBLE_EQ(parse_quantity("-5 1/s", "1/s"), -5);
    EXPECT_DOUBLE_EQ(parse_quantity("20 N/mm", "N/m"), 20e3);
    EXPECT_DOUBLE_EQ(parse_quantity("-5/6", "1"), -5. / 6);
    EXPECT_DOUBLE_EQ(parse_quantity("1/2 mm", "m"), 5e-4);
  }



  TEST(Quantity, OtherTextIsNoQuantity)
  {
    for (const char *text : {"",
                             "m",
                             "abc",
                             "nan",
                             "inf",
                             "1e999",
                             "10 s",
                             "1,5",
                             "1/0",
                             "1/2/3",
                             "2*pi",
                             "1 m/s"})
      EXPECT_THROW(parse_quantity(text, "m"), InputError) << text;
  }



  TEST(Quantity, ListsSplitAtCommasOrBeforeNumbers)
  {
    EXPECT_EQ(split_quantity_list("1, 2 mm,3"), (Words{"1", "2 mm", "3"}));
    EXPECT_EQ(split_quantity_list("1 2 mm -3"), (Words{"1", "2 mm", "-3"}));
    EXPECT_EQ(split_quantity_list("1 N s/m 2"), (Words{"1 N s/m", "2"}));
    EXPECT_EQ(split_quantity_list("1 1/s 2 1/s"), (Words{"1 1/s", "2 1/s"}));
    EXPECT_EQ(split_quantity_list("2 1/3"), (Words{"2", "1/3"}));
    EXPECT_EQ(split_quantity_list("1 2 mm, 3"), (Words{"1", "2 mm", "3"}));
    EXPECT_EQ(split_quantity_list("1,, 2"), (Words{"1", "", "2"}));
    EXPECT_EQ(split_quantity_list("  "), Words{});
    EXPECT_EQ(split_words("3, 5 7 ,9"), (Words{"3", "5", "7", "9"}));
    EXPECT_EQ(split_words("3,,5"), (Words{"3", "", "5"}));
  }



  TEST(Quantity, FittingUnitsBeginWithTheDeclaredOne)
  {
    EXPECT_EQ(fitting_units("m"),
              (Words{"m", "mm", "cm", "um", "km", "in", "ft"}));
    EXPECT_EQ(fitting_units("deg"), (Words{"deg", "rad"}));
    const std::string unit = "N s/m";
    ASSERT_GT(fitting_units(unit).size(), 5u);
    EXPECT_EQ(fitting_units(unit).front(), unit);
    for (const std::string &other : fitting_units(unit))
      EXPECT_EQ(parse_unit(other).dimension, parse_unit(unit).dimension)
        << other;
  }



  TEST(Quantity, HasAnSiUnitByWhatItMeasures)
  {
    EXPECT_EQ(si_unit("mm"), "m");
    EXPECT_EQ(si_unit("deg"), "rad");
    EXPECT_EQ(si_unit("GPa"), "m^-1 kg s^-2");
    EXPECT_EQ(si_unit("%"), "");
    for (const char *const unit : {"GPa", "N s/m", "kg/m3", "1/K", "ft"})
      EXPECT_DOUBLE_EQ(parse_quantity("3 " + si_unit(unit), unit), 3) << unit;
  }
} // namespace
