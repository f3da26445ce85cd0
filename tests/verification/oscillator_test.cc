#include <support/energy_amount.h>
#include <support/scene_run.h>
#include <verification/linear_ode.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <verification/label.h>
#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// One mass on each of the connector laws, against the exact solution.

namespace
{
  struct LawCase
  {
    std::string name, entries;
    OneMass     exact;
  };

  const std::vector<LawCase> laws = {
    {"spring", "Law = spring | Spring stiffness = 100", {1, 100, 0, {}}},
    {"dashpot", "Law = dashpot | Damping coefficient = 2", {1, 0, 2, {}}},
    {"kelvin-voigt",
     "Law = kelvin-voigt | Spring stiffness = 100 | "
     "Damping coefficient = 2",
     {1, 100, 2, {}}},
    {"maxwell",
     "Law = maxwell | Spring stiffness = 100 | "
     "Damping coefficient = 20",
     {1, 0, 0, {{100, 0.2}}}},
    {"standard-linear-solid",
     "Law = standard-linear-solid | Long-time stiffness = 100 | "
     "Spring stiffness = 50 | Damping coefficient = 5",
     {1, 100, 0, {{50, 0.1}}}},
    {"generalized-maxwell",
     "Law = generalized-maxwell | Long-time stiffness = 40 | "
     "Stiffnesses = 50, 30, 20 | Relaxation times = 0.02, 0.1, 0.5",
     {1, 40, 0, {{50, 0.02}, {30, 0.1}, {20, 0.5}}}}};

  const LawCase &law(const std::string &name)
  {
    for (const LawCase &candidate : laws)
      if (candidate.name == name)
        return candidate;
    throw std::logic_error("There is no law " + name);
  }

  constexpr double end_time = 1;

  /** Distance to the exact motion at the end, in displacement units (w = 10 /
   * s). */
  struct MotionError
  {
    double motion, acceleration;
  };

  MotionError
  error(const LawCase &law, const Scheme &scheme, const unsigned int n_steps)
  {
    SceneRun run(one_mass_scene(law.entries,
                                scheme.steps(end_time / n_steps, end_time),
                                mass_and_velocity(1, 1)));
    run.run();
    const dealii::Vector<double> x = law.exact.at(end_time, 0, 1);
    const double                 w = 10;
    const int                    i = run.model.numbering.joint_unknown(0, 0);
    const double                 a = (*run.state.acceleration)[i];
    return {std::hypot(run.motion(0, 0) - x(0),
                       (run.velocity(0, 0) - x(1)) / w),
            std::abs(a - law.exact.acceleration(x)) / (w * w)};
  }

  /** Starts from rest at the displacement @p u0, into which the connector was brought suddenly. */
  void release(SceneRun &run, const OneMass &exact, const double u0)
  {
    const int i               = run.model.numbering.joint_unknown(0, 0);
    run.state.displacement[i] = u0;
    // The connector's extension is minus the displacement.
    double stiffness = exact.stiffness;
    for (unsigned int e = 0; e < exact.elements.size(); ++e)
      {
        run.state.history[e] = -exact.elements[e].first * u0;
        stiffness += exact.elements[e].first;
      }
    energy_amount(run.state.energies, "stored") = stiffness / 2 * u0 * u0;
    (*run.state.acceleration)[i] = exact.acceleration(exact.at(0, u0, 0));
  }
} // namespace

TEST(OscillatorOrder, EverySchemeIsOfSecondOrderWithEveryLaw)
{
  const std::vector<Scheme> schemes = {newmark(),
                                       hht("-0.1"),
                                       generalized_alpha("0.8"),
                                       generalized_alpha("0.5"),
                                       generalized_alpha("0")};
  ComparisonTable           table(
    "Observed order in dt of one mass pushed off at 1 m/s, error at 1 s "
              "against the exact solution, 200 and 400 steps");
  for (const LawCase &law : laws)
    for (const Scheme &scheme : schemes)
      {
        const MotionError coarse = error(law, scheme, 200),
                          fine   = error(law, scheme, 400);
        // The next term of the error changes the observed order by about w dt
        // = 0.05.
        table.row(law.name + ", " + scheme.name + ", motion",
                  std::log2(coarse.motion / fine.motion),
                  2,
                  0.1);
        table.row(law.name + ", " + scheme.name + ", acceleration",
                  std::log2(coarse.acceleration / fine.acceleration),
                  2,
                  0.1);
      }
}

