#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/modes.h>

#include <support/scene_text.h>
#include <verification/result_table.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>

using namespace auxfem;
using namespace auxfem::testing_support;

// Columns with L = EI = m = 1, clamped below, under a load P on their top of
// which a part turns with it: complex modes against the exact determinant.

namespace
{
  using Number = std::complex<double>;

  /** EA = kGA and the area: what axial strain and shear leave is some 1e-5. */
  constexpr double unyielding = 1e6;

  struct PressedColumn
  {
    /** The part of the load that turns with the top. */
    double follower = 1;
    /** Stiffness-proportional damping (s). */
    double       damping = 0;
    unsigned int n_axes  = 2;
    unsigned int n_asked = 2;
  };

  Scene scene_of(const PressedColumn &column, const double force)
  {
    const auto down = [force](const double part) {
      return text(-force * part);
    };
    const bool in_plane = column.n_axes == 2;
    SceneText  scene;
    scene.dimension(column.n_axes)
      .set("Analysis", "modes")
      .frame(in_plane ? "0 0; 0 1" : "0 0 0; 0 1 0", "0 1");
    if (in_plane)
      scene.given("all", {unyielding, unyielding, 1}, {1, "", -0.5})
        .load("dead", "1", {"0", down(1 - column.follower), "0"})
        .load("turning", "1", {"0", down(column.follower), "0"});
    else
      scene.space_section({unyielding, unyielding, unyielding, 1, 1, 1})
        .load("dead",
              "1",
              {"0", down(1 - column.follower), "0"},
              {"0", "0", "0"})
        .load("turning",
              "1",
              {"0", down(column.follower), "0"},
              {"0", "0", "0"});
    scene.set("Sections/all/Struts", "all")
      .set("Sections/all/Density", 1 / unyielding)
      .set("Sections/all/Stiffness-proportional damping", column.damping)
      .set("Loads/turning/Direction", "follows the joint")
      .support("clamp", "0", "clamp")
      .mesh(4, 2)
      .set("Modes/About", "static equilibrium")
      .set("Effects/Rotary inertia", "off")
      .set("Newton/Tolerance", "1e-11")
      .time(1, 0.1, "newmark");
    if (column.damping > 0)
      scene.set("Modes/Damped", "true");
    return read_scene_from_text(scene.str(), "test.prm");
  }

  ComplexModes modes_of(const PressedColumn &column, const double force)
  {
    const Scene scene = scene_of(column, force);
    LatticeRun  run(plan_of_modes(scene), MPI_COMM_SELF);
    run.prepare();
    run.start();
    return complex_modes(run.solver(),
                         run.solution.state,
                         column.n_asked,
                         column.damping > 0 ? Damping::all : Damping::none);
  }

  /**
   * Zero where EI (1 + s beta) w'''' + P w'' + m s^2 w = 0 has a solution that
   * is clamped below and has w'' = 0 and EI (1 + s beta) w''' + (1 - a) P w' =
   * 0 on top (Bolotin 1963).
   */
  Number
  determinant(const PressedColumn &column, const double force, const Number s)
  {
    const Number E = 1. + s * column.damping, half = force / E / 2.,
                 root = std::sqrt(half * half - s * s / E), a2 = root - half,
                 b2 = root + half, a = std::sqrt(a2), b = std::sqrt(b2);
    // w = A (cosh ax - cos bx) + B (sinh ax / a - sin bx / b)
    const Number cosh = std::cosh(a), sinh = std::sinh(a), cos = std::cos(b),
                 sin     = std::sin(b);
    const Number slope_A = a * sinh + b * sin, slope_B = cosh - cos,
                 moment_A = a2 * cosh + b2 * cos, moment_B = slope_A,
                 dead    = (1 - column.follower) * 2. * half,
                 shear_A = a * a2 * sinh - b * b2 * sin + dead * slope_A,
                 shear_B = moment_A + dead * slope_B;
    return moment_A * shear_B - moment_B * shear_A;
  }

  /** Solves by secants. */
  template <class T>
  T root_near(const std::function<T(T)> &of, T before, T at)
  {
    T apart_before = of(before);
    for (unsigned int i = 0; i < 50; ++i)
      {
        const T apart_at = of(at);
        if (apart_at == apart_before)
          break;
        const T change = apart_at * (at - before) / (apart_at - apart_before);
        before         = at;
        apart_before   = apart_at;
        at -= change;
        if (std::abs(change) < 1e-13 * std::abs(at))
          break;
      }
    return at;
  }

  Number
  exact_root(const PressedColumn &column, const double force, const Number near)
  {
    return root_near<Number>(
      [&](const Number s) { return determinant(column, force, s); },
      near * (1. + 1e-5),
      near);
  }

  /** (lambda_1 - lambda_2)^2 of the first two modes with lambda = s^2: goes
   * straight through zero where the two meet. */
  double apart(const Number one, const Number other)
  {
    return std::pow(one * one - other * other, 2).real();
  }

  /** The force under which the first two modes meet. */
  double flutter_load(const std::function<double(double)> &apart_under,
                      const double                         near)
  {
    double before = near * 0.99, at = near, apart_before = apart_under(before);
    for (unsigned int i = 0; i < 5; ++i)
      {
        const double apart_at = apart_under(at),
                     change =
                       apart_at * (at - before) / (apart_at - apart_before);
        before       = at;
        apart_before = apart_at;
        at -= change;
        if (std::abs(change) < 1e-5 * at)
          break;
      }
    return at;
  }

