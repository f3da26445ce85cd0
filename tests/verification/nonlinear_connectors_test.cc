#include <auxfem/analysis/small_motions/dynamic_stiffness.h>

#include <support/energy_amount.h>
#include <support/scene_run.h>
#include <verification/one_mass_scene.h>
#include <verification/result_table.h>

#include <cmath>
#include <complex>

#include <support/pi.h>
#include <verification/label.h>
#include <verification/schemes.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// One mass of 1 kg on each of the connector laws that are not linear, against
// closed forms. The extension of the connector is minus the displacement.

namespace
{
  Scheme mean_force_scheme()
  {
    return {"energy-momentum", "Scheme = energy-momentum"};
  }

  Scheme stage_scheme()
  {
    return {"esdirk", "Scheme = esdirk"};
  }

  const std::vector<Scheme> three_schemes = {newmark(),
                                             mean_force_scheme(),
                                             stage_scheme()};

  /** Displacement and velocity. */
  struct MassMotion
  {
    double displacement, velocity;
  };

  /** MassMotion at @p end (s) of the mass pushed off at @p velocity (m/s). */
  MassMotion motion_at_end(const std::string &law,
                           const Scheme      &scheme,
                           const double       velocity,
                           const double       end,
                           const unsigned int n_steps)
  {
    SceneRun run(one_mass_scene(law,
                                scheme.steps(end / n_steps, end),
                                mass_and_velocity(1, velocity)));
    run.run();
    return {run.motion(0, 0), run.velocity(0, 0)};
  }

  /** Oscillator whose stiffness changes from k1 to k2 at the displacement
   * u1. */
  struct BilinearOscillator
  {
    double k1, k2, u1, v0;

    double time_to_kink() const
    {
      return std::asin(w1() * u1 / v0) / w1();
    }

    /** Time from rest position to the turning point (s). */
    double quarter_period() const
    {
      return time_to_kink() + std::atan(v1() * w2() / (k1 * u1)) / w2();
    }

    double amplitude() const
    {
      const double force = k1 * u1;
      return u1 + (std::hypot(force, v1() * w2()) - force) / k2;
    }

  private:
    double w1() const
    {
      return std::sqrt(k1);
    }

    double w2() const
    {
      return std::sqrt(k2);
    }

    /** Speed at the kink. */
    double v1() const
    {
      return std::sqrt(v0 * v0 - k1 * u1 * u1);
    }
  };

  constexpr BilinearOscillator two_stiffnesses{100, 400, 0.05, 1};

  const std::string bilinear_law =
    "Law = bilinear | Spring stiffness = 100 | "
    "Second stiffness = 400 | Kink extension = 0.05";
  const std::string gap_law = "Law = gap | Spring stiffness = 400 | Gap = 0.05";
} // namespace

TEST(NonlinearConnectors, BilinearOscillator)
{
  ComparisonTable table("Bilinear oscillator: amplitude (m), and displacement "
                        "after a period, 400 steps (m); order in the step");
  const double    period = 4 * two_stiffnesses.quarter_period();
  for (const Scheme &scheme : three_schemes)
    {
      const double amplitude =
        -motion_at_end(bilinear_law, scheme, -1, period / 4, 200).displacement;
      table.relative(scheme.name + ", amplitude",
                     amplitude,
                     two_stiffnesses.amplitude(),
                     2e-4);
      const double
        coarse =
          motion_at_end(bilinear_law, scheme, 1, period, 200).displacement,
        fine = motion_at_end(bilinear_law, scheme, 1, period, 400).displacement;
      table.row(scheme.name + ", period", fine, 0, 1e-4);
      // A kink within a step is an error of second order of its own.
      if (scheme.name != "esdirk")
        table.row(scheme.name + ", order",
                  std::log2(std::abs(coarse / fine)),
                  2,
                  0.3);
    }
}

// The mass flies to the stop, stays for half a period and comes back.
TEST(NonlinearConnectors, GapOscillator)
{
  ComparisonTable table("Mass thrown against a gap: displacement after the "
                        "rebound, 1000 steps (m)");
  const double    contact = pi / std::sqrt(400.), end = 0.4;
  for (const Scheme &scheme : three_schemes)
    {
      const MassMotion motion = motion_at_end(gap_law, scheme, 1, end, 1000);
      table.row(scheme.name,
                motion.displacement,
                0.05 - (end - 0.05 - contact),
                2e-4);
      table.row(scheme.name + ", velocity", motion.velocity, -1, 2e-4);
    }
}