namespace
{
  struct OscillatorMoment
  {
    double time, displacement;
  };

  /** Runs @p name with Newmark and compares displacements at @p moments. */
  void compare(const std::string                   &name,
               const double                         u0,
               const double                         v0,
               const std::vector<OscillatorMoment> &moments,
               ComparisonTable                     &table)
  {
    const double dt = 1e-4;
    SceneRun     run(one_mass_scene(law(name).entries,
                                newmark().steps(dt, moments.back().time) +
                                  // The stepper does not know of the release.
                                  " | Largest energy error = 1e30",
                                mass_and_velocity(1, v0)));
    if (u0 != 0)
      release(run, law(name).exact, u0);
    auto moment = moments.begin();
    run.run([&] {
      if (moment == moments.end() || run.state.time < moment->time - dt / 2)
        return;
      // Newmark's motion is late by (w dt)^2 / 12 of its time; w < 12.3 / s,
      // amplitude 0.1 m. Twice that, as viscosity has an error of that size.
      const double w = 12.3, amplitude = 0.1;
      table.row(label(name + ", t", moment->time),
                run.motion(0, 0),
                moment->displacement,
                2 * amplitude * w * moment->time * w * w * dt * dt / 12);
      ++moment;
    });
    EXPECT_EQ(moment, moments.end());
  }
} // namespace

TEST(OscillatorMotion, FollowsTheClosedForms)
{
  ComparisonTable table("Displacement of one mass (m), closed forms");
  // exp(-t) (cos wd t + sin wd t / wd) / 10, wd = sqrt(99)
  compare("kelvin-voigt",
          0.1,
          0,
          {{0.1, 0.0568971891}, {0.5, 0.0098550668}, {1, -0.0336851681}},
          table);
  // roots of s^2 + s / tau + k / m and 0
  compare("maxwell",
          0,
          1,
          {{0.1, 0.0859164163},
           {0.25, 0.1020342518},
           {0.5, 0.0224827064},
           {1, 0.0520783555}},
          table);
  // roots of s^3 + s^2 / tau + (k0 + k1) s / m + k0 / (m tau)
  compare("standard-linear-solid",
          0.1,
          0,
          {{0.1, 0.0395385859},
           {0.25, -0.0791780963},
           {0.5, 0.0492246369},
           {1, 0.0122195535},
           {2, -0.0069838016}},
          table);
}

TEST(OscillatorMotion, ForcedAmplitudeIsThatOfTheTransferFunction)
{
  // Standard linear solid, force sin(w t): |u| = 1 / |K'(w) + i K''(w) - w^2|.
  ComparisonTable table(
    "Amplitude of a mass on a standard linear solid under sin(w t) (m)");
  for (const auto &[w, amplitude] :
       std::vector<std::pair<double, double>>{{5, 0.0114519667},
                                              {10, 0.0282842712},
                                              {12, 0.0350351677},
                                              {15, 0.0107199406}})
    {
      // Free motion has died to exp(-1.2 * 16) = 5e-9 before the last period.
      const unsigned int steps_a_period = 400;
      const double       period         = 2 * std::acos(-1.) / w;
      const unsigned int n_periods      = std::ceil(16 / period) + 1;
      const double       dt             = period / steps_a_period;
      SceneRun           run(
        one_mass_scene(law("standard-linear-solid").entries,
                       newmark().steps(dt, n_periods * period),
                       mass_and_velocity(1, 0).add(
                         "Loads/shaker",
                         "Joints = 0 | Force x = sin(" + text(w) + " * t)")));
      double sine = 0, cosine = 0;
      run.run([&, omega = w] {
        if (run.state.step <= (n_periods - 1) * steps_a_period)
          return;
        const double t = run.state.time;
        sine += 2. / steps_a_period * run.motion(0, 0) * std::sin(omega * t);
        cosine += 2. / steps_a_period * run.motion(0, 0) * std::cos(omega * t);
      });
      // The scheme sees inertia and rate w^2 and w off by (w dt)^2 / 6 = 4e-5
      // relatively; near resonance |u| w^2 = 5 times that.
      table.relative(label("w", w),
                     std::hypot(sine, cosine),
                     amplitude,
                     5 * std::pow(w * dt, 2) / 6);
    }
}
