#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <functional>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Creep, relaxation, ramps and cycles of viscoelastic connectors without
// inertia; closed forms of the standard models (e.g. Findley, Lai & Onaran
// 1976). K = 1000 N/m, C = 50 N s/m (tau = 0.05 s), spring beside it 400 N/m.

namespace
{
  constexpr double k = 1000, c = 50, tau = c / k, k0 = 400;

  const std::string kelvin_voigt_entries =
    "Law = kelvin-voigt | Spring stiffness = 1000 | "
    "Damping coefficient = 50";
  const std::string maxwell = "Law = maxwell | Spring stiffness = 1000 | "
                              "Damping coefficient = 50";
  const std::string standard_linear_solid =
    "Law = standard-linear-solid | Long-time stiffness = 400 | "
    "Spring stiffness = 1000 | Damping coefficient = 50";

  std::string static_steps(const double dt, const double end)
  {
    return "Scheme = static | Time step = " + text(dt) +
      " | End time = " + text(end);
  }

  SceneText force(const std::string &course)
  {
    return SceneText().add("Loads/weight", "Joints = 0 | Force x = " + course);
  }

  SceneText motion(const std::string &course)
  {
    return SceneText().add(
      "Supports/drive",
      "Joints = 0 | Type = prescribed | Displacement x = " + course);
  }

  /** Displacements under 1 N from t = 0 on, after @p n steps of @p dt each. */
  std::vector<double>
  creep(const std::string &law, const double dt, const unsigned int n)
  {
    SceneRun run(one_mass_scene(law, static_steps(dt, n * dt), force("1")));
    std::vector<double> u;
    run.run([&] { u.push_back(run.motion(0, 0)); });
    return u;
  }

  struct ClosedForm
  {
    std::string                   name, law;
    std::function<double(double)> value;
  };

  const std::vector<double> moments = {0.01, 0.05, 0.1, 0.2};
} // namespace

TEST(ConnectorCreep, FollowsTheClosedForms)
{
  const double                  creep_time = tau * (k0 + k) / k0;
  const std::vector<ClosedForm> forms      = {
         {"kelvin-voigt",
          kelvin_voigt_entries,
          [](double t) { return (1 - std::exp(-t / tau)) / k; }},
         {"maxwell", maxwell, [](double t) { return 1 / k + t / c; }},
         {"standard-linear-solid", standard_linear_solid, [=](double t) {
       return (1 - k / (k0 + k) * std::exp(-t / creep_time)) / k0;
     }}};

  const double    dt = 5e-3;
  ComparisonTable errors(
    "Creep under 1 N (m), steps of tau / 10, closed forms"),
    orders("Order of creep, steps of tau / 10 and tau / 20");
  for (const ClosedForm &form : forms)
    {
      const std::vector<double> coarse = creep(form.law, dt, 40),
                                fine   = creep(form.law, dt / 2, 80);
      for (const double t : moments)
        {
          const unsigned int n     = std::lround(t / dt);
          const double       exact = form.value(t);
          // By (dt / tau)^2, in relation to the final displacement.
          errors.relative(label(form.name + ", t", t),
                          coarse[n - 1],
                          exact,
                          0.6 * dt * dt / (tau * tau) * form.value(1) / exact);
          const double error = std::abs(coarse[n - 1] - exact),
                       order =
                         std::log2(error / std::abs(fine[2 * n - 1] - exact));
          // A Maxwell element under a constant force is exact, but for the part
          // of 1e-5 of a step in which the force rises; beside a spring its
          // error is still that of the first step.
          if (form.name == "maxwell")
            EXPECT_LT(error, 1e-5 * dt / c);
          else if (form.name == "standard-linear-solid")
            EXPECT_GT(order, 2);
          else if (t > tau / 2)
            orders.row(label(form.name + ", t", t), order, 2, 0.2);
        }
    }
}

