#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

#include <verification/vertex.h>

using namespace auxfem::testing_support;

namespace
{
  // Lee's frame (Lee, Manuel & Rossow 1968): column from a hinge at (0, 0) to
  // (0, 120), rigid corner, beam to a hinge at (120, 120); load down at (24,
  // 120). Section 3 x 2 cm, E = 7.2e6 N/cm2, nu = 0.3. References: the exact
  // rod equation, extensible and shear-rigid unless said otherwise, by
  // shooting.
  constexpr double lee_axial_stiffness = 7.2e6 * 6;
  constexpr double bending_stiffness   = 7.2e6 * 2;

  // Shear raises the flexibility of the limit load by 12.2 N with k = 5/6, that
  // is kGA/EA = 0.32; this stiffness leaves 4e-3 N, 2e-7 of the load. Elsewhere
  // on the path it is up to 8e-7.
  constexpr double shear_rigid_frame = 1000;

  SceneText lee_frame(const double shear_factor)
  {
    SceneText scene =
      static_frame("0 0; 0 120; 24 120; 120 120", "0 1; 1 2; 2 3");
    scene
      .section({lee_axial_stiffness,
                shear_factor * lee_axial_stiffness,
                bending_stiffness})
      .support("hinges", "0, 3", "pin")
      .mesh(4, 3);
    return scene;
  }

  struct Point
  {
    double u, v, load;
    double column_angle = 0; ///< at the lower hinge; 0: not known
  };

  TEST(LeeFrame, UnderDisplacementControl)
  {
    const std::vector<Point> reference = {
      {0.514336, 5, 6172.7347, 1.6858954},
      {1.710179, 10, 9635.5082, 1.8141685},
      {5.255179, 20, 13457.9113, 2.0332908},
      {10.334578, 30, 15952.9538, 2.1839395},
      {17.557620, 40, 17807.8246, 2.2572709},
      {22.407958, 45, 18393.3051, 2.2542227}};

    SceneRun        run(lee_frame(shear_rigid_frame)
                   .prescribe("load", "2", {"free", "-t", "free"})
                   .time(45, 2.5)
                   .str());
    ComparisonTable table("Lee's frame, displacement control, rod equation by "
                          "shooting");
    run.run([&] {
      for (const Point &point : reference)
        if (std::abs(point.v - run.state.time) < 1e-6)
          {
            const std::string at = "v = " + text(point.v) + ": ";
            table.relative(at + "load",
                           -run.reaction("load", 1),
                           point.load,
                           1e-6);
            // As the load: shear left in, and six decimals given
            table.row(at + "u", run.motion(2, 0), point.u, 1e-5);
            table.row(at + "column angle",
                      std::acos(-1) / 2 + run.motion(0, auxfem::rotation_z),
                      point.column_angle,
                      5e-7);
          }
    });
  }

  /** The limit load under displacement control near v = 48.735. */
  Vertex limit_point(const double shear_factor)
  {
    const double      near = 48.735, step = 0.2;
    const std::string v = text(near - step) + " * min(1, t / 16) + " +
      text(step) + " * max(0, t - 16)";
    SceneRun            run(lee_frame(shear_factor)
                   .prescribe("load", "2", {"free", "-(" + v + ")", "free"})
                   .time(18, 1)
                   .str());
    std::vector<double> loads;
    run.run([&] {
      if (run.state.step >= 16)
        loads.push_back(-run.reaction("load", 1));
    });
    return vertex_of_parabola(near, step, loads);
  }

  TEST(LeeFrame, LimitLoad)
  {
    ComparisonTable table("Lee's frame, limit load, rod equation by shooting");
    const Vertex    rigid = limit_point(shear_rigid_frame);
    table.relative("shear-rigid: load", rigid.height, 18556.7275, 5e-7);
    // From the parabola through points 0.2 apart
    table.row("shear-rigid: v", rigid.position, 48.73514, 1e-2);
    const Vertex flexible = limit_point(5. / 6 / 2.6);
    table.relative("shear-flexible: load", flexible.height, 18544.527, 1e-7);
  }

  // Beyond the limit load the path turns back in v, so neither force nor
  // displacement control alone follows it. With both displacements of the
  // loaded joint prescribed its support must push straight down with the load.
  TEST(LeeFrame, SnapBackWithBothDisplacementsPrescribed)
  {
    const std::vector<Point> reference = {{0.514336, 5, 6172.7347},
                                          {1.710179, 10, 9635.5082},
                                          {5.255179, 20, 13457.9113},
                                          {10.334578, 30, 15952.9538},
                                          {17.557620, 40, 17807.8246},
                                          {26.88057, 48.73514, 18556.7275},
                                          {61.74746, 61.00298, 11944.107},
                                          {79.24637, 52.76961, 0},
                                          {81.22901, 50.74625, -4380.480},
                                          {90.19567, 58.21682, -9414.4316},
                                          {94.35976, 71.37391, -6858.58},
                                          {90.10679, 85.27905, 0}};
    std::vector<double>      u, v;
    for (const Point &point : reference)
      {
        u.push_back(point.u);
        v.push_back(point.v);
      }

    SceneRun run(lee_frame(shear_rigid_frame)
                   .prescribe("load", "2", {through(u), through(v, -1), "free"})
                   .time(reference.size(), 0.05)
                   .str());
    // 1e-6 of the limit load for the shear left in, and 5e-6 cm of rounding in
    // the reference's position times a stiffness of up to 2000 N/cm
    const double    allowed = 0.03;
    ComparisonTable table(
      "Lee's frame, turning points and zero-load equilibria "
      "beyond the limit load, rod equation by shooting");
    run.run([&] {
      if (run.state.step % 20 != 0)
        return;
      const Point      &point = reference[run.state.step / 20 - 1];
      const std::string at = "(" + text(point.u) + ", " + text(point.v) + "): ";
      table.row(at + "load", -run.reaction("load", 1), point.load, allowed);
      table.row(at + "horizontal force", run.reaction("load", 0), 0, allowed);
    });
  }
} // namespace