// Mean forces do exactly the work of the energy, also across kinks and with
// long steps.
TEST(NonlinearConnectors, EnergyMomentumKeepsTheEnergy)
{
  ComparisonTable table("Energy of undamped oscillators over that at the start "
                        "after 300 steps of a tenth of the period");
  const std::vector<std::pair<std::string, std::string>> elastic = {
    {"bilinear", bilinear_law},
    {"gap", gap_law},
    {"hook", "Law = hook | Spring stiffness = 400 | Slack = 0.05"},
    {"cubic", "Law = cubic | Spring stiffness = 100 | Cubic stiffness = 1e4"},
    {"tabulated",
     "Law = tabulated | Extensions = -1, -0.05, 0, 0.1, 1 | "
     "Forces = -400, -10, 0, 5, 300"},
    {"buckling-link",
     "Law = buckling-link | Spring stiffness = 400 | Buckling load = 10"},
    {"expression", "Law = expression | Force = 100*sinh(3*u)"}};
  for (const auto &[name, law] : elastic)
    {
      // Stops have a spring beside them that brings the mass back.
      SceneRun run(one_mass_scene(
        law,
        mean_force_scheme().steps(0.05, 15),
        mass_and_velocity(1, 1).add(
          "Connectors/spring",
          "Between = ground: 0 | Geometry = direction | Direction = 1 0 | "
          "Law = spring | Spring stiffness = 30")));
      run.run();
      const double energy =
        run.state.energies.kinetic() + run.state.energies.stored();
      table.row(name, energy / 0.5, 1, 1e-9);
    }
}

TEST(NonlinearConnectors, DuffingFrequency)
{
  // omega_0 (1 + 3 k3 A^2 / (8 k)), with the next term of the series.
  ComparisonTable table("Zero crossings of a Duffing oscillator (1/s)");
  const double    k = 100, amplitude = 0.05, v0 = 0.5;
  for (const double k3 : {2000., -2000.})
    {
      const double energy = v0 * v0 / 2;
      // Amplitude by k A^2 / 2 + k3 A^4 / 4 = energy.
      const double a2    = (-k + std::sqrt(k * k + 4 * k3 * energy)) / k3;
      const double x     = k3 * a2 / k;
      const double omega = std::sqrt(k) * (1 + 3. / 8 * x - 21. / 256 * x * x);
      const std::string law =
        "Law = cubic | Spring stiffness = 100 | Cubic stiffness = " + text(k3);
      const double     period = 2 * pi / omega;
      const MassMotion motion =
        motion_at_end(law, newmark(), v0, 10 * period, 10 * 2000);
      // Shift of phase over ten periods.
      const double measured =
        omega * (1 + motion.displacement / (v0 * 10 * period));
      table.relative(label("k3", k3), measured, omega, 3e-5);
      EXPECT_NEAR(std::sqrt(a2), amplitude, 0.01);
    }
}

// The velocity v^(1 - a) falls linearly and is zero from m v0^(1-a) / ((1-a) C)
// on.
TEST(NonlinearConnectors, PowerLawDamperStopsTheMass)
{
  ComparisonTable table("Mass on a power-law damper: velocity half-way (m/s), "
                        "and where it stops (m)");
  for (const double a : {0.3, 0.5})
    {
      constexpr double  c = 2, v0 = 1;
      const double      stop = std::pow(v0, 1 - a) / ((1 - a) * c);
      const std::string law  = "Law = power-law-dashpot | Force at unit rate = "
                               "2 | Smoothing rate = 1e-5 | Exponent = " +
        text(a);
      for (const Scheme &scheme : three_schemes)
        {
          const std::string name = label(scheme.name + ", exponent", a);
          table.row(name + ", half-way",
                    motion_at_end(law, scheme, v0, stop / 2, 200).velocity,
                    std::pow(0.5, 1 / (1 - a)),
                    1e-4);
          const MassMotion at_end =
            motion_at_end(law, scheme, v0, 2 * stop, 800);
          table.row(name + ", stopped", at_end.velocity, 0, 1e-3);
          // Integral of (1 - t / stop)^(1 / (1 - a)).
          table.row(name + ", place",
                    at_end.displacement,
                    stop * (1 - a) / (2 - a),
                    2e-4);
        }
    }
}

TEST(NonlinearConnectors, LossOfAPowerLawDamper)
{
  ComparisonTable table("Loss of a power-law damper in five cycles over 2 "
                        "sqrt(pi) Gamma(1 + a/2) / Gamma(3/2 + a/2) C w^a "
                        "A^(a+1)");
  const double    w = 10, amplitude = 0.02, end = 5 * 2 * pi / w;
  for (const double a : {0.3, 1., 2.})
    {
      SceneRun run(one_mass_scene(
        "Law = power-law-dashpot | Force at unit rate = 30 | Exponent = " +
          text(a),
        "Scheme = static | Time step = " + text(end / 2000) +
          " | End time = " + text(end),
        SceneText().add("Supports/drive",
                        "Joints = 0 | Type = prescribed | Displacement x = "
                        "0.02 * sin(10 * t)")));
      run.run();
      const double exact = 5 * 2 * std::sqrt(pi) * std::tgamma(1 + a / 2) /
        std::tgamma(1.5 + a / 2) * 30 * std::pow(w, a) *
        std::pow(amplitude, a + 1);
      table.row(label("exponent", a),
                run.state.energies.dissipated() / exact,
                1,
                2e-3);
      EXPECT_NEAR(run.balance(), 0, 1e-12);
    }
}

