#include <gtest/gtest.h>
#include <struts/shapes/shape_on_trial.h>

#include <algorithm>
#include <cmath>

#include <support/messages.h>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;

  CrossSection profile(const std::string &name)
  {
    return shape("profile", {{"Profile", name}});
  }

  /** A line of the manufacturers' tables (ArcelorMittal, Sections and Merchant
   * Bars; Bautabellen): A (cm2), I about the strong and the weak axis and J
   * (cm4), as printed. */
  struct Published
  {
    std::string name, area, strong, weak, torsion;
  };

  /** Number of significant digits of a printed number without idle zeros. */
  int digits_of(const std::string &text)
  {
    return std::count_if(text.begin(), text.end(), [](const char c) {
      return c >= '0' && c <= '9';
    });
  }

  bool agrees_with(const double value, const std::string &text)
  {
    // Tables print four digits at most and fill up with zeros.
    return agrees(value, std::stod(text), std::min(digits_of(text), 4));
  }

  const std::vector<Published> i_sections = {
    {"IPE 80", "7.64", "80.1", "8.49", "0.70"},
    {"IPE 100", "10.32", "171.0", "15.92", "1.20"},
    {"IPE 120", "13.21", "317.8", "27.67", "1.74"},
    {"IPE 140", "16.43", "541.2", "44.92", "2.45"},
    {"IPE 160", "20.09", "869.3", "68.31", "3.60"},
    {"IPE 180", "23.95", "1317", "100.9", "4.79"},
    {"IPE 200", "28.48", "1943", "142.4", "6.98"},
    {"IPE 240", "39.12", "3892", "283.6", "12.88"},
    {"IPE 300", "53.81", "8356", "603.8", "20.12"},
    {"IPE 400", "84.46", "23130", "1318", "51.08"},
    {"IPE 500", "115.5", "48200", "2142", "89.29"},
    {"IPE 600", "156.0", "92080", "3387", "165.4"},
    {"HEA 100", "21.24", "349.2", "133.8", "5.24"},
    {"HEA 200", "53.83", "3692", "1336", "20.98"},
    {"HEA 300", "112.5", "18260", "6310", "85.17"},
    {"HEA 400", "159.0", "45070", "8564", "189.0"},
    {"HEA 600", "226.5", "141200", "11270", "397.8"},
    {"HEB 100", "26.04", "449.5", "167.3", "9.25"},
    {"HEB 200", "78.08", "5696", "2003", "59.28"},
    {"HEB 300", "149.1", "25170", "8563", "185.0"},
    {"HEB 400", "197.8", "57680", "10820", "355.7"},
    {"HEB 600", "270.0", "171000", "13530", "667.2"}};

  TEST(Profile, AreaAndMomentsAreThePublishedOnesToTheirDigits)
  {
    for (const Published &published : i_sections)
      {
        const CrossSection section = profile(published.name);
        EXPECT_TRUE(agrees_with(section.area * 1e4, published.area))
          << published.name << " " << section.area * 1e4;
        EXPECT_TRUE(
          agrees_with(section.second_moment_3 * 1e8, published.strong))
          << published.name << " " << section.second_moment_3 * 1e8;
        EXPECT_TRUE(agrees_with(section.second_moment_2 * 1e8, published.weak))
          << published.name << " " << section.second_moment_2 * 1e8;
      }
  }

  TEST(Profile, TorsionIsTheFormulaOfTheTablesButForItsError)
  {
    // The tables add a term for the circle inscribed at each junction, fitted
    // to measurements (Trahair), to the strips' b t^3 / 3.
    for (const Published &published : i_sections)
      {
        const double ratio = profile(published.name).torsion_constant * 1e8 /
          std::stod(published.torsion);
        EXPECT_LT(ratio, 1.03) << published.name;
        EXPECT_GT(ratio, 0.96) << published.name;
      }
  }

  TEST(Profile, ChannelsAreThePublishedOnes)
  {
    for (const Published &published :
         {Published{"UPE 100", "12.5", "207", "38.2", ""},
          Published{"UPE 200", "29.0", "1909", "187.3", ""},
          Published{"UPE 300", "56.6", "7823", "537.7", ""}})
      {
        const CrossSection section = profile(published.name);
        EXPECT_TRUE(agrees_with(section.area * 1e4, published.area))
          << published.name << " " << section.area * 1e4;
        EXPECT_TRUE(
          agrees_with(section.second_moment_3 * 1e8, published.strong))
          << published.name << " " << section.second_moment_3 * 1e8;
        EXPECT_TRUE(agrees_with(section.second_moment_2 * 1e8, published.weak))
          << published.name << " " << section.second_moment_2 * 1e8;
        EXPECT_EQ(section.principal_angle, 0);
      }
  }

  TEST(Profile, AnglesAreThePublishedOnes)
  {
    // EN 10056-1: A, I_u, I_v.
    for (const Published &published :
         {Published{"L 50x50x5", "4.80", "17.4", "4.55", ""},
          Published{"L 80x80x8", "12.3", "115", "29.9", ""},
          Published{"L 100x100x10", "19.2", "280", "73.0", ""}})
      {
        const CrossSection section = profile(published.name);
        const double       u       = std::max(section.second_moment_2,
                                  section.second_moment_3),
                     v             = std::min(section.second_moment_2,
                                  section.second_moment_3);
        EXPECT_TRUE(agrees_with(section.area * 1e4, published.area))
          << published.name << " " << section.area * 1e4;
        EXPECT_TRUE(agrees_with(u * 1e8, published.strong))
          << published.name << " " << u * 1e8;
        EXPECT_TRUE(agrees_with(v * 1e8, published.weak))
          << published.name << " " << v * 1e8;
      }
  }

  TEST(Profile, UnknownNamesAreRefusedWithThoseOfTheSeries)
  {
    expect_parts(input_error_of([] { profile("IPE 210"); }),
                 {"Sections/s/Profile = IPE 210", "IPE 200, IPE 220"});
    expect_parts(input_error_of([] { profile("W 8x10"); }),
                 {"Sections/s/Profile = W 8x10", "IPE, HEA, HEB, UPE, L"});
  }
} // namespace
