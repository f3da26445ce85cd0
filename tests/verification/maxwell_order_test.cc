#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/linear_ode.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A mass of 1 kg between a spring of 400 N/m and a Maxwell element whose
// relaxation time is far shorter, or far longer, than the step.

namespace
{
  constexpr double end = 0.32, long_time_stiffness = 400, start_velocity = 1;

  /** Error of displacement at the end, in units of v / omega. */
  double error(const double      stiffness,
               const double      tau,
               const double      dt,
               const std::string scheme)
  {
    SceneRun run(
      one_mass_scene("Law = standard-linear-solid | Long-time stiffness = " +
                       text(long_time_stiffness) +
                       " | Spring stiffness = " + text(stiffness) +
                       " | Damping coefficient = " + text(stiffness * tau),
                     "Scheme = " + scheme + " | Time step = " + text(dt) +
                       " | End time = " + text(end),
                     mass_and_velocity(1, start_velocity)));
    run.run();
    const OneMass exact{1, long_time_stiffness, 0, {{stiffness, tau}}};
    return std::abs(run.motion(0, 0) - exact.at(end, 0, start_velocity)(0)) *
      std::sqrt(long_time_stiffness) / start_velocity;
  }
} // namespace

TEST(MaxwellOrder, IsTwoForAnyRatioOfStepAndRelaxationTime)
{
  const double    dt = 0.01;
  ComparisonTable table("Order of the motion with a Maxwell element, steps of "
                        "10 and 5 ms");
  for (const char *scheme : {"newmark", "generalized-alpha"})
    for (const double ratio : {1e-3, 1e-2, 0.1, 1., 10., 100., 1000.})
      {
        // C = 8 N s/m, a fifth of critical damping, or a spring of 400 N/m.
        const double tau = dt / ratio, k = ratio < 1 ? 400 : 8 / tau;
        // From an accuracy of a few percent, higher orders are not far.
        const double coarse = error(k, tau, dt, scheme),
                     fine   = error(k, tau, dt / 2, scheme);
        EXPECT_LT(coarse, 0.1) << ratio;
        table.row(label(std::string(scheme) + ", dt / tau", ratio),
                  std::log2(coarse / fine),
                  2,
                  0.15);
      }
}

namespace
{
  /**
   * Largest error of the force of a Maxwell element of 1 N/m without inertia
   * whose ends move by sin(w t), over the largest force.
   */
  double static_error(const double tau, const double dt)
  {
    const double w = 10;
    SceneRun     run(one_mass_scene(
      "Law = maxwell | Spring stiffness = 1 | Damping coefficient = " +
        text(tau),
      "Scheme = static | Time step = " + text(dt) +
        " | End time = " + text(end),
      SceneText().add(
        "Supports/drive",
        "Joints = 0 | Type = prescribed | Displacement x = sin(10 * t)")));
    double       largest_error = 0, largest_force = 0;
    run.run([&] {
      // F' + F / tau = k u'.
      const double t = run.state.time, a = w * tau;
      const double exact = a / (1 + a * a) *
        (std::cos(w * t) + a * std::sin(w * t) - std::exp(-t / tau));
      // The rate in the first step is that of its middle.
      if (run.state.step > 1)
        largest_error =
          std::max(largest_error, std::abs(run.reaction("drive", 0) - exact));
      largest_force = std::max(largest_force, std::abs(exact));
    });
    return largest_error / largest_force;
  }
} // namespace

TEST(MaxwellOrder, IsTwoWithoutInertia)
{
  const double    dt = 0.01;
  ComparisonTable table("Order of the force of a Maxwell element without "
                        "inertia, steps of 10 and 5 ms");
  for (const double ratio : {1e-3, 1e-2, 0.1, 1., 10., 100., 1000.})
    {
      const double coarse = static_error(dt / ratio, dt),
                   fine   = static_error(dt / ratio, dt / 2);
      EXPECT_LT(coarse, 0.02) << ratio;
      // Errors of the second order are those of a rate, which matters to the
      // force of a dashpot alone.
      const double order = std::log2(coarse / fine);
      if (ratio < 100)
        EXPECT_GT(order, 1.9) << ratio;
      else
        table.row(label("dt / tau", ratio), order, 2, 0.1);
    }
}