TEST(ConnectorRamp, IsExactForAnyStep)
{
  // The update of internal variables is exact for constant rates, and so is
  // the backward difference. s = 0.1 m/s; dt = tau / 5.
  const double                  s = 0.1, dt = 0.01;
  const std::vector<ClosedForm> forms = {
    {"kelvin-voigt",
     kelvin_voigt_entries,
     [=](double t) { return k * s * t + c * s; }},
    {"maxwell",
     maxwell,
     [=](double t) { return c * s * -std::expm1(-t / tau); }},
    {"standard-linear-solid", standard_linear_solid, [=](double t) {
       return k0 * s * t + c * s * -std::expm1(-t / tau);
     }}};
  ComparisonTable table("Force under a ramp of 0.1 m/s (N), steps of tau / 5, "
                        "closed forms");
  for (const ClosedForm &form : forms)
    {
      SceneRun run(one_mass_scene(form.law,
                                  static_steps(dt, moments.back()),
                                  motion("0.1 * t")));
      auto     moment = moments.begin();
      run.run([&] {
        if (moment == moments.end() || run.state.time < *moment - dt / 2)
          return;
        table.relative(label(form.name + ", t", *moment),
                       run.reaction("drive", 0),
                       form.value(*moment),
                       1e-12);
        ++moment;
      });
      EXPECT_EQ(moment, moments.end());
    }
}

TEST(ConnectorRelaxation, DecaysByTheExactExponential)
{
  // 0.01 m reached in the first step: after it the exact decay of what a ramp
  // over that step leaves, K U (1 - exp(-a)) / a, whatever the step.
  const double    U = 0.01;
  ComparisonTable table("Force at 0.2 s after a ramp to 0.01 m over the first "
                        "step (N), closed forms");
  for (const double dt : {1e-3, 1e-2, 0.1})
    {
      const double a     = dt / tau;
      const double decay = -std::expm1(-a) / a * std::exp(-(0.2 - dt) / tau);
      SceneRun     fluid(
        one_mass_scene(maxwell, static_steps(dt, 0.2), motion("0.01")));
      fluid.run();
      table.relative(label("maxwell, dt", dt),
                     fluid.reaction("drive", 0),
                     k * U * decay,
                     1e-11);
      SceneRun solid(one_mass_scene(standard_linear_solid,
                                    static_steps(dt, 0.2),
                                    motion("0.01")));
      solid.run();
      table.relative(label("standard-linear-solid, dt", dt),
                     solid.reaction("drive", 0),
                     U * (k0 + k * decay),
                     1e-12);
    }
}

TEST(ConnectorCycle, HasTheMaterialsModuliAndLoss)
{
  struct Case
  {
    std::string name, law;
    double      storage, loss;
  };
  // K' and K'' of the closed forms at w tau = 1.
  const std::vector<Case> cases = {
    {"kelvin-voigt", kelvin_voigt_entries, 1000, 1000},
    {"maxwell", maxwell, 500, 500},
    {"standard-linear-solid", standard_linear_solid, 900, 500}};
  const double       U = 0.01, w = 20, period = 2 * std::acos(-1.) / w;
  const unsigned int steps_a_period = 1000, n_periods = 5;
  const double       dt = period / steps_a_period;

  ComparisonTable table("Moduli (N/m) and loss per cycle (J) of connectors at "
                        "20 rad/s, amplitude 0.01 m, closed forms");
  for (const Case &law : cases)
    {
      // With inertia, so that the rate of Kelvin-Voigt is that of the motion.
      SceneRun run(one_mass_scene(
        law.law,
        "Time step = " + text(dt) + " | End time = " + text(n_periods * period),
        mass_and_velocity(1e-9, 0) + motion("0.01 * sin(20 * t)")));
      double   in_phase = 0, out_of_phase = 0, loss_before = 0, work_before = 0;
      run.run([&] {
        const unsigned long last = (n_periods - 1) * steps_a_period;
        if (run.state.step == last)
          {
            loss_before = run.state.energies.dissipated();
            work_before = run.state.energies.external();
          }
        if (run.state.step <= last)
          return;
        const double weight = 2. / steps_a_period * run.reaction("drive", 0);
        in_phase += weight * std::sin(w * run.state.time) / U;
        out_of_phase += weight * std::cos(w * run.state.time) / U;
      });
      // Second order: (w dt)^2 / 12 for the modulus of a Maxwell element,
      // (w dt)^2 / 6 for trapezoidal work, together 1/4. Transients have died
      // to exp(-25) = 1e-11; the inertia of 1e-9 kg is 4e-10 of the force.
      const double allowed = 1.05 * w * w * dt * dt / 4;
      const double loss    = std::acos(-1.) * law.loss * U * U;
      table.relative(law.name + ", K'", in_phase, law.storage, allowed);
      table.relative(law.name + ", K''", out_of_phase, law.loss, allowed);
      table.relative(law.name + ", dissipated",
                     run.state.energies.dissipated() - loss_before,
                     loss,
                     allowed);
      table.relative(law.name + ", work of the drive",
                     run.state.energies.external() - work_before,
                     loss,
                     allowed);
    }
}
