#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A shaft bent and twisted at once, against an integration of its own.

namespace
{
  constexpr double shaft_modulus = 200e3, shaft_shear = shaft_modulus / 2.6,
                   shaft_yield = 200, shaft_radius = 1,
                   curvature = 3 * shaft_yield / shaft_modulus, // at the end
    twist                    = 2 * shaft_yield / shaft_shear;

  /** Moment and torque of a shaft. */
  struct Moments
  {
    double bending = 0, torsion = 0;
  };

  /**
   * Prandtl and Reuss: stresses sigma, tau of a fibre move on the yield surface
   * sigma^2 + 3 tau^2 = Y^2 by
   * d sigma = E (d epsilon - sigma dl), d tau = G (d gamma - 3 tau dl),
   * dl = (E sigma d epsilon + 3 G tau d gamma) / (E sigma^2 + 9 G tau^2),
   * here in small steps that are drawn back to the surface.
   */
  Moments exact_moments()
  {
    const int n_radii = 200, n_angles = 200, n_steps = 2000;
    Moments   moments;
    for (int i = 0; i < n_radii; ++i)
      for (int k = 0; k < n_angles / 4; ++k)
        {
          const double r         = shaft_radius * (i + 0.5) / n_radii,
                       angle     = 2 * pi * (k + 0.5) / n_angles,
                       y         = r * std::sin(angle);
          const double d_epsilon = curvature * y / n_steps,
                       d_gamma   = twist * r / n_steps;
          double sigma = 0, tau = 0;
          for (int s = 0; s < n_steps; ++s)
            {
              const double power = shaft_modulus * sigma * d_epsilon +
                3 * shaft_shear * tau * d_gamma;
              const bool flows = sigma * sigma + 3 * tau * tau >=
                  shaft_yield * shaft_yield * (1 - 1e-12) &&
                power > 0;
              const double dl = flows ? power /
                  (shaft_modulus * sigma * sigma + 9 * shaft_shear * tau * tau)
                                      : 0;
              const double s0 = sigma;
              sigma += shaft_modulus * (d_epsilon - s0 * dl);
              tau += shaft_shear * (d_gamma - 3 * tau * dl);
              const double size = std::sqrt(sigma * sigma + 3 * tau * tau);
              if (size > shaft_yield)
                {
                  sigma *= shaft_yield / size;
                  tau *= shaft_yield / size;
                }
            }
          // Four quadrants with the same moments.
          const double dA =
            4 * r * (shaft_radius / n_radii) * (2 * pi / n_angles);
          moments.bending += dA * y * sigma;
          moments.torsion += dA * r * tau;
        }
    return moments;
  }
} // namespace

TEST(YieldingShaft, BentAndTwisted)
{
  SceneRun run(
    SceneText()
      .dimension(3)
      .add("Materials/steel",
           "Law = elastic-plastic | Young's modulus = " + text(shaft_modulus) +
             " | Poisson's ratio = 0.3 | Yield stress = " + text(shaft_yield) +
             " | Shear and torsion = yield | Rings = 16 | Angles = 48")
      .add("Sections/shaft",
           "Material = steel | Shape = circle | Radius = " + text(shaft_radius))
      .frame("0 0 0; 10 0 0", "0 1")
      .support("wall", "0", "clamp")
      .prescribe(
        "hand",
        "1",
        {"free", "free", "free"},
        {text(10 * twist) + " * t", "0", text(10 * curvature) + " * t"})
      .set("Effects/Large rotation", "off")
      .mesh(2, 0)
      .set("Newton/Tolerance", 1e-10)
      .time(1, 0.002, "static"));
  run.run();
  const Moments   exact = exact_moments();
  ComparisonTable table("Shaft bent and twisted beyond yielding");
  table.relative("bending moment",
                 run.reaction("hand", 5),
                 exact.bending,
                 5e-3);
  table.relative("torque", run.reaction("hand", 3), exact.torsion, 5e-3);
}
