#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/analysis/small_motions/complex_modes.h>

#include <analysis/small_motions/held_rod.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <sstream>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Number = std::complex<double>;

  // An axially vibrating bar of 1 m, fixed at its left end.
  constexpr double rod_EA = 4, rod_mass = 2, rod_beta = 0.03;

  SceneText held_rod(const double beta = rod_beta)
  {
    return testing_support::held_rod(rod_EA, rod_mass, beta, 3);
  }

  std::vector<NaturalMode>
  damped_modes_of(const SceneText   &text,
                  const unsigned int n,
                  const MPI_Comm     communicator = MPI_COMM_SELF)
  {
    const Scene scene = read_scene_from_text(text.str(), "test.prm");
    LatticeRun  run(scene, communicator);
    run.prepare();
    NaturalModes found = natural_modes(run.solver(), run.solution.state, n);
    add_damped_modes(run.solver(), run.solution.state, found);
    return found.modes;
  }

  Number value_of(const NaturalMode::Damped &damped)
  {
    return {damped.growth, damped.angular_frequency};
  }

  /**
   * Relative residual of the characteristic equation of the rod with a
   * connector of dynamic stiffness @p at_end between its end and the ground.
   */
  double relative_residual(const Number                         s,
                           const double                         beta,
                           const std::function<Number(Number)> &at_end)
  {
    const Number stiffness     = rod_EA * (1. + s * beta),
                 wave          = s * std::sqrt(rod_mass / stiffness),
                 rod_stiffness = stiffness * wave / std::tanh(wave);
    return std::abs(rod_stiffness + at_end(s)) / std::abs(stiffness * wave);
  }
} // namespace

TEST(DampedModes, MatchDampedRod)
{
  // s^2 + beta omega^2 s + omega^2 = 0 with omega of the undamped mode.
  const auto modes = damped_modes_of(held_rod(), 4);
  for (unsigned int i = 0; i < 4; ++i)
    {
      const double omega = (i + 0.5) * pi * std::sqrt(rod_EA / rod_mass);
      const double decay = rod_beta * omega * omega / 2;
      ASSERT_TRUE(modes[i].damped) << i;
      EXPECT_NEAR(modes[i].damped->growth, -decay, 1e-7 * omega);
      EXPECT_NEAR(modes[i].damped->angular_frequency,
                  std::sqrt(omega * omega - decay * decay),
                  1e-7 * omega);
      EXPECT_NEAR(modes[i].damped->ratio(), decay / omega, 1e-7);
    }
}

TEST(DampedModes, OverdampedModesDoNotOscillate)
{
  // The third mode has 1.2 times its critical damping.
  const auto modes = damped_modes_of(held_rod(0.22), 3);
  EXPECT_TRUE(modes[0].damped);
  EXPECT_TRUE(modes[1].damped);
  EXPECT_FALSE(modes[2].damped);
}

TEST(DampedModes, UndampedModesAreUnchanged)
{
  const auto modes = damped_modes_of(held_rod(0), 3);
  for (const NaturalMode &mode : modes)
    {
      ASSERT_TRUE(mode.damped);
      EXPECT_NEAR(mode.damped->ratio(), 0, 1e-9);
      EXPECT_NEAR(mode.damped->angular_frequency,
                  mode.angular_frequency(),
                  1e-9 * mode.angular_frequency());
    }
}

TEST(DampedModes, UseDynamicStiffnessOfConnectors)
{
  struct Law
  {
    std::string                   name, entries;
    std::function<Number(Number)> stiffness;
  };
  const auto maxwell = [](const double k, const double tau, const Number s) {
    return k * s * tau / (1. + s * tau);
  };
  const std::vector<Law> laws = {
    {"kelvin-voigt",
     "Spring stiffness = 3 | Damping coefficient = 0.7",
     [](const Number s) { return 3. + 0.7 * s; }},
    {"maxwell",
     "Spring stiffness = 3 | Damping coefficient = 0.6",
     [&](const Number s) { return maxwell(3, 0.2, s); }},
    {"generalized-maxwell",
     "Long-time stiffness = 1 | Stiffnesses = 3, 2 | Relaxation times = 0.1, "
     "0.9",
     [&](const Number s) {
       return 1. + maxwell(3, 0.1, s) + maxwell(2, 0.9, s);
     }}};
  for (const Law &law : laws)
    {
      SceneText scene = held_rod(0.01);
      scene.connector(
        "damper",
        law.name,
        "Between = ground: 1 | Geometry = direction | Direction = "
        "1 0 | " +
          law.entries);
      for (const NaturalMode &mode : damped_modes_of(scene, 3))
        {
          ASSERT_TRUE(mode.damped) << law.name;
          EXPECT_GT(mode.damped->ratio(), 0.01);
          EXPECT_LT(relative_residual(value_of(*mode.damped),
                                      0.01,
                                      law.stiffness),
                    1e-7)
            << law.name << ' ' << mode.angular_frequency();
        }
    }
}

// A dashpot connects two equal rods: symmetric modes stay undamped,
// antisymmetric ones do not.
TEST(DampedModes, DamperSeparatesEqualFrequencies)
{
  SceneText scene;
  scene.frame("0 0; 1 0; 0 1; 1 1", "0 1; 2 3")
    .section({rod_EA, 1e6, 1e6})
    .set("Sections/section 0/Density", rod_mass / rod_EA)
    .support("walls", "0, 2", "clamp")
    .support("guides", "1, 3", "roller x")
    .mesh(4, 3)
    .set("Effects/Rotary inertia", "off")
    .set("Effects/Connector viscosity", "on")
    .connector("tie",
               "dashpot",
               "Between = 1 3 | Geometry = direction | Direction = 1 0 | "
               "Damping coefficient = 0.2")
    .time(1, 0.1, "newmark");
  const double omega   = pi / 2 * std::sqrt(rod_EA / rod_mass);
  unsigned int n_alike = 0;
  for (const NaturalMode &mode : damped_modes_of(scene, 2))
    {
      ASSERT_TRUE(mode.damped);
      const Number s = value_of(*mode.damped);
      if (mode.damped->ratio() < 1e-6)
        {
          ++n_alike;
          EXPECT_NEAR(s.imag(), omega, 1e-6 * omega);
        }
      else
        {
          EXPECT_LT(relative_residual(s,
                                      0,
                                      [](const Number at) { return 0.4 * at; }),
                    1e-6);
        }
    }
  EXPECT_EQ(n_alike, 1u);
}

