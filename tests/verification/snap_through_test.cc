#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>
#include <cmath>

#include <verification/vertex.h>

using namespace auxfem::testing_support;

namespace
{
  /**
   * Two struts from (-half_span, 0) and (half_span, 0) to the apex 1, whose
   * @p deflection is prescribed.
   */
  SceneText toggle(const double       half_span,
                   const double       rise,
                   const std::string &deflection)
  {
    SceneText scene = static_frame(text(-half_span) + " 0; 0 " + text(rise) +
                                     "; " + text(half_span) + " 0",
                                   "0 1; 1 2");
    scene.prescribe("apex", "1", {"free", "-(" + deflection + ")", "free"});
    return scene;
  }

  // Von Mises truss: bars without bending are two-node beams with hinges at all
  // ends, whatever their bending stiffness.
  // N = EA (L - L0)/L0, so P = 2 EA (h - v)(1/L - 1/L0).
  double
  truss_load(const double EA, const double b, const double h, const double v)
  {
    return 2 * EA * (h - v) * (1 / std::hypot(b, h - v) - 1 / std::hypot(b, h));
  }

  void
  compare_truss(const double half_span, const double rise, const double step)
  {
    const double    axial_stiffness = 1e6;
    SceneRun        run(toggle(half_span, rise, "t")
                   .section({axial_stiffness, 1e5, 1e6})
                   .hinge("apex", "1")
                   .support("left", "0", "pin")
                   .support("right", "2", "pin")
                   .mesh(1, 0)
                   .time(2.2 * rise, step)
                   .str());
    ComparisonTable table("Von Mises truss, half span " + text(half_span) +
                          ", rise " + text(rise) + ", closed form");
    const double    limit = 2 * axial_stiffness *
      std::pow(1 - std::pow(half_span / std::hypot(half_span, rise), 2. / 3),
               1.5);
    run.run([&] {
      const double v = run.state.time;
      const double P = truss_load(axial_stiffness, half_span, rise, v);
      // Bars are exact: round-off and Newton's tolerance only.
      EXPECT_NEAR(-run.reaction("apex", 1), P, 1e-9 * limit) << "v = " << v;
      EXPECT_NEAR(run.motion(1, 0), 0, 1e-12);
      for (const double shown : {0.1, 0.2, 0.5, 1., 2.2})
        if (std::abs(v - shown) < 1e-6)
          table.row("P at v = " + text(shown),
                    -run.reaction("apex", 1),
                    P,
                    1e-9 * limit);
    });
  }

  TEST(VonMisesTruss, FollowsTheClosedFormThroughTheSnap)
  {
    compare_truss(10, 1, 0.05);
    compare_truss(1, 1, 0.1);
  }

  // Limit point: P = 2 EA [1 - (b/L0)^(2/3)]^(3/2) at L = (L0 b^2)^(1/3).
  TEST(VonMisesTruss, LimitLoad)
  {
    ComparisonTable table("Von Mises truss, limit point, closed form");
    for (const double half_span : {10., 1.})
      {
        const double rise = 1, length = std::hypot(half_span, rise);
        const double at_limit = rise -
          std::sqrt(std::pow(length * half_span * half_span, 2. / 3) -
                    half_span * half_span);
        const double limit =
          2e6 * std::pow(1 - std::pow(half_span / length, 2. / 3), 1.5);
        const double step = 1e-3 * rise;

        SceneRun run(toggle(half_span, rise, text(at_limit - 2 * step) + " + t")
                       .section({1e6, 1e5, 1e6})
                       .hinge("apex", "1")
                       .support("left", "0", "pin")
                       .support("right", "2", "pin")
                       .mesh(1, 0)
                       .time(3 * step, step)
                       .str());
        std::vector<double> loads;
        run.run([&] { loads.push_back(-run.reaction("apex", 1)); });
        const Vertex vertex = vertex_of_parabola(at_limit, step, loads);
        // The parabola misses the curve by its third derivative: (step/rise)^2
        // relative in place, (step/rise)^4 in height, times 10 at most.
        const std::string at = "half span " + text(half_span) + ": ";
        table.relative(at + "load", vertex.height, limit, 1e-9);
        table.relative(at + "deflection", vertex.position, at_limit, 1e-5);
      }
  }

  struct TogglePoint
  {
    double v, load, thrust;
  };

  // Williams' toggle frame (1964): clamped feet, rigid apex; half span 12.943,
  // section 0.753 x 0.243 in, E = 10.3e6 psi. Reference: the exact extensible,
  // shear-rigid rod equation, by shooting.
  constexpr double williams_half_span = 12.943;

