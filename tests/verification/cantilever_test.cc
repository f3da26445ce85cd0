#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>
#include <cmath>

#include <support/pi.h>

using namespace auxfem::testing_support;

namespace
{
  /** A straight cantilever of unit length, turned by @p angle at rest. */
  SceneText cantilever(const Stiffnesses &stiffnesses, const double angle = 0)
  {
    SceneText scene = static_frame("0 0; " + text(std::cos(angle)) + " " +
                                     text(std::sin(angle)),
                                   "0 1");
    scene.section(stiffnesses).support("clamp", "0", "clamp");
    return scene;
  }

  /**
   * Error bound of p-point Gauss quadrature of cos or sin over unit length with
   * n elements, phi being their argument at the end. Under constant moment the
   * rotation is exact and the position its quadrature.
   */
  double
  quadrature_error(const unsigned int p, const unsigned int n, const double phi)
  {
    const double f = std::tgamma(p + 1.), g = std::tgamma(2. * p + 1.);
    return std::pow(phi / n, 2. * p) * std::pow(f, 4) /
      ((2. * p + 1) * std::pow(g, 3));
  }

  // Tip under an end moment M, phi = M L / EI:
  // u/L = sin(phi)/phi - 1, w/L = (1 - cos(phi))/phi.
  TEST(RollUp, TipFollowsTheCircle)
  {
    ComparisonTable table("Cantilever rolled up by an end moment, closed form");
    for (const unsigned int order : {1, 2, 3, 4})
      {
        const unsigned int refinements = 3;
        SceneRun           run(cantilever({100, 50, 2})
                       .load("moment", "1", {"0", "0", "2 * 2 * pi * t"})
                       .mesh(order, refinements)
                       .time(1, 0.25)
                       .str());
        run.run([&] {
          const double      phi = 2 * pi * run.state.time;
          const std::string at =
            "p = " + std::to_string(order) + ", turn " + text(run.state.time);
          const double allowed =
            quadrature_error(order, 1 << refinements, phi) + 1e-9;
          table.row(at + ": u/L",
                    run.motion(1, 0),
                    std::sin(phi) / phi - 1,
                    allowed);
          table.row(at + ": w/L",
                    run.motion(1, 1),
                    (1 - std::cos(phi)) / phi,
                    allowed);
          // Newton's tolerance
          EXPECT_NEAR(run.motion(1, auxfem::rotation_z), phi, 1e-9);
        });
        // Strain energy M^2 L / (2 EI)
        EXPECT_NEAR(run.state.energies.strain(),
                    4 * pi * pi,
                    1e-9 * 4 * pi * pi);
        EXPECT_NEAR(run.reaction("clamp", auxfem::rotation_z), -4 * pi, 1e-9);
      }
  }

  // Simo & Vu-Quoc 1986, example 7.1: an inscribed polygon closes whatever the
  // number of its sides.
  TEST(RollUp, TwoTurnsCloseThePolygon)
  {
    SceneRun run(cantilever({100, 50, 2})
                   .load("moment", "1", {"0", "0", "8 * pi * t"})
                   .mesh(1, 3)
                   .time(1, 0.2)
                   .str());
    run.run();
    // Newton's tolerance
    EXPECT_NEAR(run.motion(1, 0), -1, 1e-9);
    EXPECT_NEAR(run.motion(1, 1), 0, 1e-9);
    EXPECT_NEAR(run.motion(1, auxfem::rotation_z), 4 * pi, 1e-9);
  }

