#include <auxfem/struts/beam_2d_discrete_gradient.h>

#include <struts/beam_on_trial.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double dt = 0.7;

  // Sums of some hundred products of numbers around one.
  constexpr double between_round_off = 1e-13;

  template <class Beam>
  Beam2D::StepStart<Beam::order> start_of(const Beam                  &beam,
                                          const typename Beam::Vector &u0)
  {
    return {beam.shape, beam.gauss_frames(), beam.jacobian, u0.data()};
  }

  template <class Beam, class Damping = NoIncrementDamping>
  Beam2D::StepEnergyOf<double> mean_force(const Beam                  &beam,
                                          const typename Beam::Vector &u0,
                                          const typename Beam::Vector &u1,
                                          typename Beam::Vector       &force,
                                          const Damping &damping = {})
  {
    return Beam2D::mean_force<Beam::order, true>(beam.shape,
                                                 beam.jacobian,
                                                 Beam2D::ElasticSection{
                                                   beam.section},
                                                 start_of(beam, u0),
                                                 u1.data(),
                                                 dt,
                                                 force.data(),
                                                 damping);
  }

  /** Strain energy of displacements @p u. */
  template <class Beam>
  double strain_energy(const Beam &beam, const typename Beam::Vector &u)
  {
    typename Beam::Vector force;
    return beam.template force<true, false>(u, u, force).strain;
  }

  /** Displacement increments from @p u0 to @p u1, rotations by Cayley's
   * measure. */
  template <class Vector>
  Vector travel(const Vector &u0, const Vector &u1)
  {
    Vector result;
    for (unsigned int i = 0; i < u0.size(); ++i)
      result[i] = i % 3 == 2 ? cayley_rotation(u1[i] - u0[i]) : u1[i] - u0[i];
    return result;
  }

  template <class Vector>
  double product(const Vector &a, const Vector &b)
  {
    double sum = 0;
    for (unsigned int i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
    return sum;
  }

  template <class Vector>
  Vector sum(const Vector &a, const Vector &b)
  {
    Vector result = a;
    for (unsigned int i = 0; i < a.size(); ++i)
      result[i] += b[i];
    return result;
  }

  /** Calls @p check with beams and irregular pairs of states. */
  template <class Check>
  void for_each_step(const Check &check)
  {
    for_each_beam([&](const auto &beam) {
      using Vector = typename std::decay_t<decltype(beam)>::Vector;
      for (unsigned int seed = 1; seed <= 20; ++seed)
        {
          const Vector u0 = irregular<Vector>(0.9, seed);
          check(beam, u0, sum(u0, irregular<Vector>(0.6, 100 + seed)));
        }
    });
  }
} // namespace

TEST(Beam2DBetween, WorkIsTheEnergyChangePlusDissipation)
{
  for_each_step([](const auto &beam, const auto &u0, const auto &u1) {
    auto       force  = u0;
    const auto energy = mean_force(beam, u0, u1, force);
    EXPECT_GT(energy.dissipation, 0);
    EXPECT_NEAR(energy.strain,
                strain_energy(beam, u1),
                between_round_off * (1 + energy.strain));
    EXPECT_NEAR(product(force, travel(u0, u1)),
                energy.strain - strain_energy(beam, u0) + energy.dissipation,
                between_round_off * (1 + energy.strain + energy.dissipation));
  });
}

TEST(Beam2DBetween, DissipationUsesTheMeanStrainRate)
{
  // Uniform stretch of a straight element: beta EA (delta epsilon)^2 L / dt.
  const BeamOnTrial<2> beam(1.6, 0, 0);
  auto                 u0 = BeamOnTrial<2>::Vector(), u1 = u0, force = u0;
  for (int a = 0; a <= 2; ++a)
    {
      u0[3 * a] = 0.1 * beam.nodes[a][0];
      u1[3 * a] = 0.3 * beam.nodes[a][0];
    }
  const auto energy = mean_force(beam, u0, u1, force);
  EXPECT_NEAR(energy.dissipation, 0.4 * 3 * 0.04 * 1.6 / dt, between_round_off);
  // The mean stretch 0.2 and its rate.
  EXPECT_NEAR(force[3], 3 * 0.2 + 0.4 * 3 * 0.2 / dt, between_round_off);
}

TEST(Beam2DBetween, NoWorkOnRigidMotionsAboutTheMeanPositions)
{
  for_each_step([](const auto &beam, const auto &u0, const auto &u1) {
    auto force = u0;
    mean_force(beam, u0, u1, force);
    double x = 0, y = 0, moment = 0;
    for (int a = 0; a <= beam.order; ++a)
      {
        x += force[3 * a];
        y += force[3 * a + 1];
        moment += force[3 * a + 2] +
          (beam.nodes[a][0] + (u0[3 * a] + u1[3 * a]) / 2) * force[3 * a + 1] -
          (beam.nodes[a][1] + (u0[3 * a + 1] + u1[3 * a + 1]) / 2) *
            force[3 * a];
      }
    const double allowed = between_round_off * (1 + largest(force));
    EXPECT_NEAR(x, 0, allowed);
    EXPECT_NEAR(y, 0, allowed);
    EXPECT_NEAR(moment, 0, allowed);
  });
}

