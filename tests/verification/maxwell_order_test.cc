#include <support/scene_run.h>
#include <verification/comparison_table.h>
#include <verification/linear_ode.h>
#include <verification/one_mass_scene.h>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// A mass of 1 kg between a spring of 400 N/m and a Maxwell element whose
// relaxation time is far shorter, or far longer, than the step.

namespace
{
  constexpr double end = 0.32, spring = 400, start_velocity = 1;

  /** Error of displacement at the end, in units of v / omega. */
  double error(const double      stiffness,
               const double      tau,
               const double      dt,
               const std::string scheme)
  {
    SceneRun run(one_mass_scene(
      "    set Law = standard-linear-solid\n    set Long-time stiffness = " +
        text(spring) + "\n    set Spring stiffness = " + text(stiffness) +
        "\n    set Damping coefficient = " + text(stiffness * tau),
      "  set Scheme = " + scheme + "\n  set Time step = " + text(dt) +
        "\n  set End time = " + text(end) + "\n",
      mass_and_velocity(1, start_velocity)));
    run.run();
    const OneMass exact{1, spring, 0, {{stiffness, tau}}};
    return std::abs(run.motion(0, 0) - exact.at(end, 0, start_velocity)(0)) *
      std::sqrt(spring) / start_velocity;
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