// 4 F0 (A - F0 / k) a cycle.
TEST(NonlinearConnectors, HysteresisOfAFrictionSlider)
{
  ComparisonTable table("Friction slider in two cycles between -A and A: "
                        "loss (J)");
  for (const std::string scheme : {"static", "energy-momentum", "newmark"})
    {
      const bool is_static = scheme == "static";
      SceneText  more;
      more.add("Supports/drive",
               "Joints = 0 | Type = prescribed | Displacement x = "
               "0.02 * sin(2 * pi * t)");
      if (!is_static)
        more.mass("body", "0", 1);
      SceneRun run(one_mass_scene("Law = friction-slider | Spring stiffness = "
                                  "1000 | Slip force = 5",
                                  "Scheme = " + scheme +
                                    " | Time step = 5e-4 | End time = 2.25",
                                  more));
      run.run();
      // Two whole cycles after the first quarter.
      table.relative(scheme,
                     energy_amount(run.state.energies, "link.dissipated"),
                     5 * 0.015 + 2 * 4 * 5 * 0.015,
                     1e-6);
    }
}

// A mass on a slider: friction stops it; v0^2 / 2 = F0 s + F0^2 / (2 k).
TEST(NonlinearConnectors, FrictionSliderStopsAMass)
{
  for (const Scheme &scheme : {newmark(), mean_force_scheme()})
    {
      SceneRun run(one_mass_scene("Law = friction-slider | Spring stiffness = "
                                  "1000 | Slip force = 5",
                                  scheme.steps(1e-4, 0.25),
                                  mass_and_velocity(1, 1)));
      double   furthest = 0;
      run.run([&] { furthest = std::max(furthest, run.motion(0, 0)); });
      EXPECT_NEAR(furthest, (0.5 - 25. / 2000) / 5 + 5. / 1000, 1e-5)
        << scheme.name;
      EXPECT_NEAR(run.balance(), 0, 1e-9) << scheme.name;
    }
}

// The force at rest is that of the extension beyond the free length; the mass
// moves as about another position.
TEST(NonlinearConnectors, PreloadMovesTheMass)
{
  ComparisonTable table("Mass on a preloaded spring, 100 N/m: displacement "
                        "at half a period (m)");
  const double    half = pi / 10;
  for (const std::string entry : {"Preload = 3", "Preload = -2"})
    {
      const double force = entry == "Preload = 3" ? 3 : -2;
      SceneRun     run(
        one_mass_scene("Law = spring | Spring stiffness = 100 | " + entry,
                       newmark().steps(half / 1000, half),
                       mass_and_velocity(1, 0)));
      EXPECT_DOUBLE_EQ(run.connector(0, 0).force, force);
      run.run();
      table.row(entry, run.motion(0, 0), 2 * force / 100, 1e-6);
    }
}

// Two taut connectors hold a mass sideways like a string, 2 P / L.
TEST(NonlinearConnectors, FreeLengthMakesAString)
{
  ComparisonTable   table("Sideways displacement of a mass between two "
                          "prestressed springs under 1 mN (m)");
  const std::string spring =
    "Law = spring | Spring stiffness = 1000 | Geometry = line | ";
  for (const std::string prestress : {"Free length = 0.9", "Preload = 100"})
    {
      SceneText text = SceneText()
                         .frame("0 0; 0 -1; 1 -1", "1 2")
                         .circle("idle", 1e-3, {1, 1})
                         .support("idle", "1, 2", "clamp")
                         .add("Connectors/left",
                              spring + prestress +
                                " | Between = ground: 0 | Ground offset = -1 0")
                         .add("Connectors/right",
                              spring + prestress +
                                " | Between = ground: 0 | Ground offset = 1 0")
                         .mesh(1)
                         .set("Effects/Large rotation", "on")
                         .add("Loads/side", "Joints = 0 | Force y = 0.001");
      text.add("Time", "Scheme = static | Time step = 1 | End time = 1");
      SceneRun run(text);
      run.run();
      table.relative(prestress, run.motion(0, 1), 0.001 / (2 * 100), 1e-6);
    }
}

