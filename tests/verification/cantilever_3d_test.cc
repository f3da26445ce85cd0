#include <verification/clamped_strut_3d.h>
#include <verification/comparison_table.h>

#include <array>
#include <cmath>
#include <vector>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  // Ibrahimbegovic (1997): a cantilever coiled into a helix by a dead moment
  // about z, ten turns at factor 1, and a dead force along z.
  constexpr Beam3D::Stiffness coiled_section = {1e4, 1e4, 1e4, 100, 100, 100};

  TipLoad coiling(const double factor)
  {
    return {SpaceVector({0., 0., 50 * factor}),
            SpaceVector({0., 0., 200 * pi * factor})};
  }
} // namespace

TEST(Cantilever3D, CoiledIntoAHelix)
{
  struct Row
  {
    double                factor;
    std::array<double, 3> u;
  };
  const std::vector<Row> rows = {{0.05, {{-9.288519, 6.285664, 2.750736}}},
                                 {0.10, {{-9.589797, 0.053771, -1.091729}}},
                                 {0.15, {{-9.927931, 2.119615, 0.859053}}},
                                 {0.20, {{-9.884939, 0.008362, -0.598497}}},
                                 {0.30, {{-9.947604, 0.002594, -0.399593}}}};
  ComparisonTable        table("Cantilever coiled into a helix");
  ClampedStrut3D<4>      strut(along_x(10), 16, coiled_section);
  for (const Row &row : rows)
    {
      strut.load_to(coiling(row.factor));
      const char *names[] = {": u_x", ": u_y", ": u_z"};
      for (int d = 0; d < 3; ++d)
        table.row(label("factor", row.factor) + names[d],
                  strut.tip()[d] - (d == 0 ? 10 : 0),
                  row.u[d],
                  1e-6);
    }
}

TEST(Cantilever3D, UncoiledItIsStraightAgain)
{
  // The tip turns by three turns and back.
  ClampedStrut3D<2> strut(along_x(10), 20, coiled_section);
  strut.load_to(coiling(0.3));
  EXPECT_LT(strut.tip()[0], 1) << "has not been coiled";
  strut.load_to(coiling(0));
  EXPECT_LT((strut.tip() - SpaceVector({10., 0., 0.})).norm(), 1e-9);
  EXPECT_LT(rotation_vector(strut.tip_rotation()).norm(), 1e-9);
}

namespace
{
  struct PrincetonRow
  {
    double angle; ///< of the load to the strong direction (deg)
    double load;  ///< N
    double lag, flap, twist;
  };

  const PrincetonRow princeton[] = {
    {0, 13.345, 0.01606514, 0, 0},
    {15, 13.345, 0.01650289, 0.06449631, -2.093707},
    {30, 13.345, 0.01677799, 0.11790226, -3.329195},
    {45, 4.448, 0.00396516, 0.05605519, -0.435960},
    {45, 8.896, 0.00888886, 0.10904157, -1.665025},
    {45, 13.345, 0.01534226, 0.15658782, -3.484691},
    {60, 13.345, 0.01171642, 0.18192119, -2.776602},
    {75, 13.345, 0.00632844, 0.19612471, -1.518696},
    {90, 13.345, 0, 0.20069291, 0}};
} // namespace

TEST(Cantilever3D, PrincetonBeam)
{
  // Dowell & Traybar (1975): 0.508 m of aluminium, 12.377 x 3.2024 mm; strong
  // direction y, weak direction z, dead load at the tip between them.
  const double            shear = 903915;
  const Beam3D::Stiffness section =
    {2841908.7, shear, shear, 3.1033383, 2.4287344, 36.2793635};
  ComparisonTable table("Princeton beam, rod equation by shooting");
  for (const PrincetonRow &row : princeton)
    {
      ClampedStrut3D<4> strut(along_x(0.508), 6, section);
      const double      angle = row.angle * pi / 180;
      const SpaceVector direction({0., std::cos(angle), std::sin(angle)});
      strut.load_to({row.load * direction, {}});
      const SpaceVector axis_2 =
        rotated(strut.tip_rotation(), SpaceVector({0., 1., 0.}));
      const std::string at =
        label("angle", row.angle) + ", " + label("P", row.load);
      // Eight decimals of metres, six of degrees
      table.row(at + ": lag (m)", strut.tip()[1], row.lag, 1e-8);
      table.row(at + ": flap (m)", strut.tip()[2], row.flap, 1e-8);
      table.row(at + ": twist (deg)",
                std::atan2(axis_2[2], axis_2[1]) * 180 / pi,
                row.twist,
                1e-6);
    }
}
