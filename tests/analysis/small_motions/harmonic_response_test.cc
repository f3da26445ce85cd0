#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/frequency_response.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Complex = std::complex<double>;

  constexpr Complex imaginary_unit = {0, 1};

  // An axially vibrating bar of 1 m, fixed at its left end: EA u'' = rho A u
  // with EA* = EA (1 + i omega beta).
  constexpr double bar_EA = 4, bar_mass = 2, bar_beta = 0.03, bar_force = 0.01;

  SceneText damped_bar(const unsigned int dimension = 2)
  {
    SceneText scene;
    scene.dimension(dimension)
      .frame("0 0; 1 0; 0.5 0", "0 2; 2 1")
      .set("Analysis", "frequency response");
    if (dimension == 2)
      scene.section({bar_EA, 1, 1});
    else
      scene.space_section({bar_EA, 1, 1, 1, 1, 1});
    const std::string section = dimension == 2 ? "section 0" : "all";
    scene.set("Sections/" + section + "/Density", bar_mass / bar_EA)
      .set("Sections/" + section + "/Stiffness-proportional damping", bar_beta);
    return scene.mesh(4, 4).time(1, 0.1, "newmark");
  }

  SceneText pushed(SceneText scene)
  {
    return scene.support("wall", "0", "clamp")
      .set("Loads/push/Joints", "1")
      .set("Loads/push/Force x", text(bar_force) + " * t");
  }

  Complex bar_stiffness(const double omega)
  {
    return bar_EA * (1. + imaginary_unit * omega * bar_beta);
  }

  /** Wave number (1/m). */
  Complex bar_wave(const double omega)
  {
    return omega * std::sqrt(bar_mass / bar_stiffness(omega));
  }

  /** Force over displacement at the end. */
  Complex bar_resistance(const double omega)
  {
    return bar_stiffness(omega) * bar_wave(omega) / std::tan(bar_wave(omega));
  }

  /** Complex displacement of joint 1 and force of the support of joint 0. */
  std::pair<Complex, Complex>
  vibration_of(const SceneText &text,
               const double     omega,
               const MPI_Comm   communicator = MPI_COMM_SELF)
  {
    const Scene scene = read_scene_from_text(text.str(), "test.prm");
    LatticeRun  run(scene, communicator);
    run.prepare();
    if (scene.time.static_start)
      run.start();
    const HarmonicVibration vibration =
      HarmonicResponse(run.solver(), run.solution.state).at(omega);
    EXPECT_LT(vibration.residual, 1e-8);
    const DofNumbering &numbering = run.model.numbering;
    std::vector<double> values(4, 0.);
    const auto          take = [&](const unsigned int    joint,
                          const HarmonicValues &of,
                          const unsigned int    at) {
      const int i = numbering.joint_unknown(joint, 0);
      if (!numbering.layout().is_owned(i))
        return;
      values[at]     = of.real[i];
      values[at + 1] = of.imaginary[i];
    };
    take(1, vibration.displacement, 0);
    take(0, vibration.reaction, 2);
    values = numbering.layout().sum(values);
    return {{values[0], values[1]}, {values[2], values[3]}};
  }

  void expect_near(const Complex found, const Complex expected)
  {
    EXPECT_NEAR(found.real(), expected.real(), 1e-8 * std::abs(expected));
    EXPECT_NEAR(found.imag(), expected.imag(), 1e-8 * std::abs(expected));
  }
} // namespace

TEST(HarmonicResponse, MatchesDampedBar)
{
  for (const unsigned int dimension : {2, 3})
    // Below, near and beyond the first two natural frequencies.
    for (const double omega : {0.01, 2.2, 6.7, 11.})
      {
        const auto [end, support] =
          vibration_of(pushed(damped_bar(dimension)), omega);
        expect_near(end, bar_force / bar_resistance(omega));
        expect_near(support, -bar_force / std::cos(bar_wave(omega)));
      }
}