// A link that breaks loses its energy, and the mass flies on.
TEST(NonlinearConnectors, ConnectorsBreakForGood)
{
  ComparisonTable table("Mass on a spring that breaks at 3 N: energies (J) and "
                        "velocity (m/s)");
  for (const std::string limit :
       {"Failure force = 3", "Failure extension = 0.03"})
    for (const Scheme &scheme : {newmark(), mean_force_scheme()})
      {
        // Against the extension, as that is minus the displacement.
        SceneRun run(
          one_mass_scene("Law = spring | Spring stiffness = 100 | " + limit,
                         scheme.steps(1e-4, 0.2),
                         mass_and_velocity(1, -1)));
        run.run();
        const std::string name = scheme.name + ", " + limit;
        table.relative(name + ", lost",
                       run.state.energies.dissipated(),
                       9. / 200,
                       0.01);
        table.relative(name + ", velocity",
                       run.velocity(0, 0),
                       -std::sqrt(1 - 9. / 100),
                       5e-4);
        EXPECT_EQ(run.state.energies.stored(), 0) << name;
        EXPECT_EQ(run.connector(0, 0).is_broken, 1) << name;
        EXPECT_EQ(run.connector(0, 0).force, 0) << name;
        EXPECT_NEAR(run.balance(), 0, 1e-9) << name;
      }
}

// About an extension: f'(u) + i w (C + c |f(u)|); friction sticks.
TEST(NonlinearConnectors, SmallMotionsSeeTheStiffnessAtTheExtension)
{
  ComparisonTable table("Stiffness of small motions of 3 rad/s about an "
                        "extension of -0.1 m: real and imaginary part (N/m)");
  struct Case
  {
    std::string          name, law;
    std::complex<double> stiffness;
  };
  const std::vector<Case> cases = {
    {"cubic",
     "Law = cubic | Spring stiffness = 100 | Cubic stiffness = 2000 | "
     "Damping coefficient = 4",
     {100 + 3 * 2000 * 0.01, 3 * 4}},
    {"gap",
     "Law = gap | Spring stiffness = 100 | Gap = 0.04 | Stop damping = 2",
     {100, 3 * 2 * 6}},
    {"hook", "Law = hook | Spring stiffness = 100", {0, 0}},
    {"expression",
     "Law = expression | Force = 500*u^3 + 7*v + v^2",
     {1500 * 0.01, 3 * 7}},
    {"friction-slider",
     "Law = friction-slider | Spring stiffness = 100 | Slip force = 2",
     {100, 0}}};
  for (const Case &one : cases)
    {
      SceneRun run(one_mass_scene(
        one.law,
        "Scheme = static | Time step = 1 | End time = 1",
        SceneText().add("Supports/drive",
                        "Joints = 0 | Type = prescribed | Displacement x = "
                        "0.1 * t")));
      run.run();
      DynamicStiffness stiffness(run.computation.solver(), run.state);
      stiffness.set({0, 3});
      const int i = run.model.numbering.joint_unknown(0, 0);
      Vector    unit(run.model.numbering.layout().n_local(), 0.), none(unit);
      unit[i]           = 1;
      const auto forces = stiffness.forces(unit, none);
      table.row(one.name + ", real",
                forces.first[i],
                one.stiffness.real(),
                1e-8);
      table.row(one.name + ", imaginary",
                forces.second[i],
                one.stiffness.imag(),
                1e-8);
    }
}

// A stiff arm of 1 m on a bilinear hinge of 10 and 2 N m/rad with the kink at
// 0.1 rad.
TEST(NonlinearConnectors, RotationalSpringsTakeTheLaws)
{
  ComparisonTable table("Rotation of an arm by a moment (rad)");
  for (const double moment : {0.5, 1.6})
    {
      SceneText text =
        SceneText()
          .frame("0 0; 1 0", "0 1")
          .circle("arm", 0.1, {1e12, 1})
          .support("wall", "0", "clamp")
          .add("Joints/knee",
               "Joints = 0 | Type = rotational bilinear | "
               "Spring stiffness = 10 | Second stiffness = 2 | "
               "Kink rotation = 0.1 rad")
          .add("Loads/end",
               "Joints = 1 | Moment z = " + testing_support::text(moment))
          .mesh(1)
          .set("Effects/Large rotation", "off");
      text.add("Time", "Scheme = static | Time step = 1 | End time = 1");
      SceneRun run(text);
      run.run();
      const double angle = moment < 1 ? moment / 10 : 0.1 + (moment - 1) / 2;
      table.relative(label("moment", moment),
                     run.motion(1, rotation_z),
                     angle,
                     1e-5);
      EXPECT_NEAR(run.state.energies.strain(),
                  moment < 1 ? moment * angle / 2
                             : 0.05 + (1 + moment) / 2 * (angle - 0.1),
                  1e-5);
    }
}
