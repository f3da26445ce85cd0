#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/pi.h>
#include <verification/vertex.h>

using namespace auxfem::testing_support;

namespace
{
  struct RingRow
  {
    double load;          ///< P R^2 / EI
    double along, across; ///< half the change of the two diameters / R
    double moment;        ///< increment under the load, times R / EI
  };

  // With EA = kGA the quarter ring, whose ends do not turn and of which one is
  // free along the load, keeps the rotations of the inextensible one; the
  // loaded diameter grows by (P/2)(pi R/2) / EA more.
  constexpr double ring_axial_stiffness = 1e4;

  /** The quarter of a ring R = EI = 1 between 0 deg and the load at 90 deg. */
  SceneText quarter_ring(const double direction)
  {
    SceneText scene =
      static_frame("1 0; 0 1", "0 1 " + text(std::sqrt(0.5) - 1));
    scene.section({ring_axial_stiffness, ring_axial_stiffness, 1})
      .prescribe("side", "0", {"free", "0", "0"})
      .prescribe("loaded", "1", {"0", "free", "0"})
      .load("half load", "1", {"0", text(direction / 2) + " * t", "0"})
      .mesh(4, 3);
    return scene;
  }

  void compare_ring(const double                direction,
                    const std::vector<RingRow> &reference)
  {
    SceneRun        run(quarter_ring(direction).time(10, 0.25).str());
    ComparisonTable table(std::string("Ring between two point loads, ") +
                          (direction > 0 ? "pulled" : "pushed") +
                          ", inextensible rod equation by shooting");
    run.run([&] {
      for (const RingRow &row : reference)
        if (std::abs(row.load - run.state.time) < 1e-6)
          {
            const double stretch =
              direction * row.load * pi / 4 / ring_axial_stiffness;
            const std::string at = "P R^2/EI = " + text(row.load) + ": ";
            // The reference has eight decimals.
            const double allowed = 1e-8;
            table.row(at + "loaded diameter",
                      run.motion(1, 1) - stretch,
                      row.along,
                      allowed);
            table.row(at + "other diameter",
                      run.motion(0, 0),
                      row.across,
                      allowed);
            table.row(at + "moment under the load",
                      run.reaction("loaded", auxfem::rotation_z),
                      row.moment,
                      allowed);
          }
    });
  }

  TEST(Ring, Pulled)
  {
    compare_ring(1,
                 {{0.5, 0.03513376, -0.03343514, 0.15541233},
                  {1, 0.06644108, -0.06531957, 0.30355449},
                  {2, 0.11929033, -0.12412203, 0.57965054},
                  {4, 0.19602085, -0.22257758, 1.06372440},
                  {6, 0.24781484, -0.29968809, 1.47840303},
                  {10, 0.31210970, -0.41017314, 2.16997994}});
  }

  TEST(Ring, Pushed)
  {
    compare_ring(-1,
                 {{0.5, -0.03939950, 0.03478995, -0.16296905},
                  {1, -0.08347189, 0.07061015, -0.33360572},
                  {2, -0.18676464, 0.14325626, -0.69693359},
                  {4, -0.44935338, 0.27024552, -1.48299613},
                  {6, -0.74015719, 0.33433334, -2.25206209},
                  {10, -1.19675052, 0.29591739, -3.46813936}});
  }

  // The whole ring of four arcs, held only against rigid motion, moves like its
  // quarter. Small load: q (pi/8 - 1/pi), -q (1/pi - 1/4).
  TEST(Ring, WholeRingUnderASmallLoad)
  {
    const std::string rise = text(std::sqrt(0.5) - 1);
    SceneRun          run(static_frame("1 0; 0 1; -1 0; 0 -1",
                              "0 1 " + rise + "; 1 2 " + rise + "; 2 3 " +
                                rise + "; 3 0 " + rise)
                   .section({ring_axial_stiffness, ring_axial_stiffness, 1})
                   .prescribe("bottom", "3", {"0", "0", "free"})
                   .prescribe("top", "1", {"0", "free", "free"})
                   .load("top", "1", {"0", "1", "0"})
                   .mesh(4, 2)
                   .linear()
                   .str());
    run.run();
    // Discretisation: 4 quartic elements a quarter, error of order h^8
    const double allowed = 1e-8;
    EXPECT_NEAR(run.motion(1, 1),
                2 * (pi / 8 - 1 / pi) + pi / 2 / ring_axial_stiffness,
                allowed);
    EXPECT_NEAR(run.motion(0, 0), 1 / 4. - 1 / pi, allowed);
    EXPECT_NEAR(run.motion(2, 0), 1 / pi - 1 / 4., allowed);
    EXPECT_NEAR(run.reaction("bottom", 1), -1, allowed);
  }