namespace
{
  /**
   * Reported damped modes of the rod with a dashpot of @p matched times its
   * impedance at the end.
   */
  std::vector<Number> damped_roots_with_dashpot(const double       matched,
                                                const unsigned int n,
                                                const MPI_Comm     communicator)
  {
    std::ostringstream coefficient;
    coefficient.precision(16);
    coefficient << matched * std::sqrt(rod_EA * rod_mass);
    SceneText scene = held_rod(0);
    scene.connector("damper",
                    "dashpot",
                    "Between = ground: 1 | Geometry = direction | Direction = "
                    "1 0 | Damping coefficient = " +
                      coefficient.str());
    std::vector<Number> roots;
    for (const NaturalMode &mode : damped_modes_of(scene, n, communicator))
      if (mode.damped)
        roots.push_back(value_of(*mode.damped));
    std::sort(roots.begin(), roots.end(), [](const Number a, const Number b) {
      return a.imag() < b.imag();
    });
    return roots;
  }
} // namespace

// tanh(s / w) = -1 / matched with w = sqrt(EA / m) / L: all modes decay
// equally. Below the matched dashpot they oscillate as a rod with a free end.
// Above it they oscillate as a fixed rod, and one mode does not oscillate.
TEST(DampedModesOnRanks, FindsStronglyMixedModes)
{
  const double wave = std::sqrt(rod_EA / rod_mass);
  for (const double matched : {0.5, 0.8, 1.25, 2.})
    {
      const auto roots = damped_roots_with_dashpot(matched, 4, MPI_COMM_WORLD);
      const bool is_held = matched > 1;
      ASSERT_GE(roots.size(), is_held ? 3u : 4u) << matched;
      const double decay = wave * std::atanh(is_held ? 1 / matched : matched);
      for (unsigned int i = 0; i < 3; ++i)
        {
          EXPECT_NEAR(roots[i].real(), -decay, 1e-6 * wave) << matched;
          EXPECT_NEAR(roots[i].imag(),
                      (i + (is_held ? 1. : 0.5)) * pi * wave,
                      1e-6 * wave)
            << matched;
        }
    }
}

TEST(DampedModes, FindsModesOfStiffMaxwellElementOnce)
{
  constexpr double stiffness = 40, time = 0.15;
  SceneText        scene = held_rod(0);
  scene.connector("damper",
                  "maxwell",
                  "Between = ground: 1 | Geometry = direction | Direction = "
                  "1 0 | Spring stiffness = 40 | Damping coefficient = 6");
  std::vector<Number> roots;
  for (const NaturalMode &mode : damped_modes_of(scene, 4))
    if (mode.damped)
      {
        const Number s = value_of(*mode.damped);
        for (const Number other : roots)
          EXPECT_GT(std::abs(s - other), 1e-3 * std::abs(s));
        roots.push_back(s);
        EXPECT_LT(relative_residual(s,
                                    0,
                                    [&](const Number at) {
                                      return stiffness * at * time /
                                        (1. + at * time);
                                    }),
                  1e-6);
      }
  EXPECT_GE(roots.size(), 3u);
}

// A dashpot near the impedance of the rod moves modes far from the natural
// ones.
TEST(DampedModes, FindsAllModesUpToLimit)
{
  for (const double coefficient : {0.1, 1.6, 3.4})
    {
      SceneText scene = held_rod(0);
      scene.connector("damper",
                      "dashpot",
                      "Between = ground: 1 | Geometry = direction | Direction "
                      "= 1 0 | Damping coefficient = " +
                        text(coefficient));
      const Scene scene_of_rod = read_scene_from_text(scene.str(), "test.prm");
      LatticeRun  run(scene_of_rod, MPI_COMM_SELF);
      run.prepare();
      NaturalModes found = natural_modes(run.solver(), run.solution.state, 4);
      add_damped_modes(run.solver(), run.solution.state, found);
      ASSERT_TRUE(found.damped_limit) << coefficient;
      // The roots of tanh(s / w) = -w m / c below the limit decay equally.
      const double wave    = std::sqrt(rod_EA / rod_mass),
                   part    = coefficient / std::sqrt(rod_EA * rod_mass),
                   decay   = wave * std::atanh(part > 1 ? 1 / part : part);
      unsigned int n_exact = 0, n_reported = found.further_damped.size();
      while (std::hypot(decay, (n_exact + (part > 1 ? 1. : 0.5)) * pi * wave) <
             *found.damped_limit)
        ++n_exact;
      for (const NaturalMode &mode : found.modes)
        if (mode.damped)
          ++n_reported;
      EXPECT_EQ(n_reported, n_exact) << coefficient;
    }
}

TEST(DampedModesOnRanks, AreTheSame)
{
  const auto alone    = damped_modes_of(held_rod(), 2),
             together = damped_modes_of(held_rod(), 2, MPI_COMM_WORLD);
  for (unsigned int i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(value_of(*alone[i].damped) -
                       value_of(*together[i].damped)),
              1e-8);
}
