#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>
#include <cmath>

#include <support/pi.h>

using namespace auxfem::testing_support;

namespace
{
  constexpr double critical =
    pi * pi / 4; // of a clamped-free column, EI = L = 1

  // As for any strut with EA = kGA, rotations are those of the inextensible
  // column, buckling load included, and the tip moves by P L / EA more.
  constexpr double column_axial_stiffness = 1e4;

  struct ColumnRow
  {
    double angle; ///< of the tip (degrees)
    double load;  ///< P / critical
    double x, y;  ///< position of the tip
  };

  // P/Pcr = (2K/pi)^2, x/L = 2E/K - 1, y/L = 2k/K, k = sin(alpha/2), with the
  // complete elliptic integrals K, E (Timoshenko & Gere, section 2.7).
  const std::vector<ColumnRow> buckled = {
    {20, 1.015396866, 0.9697309074, 0.2194130424},
    {40, 1.063663266, 0.8812035117, 0.4222403401},
    {60, 1.151719620, 0.7410196061, 0.5932076462},
    {90, 1.393203930, 0.4569465810, 0.7627597635},
    {120, 1.884800869, 0.1231599724, 0.8031709900},
    {150, 3.105361984, -0.2222683829, 0.6979073638}};

  /**
   * A column along x with a lateral force that acts only while the load grows
   * to the fourth row; the rows with no lateral force follow one after the
   * other.
   */
  SceneText column(const std::vector<unsigned int> &rows)
  {
    std::vector<double> loads = {buckled[3].load, buckled[3].load};
    for (const unsigned int row : rows)
      loads.push_back(buckled[row].load);
    SceneText scene = static_frame("0 0; 1 0", "0 1");
    scene.section({column_axial_stiffness, column_axial_stiffness, 1})
      .support("clamp", "0", "clamp")
      .load("axial", "1", {through(loads, -critical), "0", "0"})
      .load("lateral", "1", {"0", through({0.5, 0}), "0"})
      .mesh(4, 3)
      .time(loads.size(), 0.125);
    return scene;
  }

  void follow(const std::vector<unsigned int> &rows)
  {
    SceneRun        run(column(rows).str());
    ComparisonTable table("Column after buckling, elliptic integrals");
    run.run([&] {
      if (run.state.step % 8 != 0 || run.state.step <= 16)
        return;
      const ColumnRow  &row = buckled[rows[run.state.step / 8 - 3]];
      const std::string at  = "P/Pcr = " + text(row.load) + ": ";
      // The angle grows by 4 / alpha times a relative change of the load, whose
      // tenth digit is rounded; 1e-9 is left for the displacements.
      const double allowed = 4 * 5e-10 / (row.angle * pi / 180) + 1e-9;
      table.row(at + "tip rotation",
                run.motion(1, auxfem::rotation_z),
                row.angle * pi / 180,
                allowed);
      table.row(at + "x/L",
                1 + run.motion(1, 0) +
                  row.load * critical / column_axial_stiffness,
                row.x,
                allowed);
      table.row(at + "y/L", run.motion(1, 1), row.y, allowed);
    });
  }

  TEST(Column, BuckledBranchDownToTheCriticalLoad)
  {
    follow({2, 1, 0});
  }

  TEST(Column, BuckledBranchFarBeyondTheCriticalLoad)
  {
    follow({3, 4, 5});
  }

  // Below the critical load a lateral force leaves nothing behind, above it
  // does.
  TEST(Column, CriticalLoadSeparatesStraightFromBuckled)
  {
    for (const double load : {0.99, 1.01})
      {
        SceneText scene = static_frame("0 0; 1 0", "0 1");
        SceneRun  run(
          scene.section({column_axial_stiffness, column_axial_stiffness, 1})
            .support("clamp", "0", "clamp")
            .load("axial", "1", {through({load, load}, -critical), "0", "0"})
            .load("lateral", "1", {"0", through({0.1, 0}), "0"})
            .mesh(4, 2)
            .time(2, 0.125)
            .str());
        run.run();
        // alpha^2 / 8 = P/Pcr - 1 near the critical load, up to terms of
        // relative size alpha^2 / 23, here 1e-3
        if (load < 1)
          EXPECT_NEAR(run.motion(1, auxfem::rotation_z), 0, 1e-8);
        else
          EXPECT_NEAR(run.motion(1, auxfem::rotation_z),
                      std::sqrt(8 * (load - 1)),
                      2e-3);
      }
  }
} // namespace
