#include <auxfem/struts/beam_shape.h>

#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_frame.h>
#include <verification/space_momenta.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// `Time/Damping of energy-momentum`: an oscillator against its characteristic
// equation, and free frames at large rotations.

namespace
{
  constexpr double most_damping = 0.125;

  const SceneText with_most_damping =
    SceneText().set("Time/Damping of energy-momentum", most_damping);

  /** A rod of unit stiffness with a unit mass in effect, pushed along; steps of
   * @p angle, as its circular frequency is one. */
  SceneText oscillating_rod(const double       angle,
                            const unsigned int n_steps,
                            const std::string &large_rotation)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .given("rod", {1, 1, 1}, {1, 0.3, -0.5})
      .mass("body", "1", 0.9)
      .support("wall", "0", "clamp")
      .support("guide", "1", "roller x")
      .add("Initial velocities/push", "Joints = 1 | Velocity x = 0.01")
      .mesh(1)
      .set("Effects/Large rotation", large_rotation)
      .set("Effects/Contact", "off")
      .set("Newton/Tolerance", 1e-14)
      .time(n_steps * angle, angle, "energy-momentum")
      .add(with_most_damping);
  }

  /** The characteristic equation of the scheme for an oscillator that turns by
   * an angle in a step. */
  struct CharacteristicEquation
  {
    explicit CharacteristicEquation(const double angle)
    {
      const double q = angle * angle / 4, chi = most_damping;
      coefficients = {
        {1 + q * (1 + chi), -2 + q * (2 - chi), 1 + q * (1 - chi), q * chi}};
    }

    double at(const double z) const
    {
      double sum = 0;
      for (const double c : coefficients)
        sum = sum * z + c;
      return sum;
    }

    /** The real root between @p low and @p high, where the signs differ. */
    double real_root(double low, double high) const
    {
      for (int i = 0; i < 200; ++i)
        {
          const double middle                       = (low + high) / 2;
          (at(middle) * at(high) <= 0 ? low : high) = middle;
        }
      return (low + high) / 2;
    }

    /** Amplification factor of a step: that of the root near -1 where the angle
     * is large, otherwise of the complex pair. */
    double spectral_radius(const bool is_large) const
    {
      if (is_large)
        return -real_root(-1, -0.5);
      return std::sqrt(-coefficients[3] / coefficients[0] / real_root(-0.5, 0));
    }

    std::array<double, 4> coefficients;
  };

  std::vector<double> displacements_of_rod(const SceneText &scene)
  {
    SceneRun            run(scene);
    std::vector<double> u     = {0};
    double              error = 0;
    run.run([&] {
      u.push_back(run.motion(1, 0));
      error = std::max(error, std::abs(run.balance()) / run.initial_balance);
    });
    EXPECT_LT(error, 1e-12);
    return u;
  }

  /** Amplification factor of a step, from displacements. */
  double amplitude_left(const std::vector<double> &u,
                        const bool                 is_large,
                        const unsigned int         n)
  {
    if (is_large)
      return std::abs(u[n] / u[n - 1]);
    const auto determinant = [&u](const unsigned int i) {
      return u[i] * u[i] - u[i + 1] * u[i - 1];
    };
    return std::sqrt(determinant(n - 1) / determinant(n - 2));
  }

  /** chi / 4 times the square of the increments of strains, which the damping
   * holds (J): a plane frame of one order with equal sections. */
  template <int order>
  double held_energy(const SceneRun &run, const Stiffnesses &section)
  {
    const BeamShape<order>      shape(/*makes_up_for_shear=*/false);
    const std::vector<double>  &increments = run.state.history;
    const std::array<double, 3> stiffness  = {
       {section.axial, section.shear, section.bending}};
    double      sum = 0;
    std::size_t i   = 0;
    for (const DofNumbering::Element &element : run.model.numbering.elements())
      for (int g = 0; g < order; ++g)
        for (const double c : stiffness)
          sum += shape.weight[g] *
            run.model.lattice.length(
              run.model.lattice.struts[element.interval.strut]) /
            2 * c * std::pow(increments[i++], 2);
    // Behind them the length of the step.
    EXPECT_EQ(i + 1, increments.size());
    return most_damping / 4 * sum;
  }
} // namespace