  // Clamped-hinged deep circular arch (DaDeppo & Schmidt 1975): R = 100, 215
  // deg, EI = 1e6, load down at the crown. References: exact rod equation by
  // shooting.
  struct ArchPoint
  {
    double load, u, v, rotation;
  };

  SceneText arch(const double stiffness)
  {
    const double      half = 107.5 * pi / 180, radius = 100;
    const std::string x    = text(radius * std::sin(half));
    const std::string y    = text(radius * std::cos(half));
    const std::string rise = text(radius * (1 - std::cos(half / 2)));
    SceneText         scene =
      static_frame("-" + x + " " + y + "; 0 100; " + x + " " + y,
                   "0 1 " + rise + "; 1 2 " + rise);
    scene.section({stiffness, stiffness, 1e6})
      .support("clamp", "0", "clamp")
      .support("hinge", "2", "pin")
      .mesh(4, 4);
    return scene;
  }

  /** States of the arch when its crown has gone down by these @p deflections. */
  std::vector<ArchPoint> arch_path(const double               stiffness,
                                   const std::vector<double> &deflections)
  {
    SceneRun run(
      arch(stiffness)
        .prescribe("crown", "1", {"free", through(deflections, -1), "free"})
        .time(deflections.size(), 0.125)
        .str());
    std::vector<ArchPoint> points;
    run.run([&] {
      if (run.state.step % 8 == 0)
        points.push_back({-run.reaction("crown", 1),
                          run.motion(1, 0),
                          -run.motion(1, 1),
                          run.motion(1, auxfem::rotation_z)});
    });
    return points;
  }

  TEST(DeepArch, InextensiblePath)
  {
    const std::vector<ArchPoint> reference = {
      {200, 6.756190, 8.612196, 0.016837},
      {400, 21.594672, 25.758551, 0.050924},
      {600, 43.314611, 58.579823, 0.096393},
      {800, 56.349516, 94.594361, 0.107584},
      {897.308997, 61.14147, 113.73206, 0.049886}};
    std::vector<double> deflections;
    for (const ArchPoint &point : reference)
      deflections.push_back(point.v);

    // The effect of stretch is linear in 1/EA: at EA = kGA = 1e8 it is 2e-5 of
    // the load, so its square is negligible after extrapolation.
    const auto      soft  = arch_path(1e8, deflections);
    const auto      stiff = arch_path(2e8, deflections);
    ComparisonTable table("Deep circular arch, inextensible rod equation by "
                          "shooting; extrapolated to EA = kGA = infinity");
    for (unsigned int i = 0; i < reference.size(); ++i)
      {
        const std::string at = "v = " + text(reference[i].v) + ": ";
        // The reference's v and u have five or six decimals; dP/dv < 25.
        table.row(at + "load",
                  2 * stiff.at(i).load - soft.at(i).load,
                  reference[i].load,
                  2e-5);
        table.row(at + "u", 2 * stiff[i].u - soft[i].u, reference[i].u, 1e-5);
        table.row(at + "rotation",
                  2 * stiff[i].rotation - soft[i].rotation,
                  reference[i].rotation,
                  1e-6);
      }
  }

  TEST(DeepArch, LimitLoad)
  {
    const double limit = 113.732, step = 0.05;
    const auto   path =
      arch_path(1e8, {30, 60, 90, limit - step, limit, limit + step});
    const Vertex vertex =
      vertex_of_parabola(limit,
                         step,
                         {path.at(3).load, path.at(4).load, path.at(5).load});
    ComparisonTable table("Deep circular arch, limit load, EA = kGA = 1e8, rod "
                          "equation by shooting");
    // Nine digits are given; the parabola through points 0.05 apart is 3e-6
    // off.
    table.row("limit load", vertex.height, 897.289134, 1e-5);
  }
} // namespace