  double computed_flutter_load(const PressedColumn &column, const double near)
  {
    return flutter_load(
      [&](const double force) {
        const auto modes = modes_of(column, force).modes;
        // In space of two planes each.
        return apart(modes[0].s, modes[column.n_axes == 2 ? 1 : 2].s);
      },
      near);
  }

  /** The load from which on the determinant, over omega from zero on, has no
   * root before its second one: its first extremum is zero. */
  double
  exact_flutter_load(const PressedColumn &column, double low, double high)
  {
    const auto has_two_roots = [&](const double force) {
      constexpr unsigned int n       = 40000;
      constexpr double       highest = 22;
      const auto             at      = [&](const double omega) {
        return determinant(column, force, {0., omega}).real();
      };
      const double begin = at(1e-3);
      for (unsigned int i = 1; i <= n; ++i)
        if (at(highest * i / n) * begin < 0)
          return true;
      return false;
    };
    while (high - low > 1e-7)
      {
        const double middle                  = (low + high) / 2;
        (has_two_roots(middle) ? low : high) = middle;
      }
    return low;
  }
} // namespace

TEST(Flutter, LoadsOfColumns)
{
  ComparisonTable table(
    "Columns of which the part a of the load turns with the "
    "top: flutter loads, exact determinant");
  EXPECT_NEAR(exact_flutter_load({}, 18, 22), 20.0509, 1e-4);
  for (const double follower : {0.55, 0.75, 1.})
    {
      PressedColumn column;
      column.follower    = follower;
      const double exact = exact_flutter_load(column, 12, 22);
      table.relative("a = " + text(follower),
                     computed_flutter_load(column, 0.99 * exact),
                     exact,
                     3e-5);
    }
  PressedColumn in_space;
  in_space.n_axes  = 3;
  in_space.n_asked = 4;
  table.relative("Beck's, a = 1, in space",
                 computed_flutter_load(in_space, 20),
                 exact_flutter_load({}, 18, 22),
                 3e-5);
}

TEST(Flutter, ModesOfBecksColumn)
{
  ComparisonTable table("Beck's column: modes before and beyond flutter, exact "
                        "determinant");
  PressedColumn   column;
  column.n_asked = 3;
  for (const double force : {10., 20., 22., 40.})
    {
      const ComplexModes found = modes_of(column, force);
      ASSERT_EQ(found.modes.size(), 3u);
      unsigned int n_growing = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const ComplexMode &mode  = found.modes[i];
          const Number       exact = exact_root(column, force, mode.s);
          const std::string  of =
            "P = " + text(force) + ", mode " + std::to_string(i + 1) + ": ";
          table.relative(of + "frequency", mode.s.imag(), exact.imag(), 3e-4);
          if (mode.grows())
            {
              ++n_growing;
              table.relative(of + "growth", mode.s.real(), exact.real(), 3e-4);
            }
          EXPECT_LT(mode.residual, 1e-6);
          EXPECT_TRUE(mode.swings());
        }
      EXPECT_EQ(n_growing, force > 20.06 ? 1u : 0u) << force;
    }
}

// Divergence up to a = 1/2, flutter beyond (Kordas & Zyczkowski 1963).
TEST(Flutter, DivergenceBecomesFlutter)
{
  PressedColumn column;
  column.follower = 0.49;
  const double first =
    std::pow(std::acos(-column.follower / (1 - column.follower)), 2);
  EXPECT_FALSE(modes_of(column, 0.99 * first).modes[0].grows());
  const ComplexModes beyond = modes_of(column, 1.01 * first);
  EXPECT_TRUE(beyond.modes[0].grows());
  EXPECT_FALSE(beyond.modes[0].swings());
  column.follower = 0.51;
  for (const double force : {first, 15.})
    for (const ComplexMode &mode : modes_of(column, force).modes)
      EXPECT_FALSE(mode.grows());
  unsigned int n_growing = 0;
  for (const ComplexMode &mode : modes_of(column, 17).modes)
    if (mode.grows())
      {
        ++n_growing;
        EXPECT_TRUE(mode.swings());
      }
  EXPECT_EQ(n_growing, 1u);
}

// Little damping of the material lets Beck's column flutter at half the load
// (Ziegler 1952; 10.94 by Bolotin & Zhinzher 1969).
TEST(Flutter, DampingDestabilises)
{
  ComparisonTable table("Beck's column with damping in proportion to its "
                        "stiffness: flutter loads, exact determinant");
  for (const double damping : {1e-4, 1e-2})
    {
      PressedColumn column;
      column.damping     = damping;
      const auto largest = [&](const double force) {
        double growth = -std::numeric_limits<double>::infinity();
        Number s      = 0;
        for (const ComplexMode &mode : modes_of(column, force).modes)
          if (mode.s.real() > growth)
            {
              growth = mode.s.real();
              s      = mode.s;
            }
        return s;
      };
      Number       last;
      const double computed = root_near<double>(
        [&](const double force) {
          last = largest(force);
          return last.real();
        },
        10.8,
        11.);
      const double exact = root_near<double>(
        [&](const double force) {
          return exact_root(column, force, last).real();
        },
        10.8,
        11.);
      table.relative("damping of " + text(damping), computed, exact, 1e-4);
      if (damping < 1e-3)
        {
          EXPECT_NEAR(exact, 10.94, 0.01);
        }
    }
}