TEST(EnergyMomentumDamping, AnOscillatorHasTheSpectralRadiusOfTheTheory)
{
  ComparisonTable table(
    "Oscillator, energy-momentum with damping 1/8: amplitude left in a step");
  for (const std::string rotation : {"off", "on"})
    for (const double angle : {0.1, 2., 10., 30.})
      {
        const bool                is_large = angle > 20;
        const unsigned int        n        = 20;
        const std::vector<double> u =
          displacements_of_rod(oscillating_rod(angle, n, rotation));
        const CharacteristicEquation equation(angle);
        // From the fourth step on, before which there are no three others.
        for (unsigned int i = 3; i <= n; ++i)
          {
            double sum = 0;
            for (unsigned int k = 0; k < 4; ++k)
              sum += equation.coefficients[k] * u[i - k];
            EXPECT_NEAR(sum / equation.coefficients[0],
                        0,
                        1e-12 * std::abs(u[1]));
          }
        table.row("turned by " + text(angle) + " rad, large rotation " +
                    rotation,
                  amplitude_left(u, is_large, n),
                  equation.spectral_radius(is_large),
                  1e-6);
      }
  // Slow motions keep their amplitude, to the third power of the step.
  EXPECT_GT(CharacteristicEquation(0.1).spectral_radius(false), 1 - 1e-5);
}

TEST(EnergyMomentumDamping, AFreeFrameNeverGainsEnergyAndKeepsMomenta)
{
  // With a modulus and a shear modulus of one they are the stiffnesses.
  const Stiffnesses areas = {2000, 700, 3};
  const SceneText   scene =
    SceneText()
      .frame("0 0; 1 0; 1.5 0.9", "0 1; 1 2")
      .given("rod", areas, {1, 5e-4, -0.5})
      .add("Initial velocities/throw",
           "Joints = 2 | Velocity x = 0.5 | Velocity y = -2")
      .mesh(2)
      .set("Effects/Contact", "off")
      .set("Newton/Tolerance", 1e-13)
      .time(6, 0.02, "energy-momentum")
      .add(with_most_damping);
  SceneRun run(scene);
  double   growth = 0, before = run.initial_balance, error = 0;
  run.run([&] {
    const double now = run.state.energies.total() + held_energy<2>(run, areas);
    growth           = std::max(growth, now - before);
    before           = now;
    error            = std::max(error, std::abs(run.balance()));
    EXPECT_GE(run.state.energies.numerical(), 0);
  });
  ComparisonTable table("Free frame, energy-momentum with damping 1/8");
  table.row("largest growth of the energy with what the damping holds, of it",
            growth / run.initial_balance,
            0,
            1e-11);
  table.row("largest error of the energy balance, of the energy",
            error / run.initial_balance,
            0,
            1e-10);
  EXPECT_GT(run.state.energies.numerical(), 1e-3 * run.initial_balance);
}

TEST(EnergyMomentumDamping, InSpaceMomentaStay)
{
  ComparisonTable table(
    "Thrown frame in space, energy-momentum with damping 1/8, 200 steps");
  for (unsigned int order = 1; order <= 4; ++order)
    {
      SceneRun           run(SceneText()
                     .dimension(3)
                     .frame("0 0 0; 1 0 0.3; 1.5 0.9 0.2", "0 1; 1 2")
                     .add("Sections/rod", rod_of_frame)
                     .add("Initial velocities/throw",
                          "Joints = 2 | Velocity x = 0.5 | Velocity y = -2 | "
                                    "Velocity z = 2")
                     .mesh(order)
                     .set("Effects/Contact", "off")
                     .set("Newton/Tolerance", 1e-13)
                     .time(4, 0.02, "energy-momentum")
                     .add(with_most_damping));
      SpaceMomentumMeter meter(run);
      const SpaceMomenta start  = meter();
      double             energy = 0, linear = 0, angular = 0;
      run.run([&] {
        const SpaceMomenta now = meter();
        energy =
          std::max(energy, std::abs(run.balance()) / run.initial_balance);
        linear =
          std::max(linear,
                   (now.linear - start.linear).norm() / start.linear.norm());
        angular =
          std::max(angular,
                   (now.angular - start.angular).norm() / start.angular.norm());
        EXPECT_GE(run.state.energies.numerical(), 0);
      });
      const std::string of = ", order " + std::to_string(order);
      table.row("largest error of the energy balance" + of, energy, 0, 1e-10);
      table.row("change of momentum" + of, linear, 0, 1e-12);
      table.row("of moment of momentum" + of, angular, 0, 1e-12);
      EXPECT_GT(run.state.energies.numerical(), 1e-3 * run.initial_balance);
    }
}