TEST(HarmonicResponse, BaseMotionGivesTheMotionRelativeToIt)
{
  // EA* u'' + rho A omega^2 u = rho A a has the solution
  // u = a / omega^2 (1 - cos(k x) - tan(k) sin(k x)).
  constexpr double a = 0.7;
  for (const unsigned int dimension : {2, 3})
    for (const double omega : {0.3, 2.2, 6.7})
      {
        const Complex k = bar_wave(omega), u = a / (omega * omega);
        const auto [end, support] =
          vibration_of(damped_bar(dimension)
                         .support("wall", "0", "clamp")
                         .set("Base motion/Acceleration x", a),
                       omega);
        expect_near(end, u * (1. - 1. / std::cos(k)));
        expect_near(support, u * bar_stiffness(omega) * k * std::tan(k));
      }
}

TEST(HarmonicResponse, UsesComplexStiffnessOfConnectors)
{
  struct Law
  {
    std::string                    name, entries;
    std::function<Complex(double)> stiffness;
  };
  const auto maxwell = [](const double k, const double c, const double omega) {
    return k * imaginary_unit * omega * c / (k + imaginary_unit * omega * c);
  };
  const std::vector<Law> laws = {
    {"spring",
     "Spring stiffness = 3",
     [](const double) -> Complex { return 3; }},
    {"dashpot",
     "Damping coefficient = 0.7",
     [](const double omega) { return imaginary_unit * omega * 0.7; }},
    {"kelvin-voigt",
     "Spring stiffness = 3 | Damping coefficient = 0.7",
     [](const double omega) { return 3. + imaginary_unit * omega * 0.7; }},
    {"maxwell",
     "Spring stiffness = 3 | Damping coefficient = 0.7",
     [&](const double omega) { return maxwell(3, 0.7, omega); }},
    {"standard-linear-solid",
     "Long-time stiffness = 1 | Spring stiffness = 3 | Damping coefficient = "
     "0.7",
     [&](const double omega) { return 1. + maxwell(3, 0.7, omega); }},
    {"generalized-maxwell",
     "Long-time stiffness = 1 | Stiffnesses = 3, 2 | Relaxation times = "
     "0.1, 0.9",
     [&](const double omega) {
       return 1. + maxwell(3, 0.3, omega) + maxwell(2, 1.8, omega);
     }}};
  for (const Law &law : laws)
    for (const double omega : {0.3, 2.2, 9.})
      {
        SceneText scene = pushed(damped_bar());
        scene.connector(
          "damper",
          law.name,
          "Between = ground: 1 | Geometry = direction | Direction "
          "= 1 0 | " +
            law.entries);
        SCOPED_TRACE(law.name);
        expect_near(vibration_of(scene, omega).first,
                    bar_force / (bar_resistance(omega) + law.stiffness(omega)));
      }
}

TEST(HarmonicResponse, SupportMotionExcites)
{
  const double    amplitude = 0.02;
  const SceneText scene =
    damped_bar().prescribe("table", "0", {text(amplitude) + " * t", "0", "0"});
  for (const double omega : {0.5, 3.})
    {
      const auto [end, support] = vibration_of(scene, omega);
      expect_near(end, amplitude / std::cos(bar_wave(omega)));
      expect_near(support,
                  -amplitude * bar_stiffness(omega) * bar_wave(omega) *
                    std::tan(bar_wave(omega)));
    }
}

TEST(HarmonicResponse, StaticLoadsAreNoAmplitudes)
{
  SceneText scene = pushed(damped_bar());
  scene.set("Loads/push/Force x", "0.5 + " + text(bar_force) + " * t")
    .set("Effects/Large rotation", "off")
    .set("Time/Start from", "static equilibrium");
  expect_near(vibration_of(scene, 2.).first, bar_force / bar_resistance(2.));
}

TEST(HarmonicResponseOnRanks, IsTheSame)
{
  const SceneText scene = pushed(damped_bar());
  expect_near(vibration_of(scene, 2.2, MPI_COMM_WORLD).first,
              vibration_of(scene, 2.2).first);
}

TEST(HarmonicResponse, RequiresExcitation)
{
  expect_parts(input_error_of([] {
                 vibration_of(damped_bar().support("wall", "0", "clamp"), 1.);
               }),
               {"no load and no prescribed motion",
                "Frequency response/Time of the loads"});
}