TEST(Beam2DBetween, RigidRotationsGiveNoForces)
{
  for_each_beam([](const auto &beam) {
    using Vector = typename std::decay_t<decltype(beam)>::Vector;
    const Vector rest{};
    Vector       force;
    const auto   energy = mean_force(beam,
                                   beam.moved(rest, 0.4, {{0.3, -0.2}}),
                                   beam.moved(rest, 1.9, {{0.1, 0.5}}),
                                   force);
    EXPECT_NEAR(largest(force), 0, between_round_off);
    EXPECT_NEAR(energy.dissipation, 0, between_round_off);
  });
}

TEST(Beam2DBetween, ZeroStepGivesTheStaticForce)
{
  for_each_beam([](const auto &beam) {
    using Vector   = typename std::decay_t<decltype(beam)>::Vector;
    const Vector u = irregular<Vector>(0.9, 7), v{};
    Vector       force, mean;
    beam.template force<true, false>(u, v, force);
    mean_force(beam, u, u, mean);
    for (int i = 0; i < beam.n; ++i)
      EXPECT_NEAR(mean[i], force[i], between_round_off * (1 + largest(force)));
  });
}

// The tangent omits the derivative of the rotation shapes, which vanishes with
// the rotation increment; the central difference has an error of 1e-10.
TEST(Beam2DBetween, TangentMatchesDifferencesUpToTheRotationIncrement)
{
  for_each_beam([](const auto &beam) {
    using Beam          = std::decay_t<decltype(beam)>;
    using Vector        = typename Beam::Vector;
    const Vector u0     = irregular<Vector>(0.9, 3),
                 change = irregular<Vector>(0.6, 4);
    double error[2];
    for (const unsigned int i : {0, 1})
      {
        Vector u1 = u0;
        for (int k = 0; k < beam.n; ++k)
          // The translations of the step remain large.
          u1[k] += (k % 3 == 2 ? std::pow(0.1, i + 1) : 1) * change[k];
        typename Beam::Matrix matrix;
        Beam2D::mean_tangent<Beam::order, true>(beam.shape,
                                                beam.gauss_frames(),
                                                beam.jacobian,
                                                Beam2D::ElasticSection{
                                                  beam.section},
                                                start_of(beam, u0),
                                                u1.data(),
                                                dt,
                                                0.5,
                                                1 / dt,
                                                matrix.data());
        error[i] = 0;
        for (int k = 0; k < beam.n; ++k)
          {
            const double h    = 1e-5;
            Vector       plus = u1, minus = u1, f_plus, f_minus;
            plus[k] += h;
            minus[k] -= h;
            mean_force(beam, u0, plus, f_plus);
            mean_force(beam, u0, minus, f_minus);
            for (int r = 0; r < beam.n; ++r)
              error[i] = std::max(error[i],
                                  std::abs((f_plus[r] - f_minus[r]) / (2 * h) -
                                           matrix[r * beam.n + k]) /
                                    largest(matrix));
          }
      }
    EXPECT_LT(error[0], 0.05);
    EXPECT_LT(error[1], 0.15 * error[0] + 1e-9);
  });
}

TEST(Beam2DBetween, DampedIncrementsNeverCreateEnergy)
{
  for_each_step([](const auto &beam, const auto &u0, const auto &u1) {
    using Beam                 = std::decay_t<decltype(beam)>;
    constexpr int    n         = 3 * Beam::order;
    constexpr double chi       = 0.1;
    const auto       last      = irregular<std::array<double, n>>(0.5, 3);
    auto             now       = last;
    const auto       square_of = [&beam](const auto &increments) {
      double sum = 0;
      for (int i = 0; i < n; ++i)
        sum += beam.shape.weight[i / 3] * beam.jacobian *
          (i % 3 == 0     ? beam.section.axial
                   : i % 3 == 1 ? beam.section.shear
                                : beam.section.bending) *
          increments[i] * increments[i];
      return sum;
    };
    for (const double dt_before : {0., 0.1, dt, 0.9})
      {
        IncrementDamping damping(chi, dt, dt_before);
        damping.previous_increments = last.data();
        damping.current_increments  = now.data();
        auto         force          = u0;
        const auto   energy         = mean_force(beam, u0, u1, force, damping);
        const double allowed =
          between_round_off * (1 + energy.strain + energy.dissipation);
        EXPECT_NEAR(product(force, travel(u0, u1)),
                    energy.strain - strain_energy(beam, u0) +
                      energy.dissipation + energy.numerical_dissipation,
                    allowed);
        const double before = dt_before > 0 ? square_of(last) : 0.;
        EXPECT_GE(energy.numerical_dissipation,
                  chi / 4 * (square_of(now) - before) - allowed);
      }
  });
}