  // Ibrahimbegovic 1995: a circle of circumference 10 opened to a semicircle
  // and to a straight line; here the circle is two half circles.
  TEST(RollUp, CircleUnrolls)
  {
    const double radius = 10 / (2 * pi);
    SceneText    scene =
      static_frame("0 0; 0 " + text(2 * radius) + "; 0 0",
                   "0 1 " + text(-radius) + "; 1 2 " + text(-radius));
    SceneRun run(scene.section({1200, 600, 100})
                   .support("clamp", "0", "clamp")
                   .load("moment", "2", {"0", "0", "-20 * pi * t"})
                   .mesh(3, 3)
                   .time(1, 0.1)
                   .str());

    ComparisonTable table("Circle unrolled by an end moment, closed form");
    // The axis at rest is interpolated as well as the current one, so the bound
    // for 16 cubic elements of a full turn, over the length 10, counts twice;
    // so does a component of a vector that has two.
    const double allowed = 4 * 10 * quadrature_error(3, 16, 2 * pi) + 5e-9;
    run.run([&] {
      if (run.state.step == 5)
        {
          table.row("semicircle: u", run.motion(2, 0), 0, allowed);
          table.row("semicircle: v", run.motion(2, 1), 20 / pi, allowed);
          table.row("semicircle: rotation",
                    run.motion(2, auxfem::rotation_z),
                    -pi,
                    1e-8);
        }
    });
    table.row("straight: u", run.motion(2, 0), 10, allowed);
    table.row("straight: v", run.motion(2, 1), 0, allowed);
    table.row("straight: rotation",
              run.motion(2, auxfem::rotation_z),
              -2 * pi,
              1e-8);
  }

  /** P L^2 / EI, shortening, deflection and rotation of the tip. */
  using ElasticaRow = std::array<double, 4>;

  // Elliptic integrals for the inextensible cantilever under a dead transverse
  // tip force (Mattiasson 1981).
  const std::vector<ElasticaRow> mattiasson = {
    {{0.25, 0.0041178184, 0.0827459154, 0.1242924421}},
    {{0.5, 0.0159189625, 0.1621435757, 0.2445336471}},
    {{1, 0.0564332363, 0.3017207738, 0.4613519497}},
    {{2, 0.1606417208, 0.4934574804, 0.7817498316}},
    {{3, 0.2544201846, 0.6032534411, 0.9860169467}},
    {{4, 0.3289412422, 0.6699641813, 1.121239347}},
    {{5, 0.3876283607, 0.7137915236, 1.215368118}},
    {{6, 0.4345888287, 0.7445711489, 1.283697286}},
    {{7, 0.4729274284, 0.7673690997, 1.334959857}},
    {{8, 0.5048277321, 0.7849823750, 1.374431507}},
    {{9, 0.5318205627, 0.7990555275, 1.405465334}},
    {{10, 0.5549955978, 0.8106090249, 1.430285539}}};

  // With EA = kGA the rotations are those of the inextensible rod, and the tip
  // moves by P L / EA more along the force: r' = t + n / EA and r' x n = t x n.
  constexpr double cantilever_axial_stiffness = 1e4;

  // The reference has ten digits; what eight quartic elements differ from it is
  // its last digit.
  constexpr double elastica_tolerance = 1e-9;

  void compare_with_elastica(const double angle, const double step)
  {
    const std::string force = text(std::sin(angle)) + " * t";
    SceneRun          run(
      cantilever({cantilever_axial_stiffness, cantilever_axial_stiffness, 1},
                 angle)
        .load("force", "1", {force, text(-std::cos(angle)) + " * t", "0"})
        .mesh(4, 3)
        .time(10, step)
        .str());
    ComparisonTable table(
      "Cantilever at " + text(std::round(angle * 180 / pi)) +
      " deg under a dead transverse tip force, elliptic integrals");
    run.run([&] {
      for (const ElasticaRow &row : mattiasson)
        if (std::abs(row[0] - run.state.time) < 1e-6)
          {
            const double      u = run.motion(1, 0), v = run.motion(1, 1);
            const std::string at = "P L^2/EI = " + text(row[0]) + ": ";
            table.row(at + "u/L",
                      -u * std::cos(angle) - v * std::sin(angle),
                      row[1],
                      elastica_tolerance);
            table.row(at + "w/L",
                      u * std::sin(angle) - v * std::cos(angle) -
                        row[0] / cantilever_axial_stiffness,
                      row[2],
                      elastica_tolerance);
            table.row(at + "theta",
                      -run.motion(1, auxfem::rotation_z),
                      row[3],
                      elastica_tolerance);
          }
    });
  }

  TEST(ElasticaCantilever, AllRowsOfMattiasson)
  {
    compare_with_elastica(0, 0.25);
  }

  // The same far from the axes, past the vertical, in larger steps.
  TEST(ElasticaCantilever, IsTheSameInARotatedFrame)
  {
    compare_with_elastica(127 * pi / 180, 1);
  }
} // namespace
