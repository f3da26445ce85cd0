#include <support/cell_scene.h>
#include <verification/result_table.h>

#include <cmath>

// Cases of the rigid cell whose answer is known: massless bars, no dashpot, and
// the limits of the standard linear solid.

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double K = 2e4, C = 50, m2 = 0.3, slope = 5e4;

  /** Massless bars under a ramp: the upper part is a mass on the connector. */
  CellCase massless_bars(const double damping)
  {
    CellCase c;
    c.bar_mass = 0;
    c.load     = "5e4*t";
    c.damping  = damping;
    return c;
  }

  /** Y1 of m2 Y1'' + C Y1' + K Y1 = - slope t, from rest. */
  double ramp_response(const double damping, const double t)
  {
    const double w0 = std::sqrt(K / m2), d = damping / (2 * m2),
                 w = std::sqrt(w0 * w0 - d * d);
    // -(slope / K) (t - C / K) and what makes it start at rest
    const double offset = slope / K * damping / K;
    const double a = -offset, b = (slope / K - d * offset) / w;
    return -slope / K * t + offset +
      std::exp(-d * t) * (a * std::cos(w * t) + b * std::sin(w * t));
  }

  void compare_with_ramp_response(CellCase           c,
                                  const std::string &scheme,
                                  const double       allowed,
                                  ComparisonTable   &table)
  {
    c.scheme           = scheme;
    const auto samples = complete_history(c);
    double     error = 0, largest_Y2 = 0;
    for (const CellSample &sample : samples)
      {
        const double exact = ramp_response(c.damping, sample.time);
        error      = std::max(error, std::abs(sample.upper_rise - exact));
        largest_Y2 = std::max(largest_Y2, std::abs(sample.lower_rise));
        EXPECT_NEAR(std::sin(sample.angle),
                    0.5 +
                      (sample.upper_rise - sample.lower_rise) /
                        (2 * c.bar_length),
                    1e-14);
      }
    const std::string name =
      scheme + ", C = " + std::to_string(static_cast<int>(c.damping));
    table.row(name + ": largest error of Y1 / 0.125 m",
              error / 0.125,
              0,
              allowed);
    table.row(name + ": largest Y2 / 0.125 m", largest_Y2 / 0.125, 0, allowed);
  }

  std::vector<CellSample> course(const std::string &law,
                                 const double       stiffness,
                                 const double       damping,
                                 const std::string &long_time = "",
                                 const std::string &scheme    = "newmark")
  {
    CellCase c;
    c.law       = law;
    c.stiffness = stiffness;
    c.damping   = damping;
    c.scheme    = scheme;
    if (!long_time.empty())
      c.connector_lines = "  set Long-time stiffness = " + long_time + "\n";
    return complete_history(c);
  }

  void expect_equal(const std::vector<CellSample> &a,
                    const std::vector<CellSample> &b,
                    const double                   allowed)
  {
    EXPECT_LT(largest_difference(a, b, &CellSample::angle), allowed);
    EXPECT_LT(largest_difference(a, b, &CellSample::transmitted), allowed);
    EXPECT_LT(largest_difference(a, b, &CellSample::lower_rise), 10 * allowed);
  }
} // namespace

// The lower part is pushed by massless bars that nothing else pushes: it stays.
TEST(CellLimits, MasslessBars)
{
  ComparisonTable table("Rigid cell with m1 = 0: one mass on the connector");
  for (const double damping : {0., C})
    {
      const CellCase c = massless_bars(damping);
      compare_with_ramp_response(c, "arkode", 1e-10, table);
      // (w dt)^2 / 12 = 1.4e-5 a radian of phase, over a few radians
      compare_with_ramp_response(c, "newmark", 2e-5, table);
      // four times the step, and with C the growth of the grids' difference
      compare_with_ramp_response(c, "central difference", 4e-4, table);
    }
}

TEST(CellLimits, MasslessBarsComeUpright)
{
  for (const std::string scheme :
       {"arkode", "newmark", "generalized-alpha", "central difference"})
    {
      CellCase c                = massless_bars(C);
      c.law                     = "maxwell";
      c.end                     = 0.2;
      c.n_steps                 = 4000;
      c.scheme                  = scheme;
      const CellHistory history = compute_history(cell_scene(c));
      EXPECT_NE(history.exit_state.find("upright"), std::string::npos)
        << scheme << ": " << history.exit_state;
      ASSERT_GT(history.samples.size(), 100u) << scheme;
      for (const CellSample &sample : history.samples)
        EXPECT_GT(sample.angle, -M_PI / 2);
    }
}

TEST(CellLimits, StandardLinearSolidWithoutItsSpringIsMaxwell)
{
  for (const std::string scheme : {"newmark", "arkode", "central difference"})
    expect_equal(course("standard-linear-solid", K, C, "0", scheme),
                 course("maxwell", K, C, "", scheme),
                 1e-15);
}

TEST(CellLimits, StandardLinearSolidWithALockedDashpotIsASpring)
{
  // The dashpot of 1e9 N s/m beside 20 kN/m creeps by 1e-6 in 50 ms.
  expect_equal(course("standard-linear-solid", K, 1e9, "5e3"),
               course("spring", K + 5e3, 0),
               1e-6);
  expect_equal(course("maxwell", K, 1e9), course("spring", K, 0), 1e-6);
}

TEST(CellLimits, StandardLinearSolidWithAnEmptyDashpotIsItsSpring)
{
  const auto spring = course("spring", 5e3, 0);
  expect_equal(course("standard-linear-solid", K, 0, "5e3"), spring, 1e-15);
  // C Y1' is below 1e-5 * 20 m/s beside 500 N.
  expect_equal(course("standard-linear-solid", K, 1e-5, "5e3"), spring, 1e-6);
  expect_equal(course("standard-linear-solid", K, 0, "5e3", "arkode"),
               course("spring", 5e3, 0, "", "arkode"),
               1e-15);
}

TEST(CellLimits, KelvinVoigtWithoutDashpotIsASpring)
{
  expect_equal(course("kelvin-voigt", K, 0), course("spring", K, 0), 1e-15);
}