  // The limit loads at kGA = 0.31 EA and infinity differ by 1.2e-3 of their
  // value, so at 1000 EA they are about 4e-7 from the shear-rigid frame's;
  // later on the path up to 8e-7.
  constexpr double large_shear_factor    = 1000;
  constexpr double shear_rigid_tolerance = 1e-6;

  SceneText williams(const double       rise,
                     const double       shear_factor,
                     const std::string &deflection)
  {
    const double E = 10.3e6, width = 0.753, height = 0.243,
                 area = width * height;
    SceneText scene   = toggle(williams_half_span, rise, deflection);
    scene
      .section(
        {E * area, shear_factor * E * area, E * area * height * height / 12})
      .support("left", "0", "clamp")
      .support("right", "2", "clamp")
      .mesh(4, 3);
    return scene;
  }

  void compare_williams(const double                    rise,
                        const std::vector<TogglePoint> &reference)
  {
    SceneRun run(williams(rise, large_shear_factor, "t").time(0.7, 0.05).str());
    ComparisonTable table("Williams' toggle frame, rise " + text(rise) +
                          " in, rod equation by shooting");
    run.run([&] {
      for (const TogglePoint &point : reference)
        if (std::abs(point.v - run.state.time) < 1e-6)
          {
            const std::string at = " at v = " + text(point.v);
            table.relative("load" + at,
                           -run.reaction("apex", 1),
                           point.load,
                           shear_rigid_tolerance);
            if (point.thrust != 0)
              table.row("thrust" + at,
                        run.reaction("left", 0),
                        point.thrust,
                        1e-3); // three decimals are given
          }
    });
  }

  TEST(WilliamsToggle, HighFrameSnaps)
  {
    compare_williams(0.386,
                     {{0.1, 25.203369, 365.106},
                      {0.2, 33.498999, 589.649},
                      {0.3, 32.847232, 672.818},
                      {0.4, 31.303208, 621.311},
                      {0.5, 36.096997, 446.350},
                      {0.6, 53.313109, 158.499},
                      {0.7, 88.184363, -235.367}});
  }

  TEST(WilliamsToggle, LowFrameStiffensWithoutLimitPoint)
  {
    compare_williams(0.32,
                     {{0.1, 19.224659, 0},
                      {0.2, 25.831532, 0},
                      {0.3, 27.669354, 0},
                      {0.4, 32.379211, 0},
                      {0.5, 46.743057, 0},
                      {0.6, 76.594418, 0},
                      {0.7, 127.131300, 0}});
  }

  /** Extremum of the load of Williams' frame near the deflection @p near. */
  Vertex williams_limit(const double near, const double shear_factor)
  {
    const double      step       = 2e-3;
    const std::string deflection = text(near - 2 * step) + " * min(1, t) + " +
      text(step) + " * max(0, t - 1)";
    SceneRun run(williams(0.386, shear_factor, deflection).time(4, 0.25).str());
    std::vector<double> loads;
    run.run([&] {
      if (run.state.step % 4 == 0 && run.state.step > 4)
        loads.push_back(-run.reaction("apex", 1));
    });
    return vertex_of_parabola(near, step, loads);
  }

  TEST(WilliamsToggle, LimitPoints)
  {
    // kGA/EA with k = 5/6, nu = 0.33
    const double    shear_flexible = 5. / 6 / 2 / 1.33;
    ComparisonTable table(
      "Williams' toggle frame, limit points, rod equation by shooting");
    const auto compare = [&](const std::string &name,
                             const double       shear_factor,
                             const double       load,
                             const double       v) {
      const Vertex vertex = williams_limit(v, shear_factor);
      // The parabola puts the extremum 1e-5 off at a step of 2e-3, which
      // changes its height by less than the last digit of the reference.
      table.relative(name + ": load",
                     vertex.height,
                     load,
                     shear_factor == large_shear_factor ? shear_rigid_tolerance
                                                        : 5e-9);
      table.row(name + ": v", vertex.position, v, 2e-5);
    };
    compare("maximum, shear-rigid", large_shear_factor, 33.8703852, 0.2321568);
    compare("minimum, shear-rigid", large_shear_factor, 31.2817745, 0.3915942);
    compare("maximum, shear-flexible", shear_flexible, 33.8471946, 0.2319888);
    compare("minimum, shear-flexible", shear_flexible, 31.2454013, 0.3917230);
  }
} // namespace
