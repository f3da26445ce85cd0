#include <auxfem/struts/beam_3d_discrete_gradient.h>

#include <gtest/gtest.h>
#include <mathematics/sample_rotation.h>

#include <vector>

#include "beam_3d_on_trial.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double rate_of_step = 0.3; ///< beta / dt

  // Sums of some hundred products of numbers around one.
  constexpr double step_round_off = 1e-12;

  SpaceVector part_of(const double *values)
  {
    return SpaceVector({values[0], values[1], values[2]});
  }

  /** A test beam in a step. */
  template <class Beam>
  struct BeamInStep
  {
    using Nodes  = typename Beam::Nodes;
    using Vector = typename Beam::Vector;

    const Beam &beam;
    Nodes       start, end;

    /** Irregular states, deformed by @p size, rotated and translated. */
    BeamInStep(const Beam &beam, const double size, const unsigned int seed)
      : beam(beam)
      , start(beam.moved(Beam::nodes_of(irregular<Vector>(size, seed)),
                         some_rotation,
                         SpaceVector({1, -2, 0.7})))
      , end(beam.moved(Beam::nodes_of(irregular<Vector>(size, seed + 100)),
                       exponential(SpaceVector({0.2, -0.3, 0.25})) *
                         some_rotation,
                       SpaceVector({1.3, -1.8, 0.5})))
    {}

    Beam3D::StepStart<Beam::order> at_start() const
    {
      return {beam.shape, beam.frames.data(), beam.jacobian, start.data()};
    }

    template <class Damping = NoIncrementDamping>
    Beam3D::StepEnergyOf<double> force(Vector        &result,
                                       const Damping &damping = {}) const
    {
      return Beam3D::mean_force(beam.shape,
                                beam.frames.data(),
                                beam.jacobian,
                                Beam3D::ElasticSection{beam.section},
                                at_start(),
                                end.data(),
                                rate_of_step,
                                result.data(),
                                damping);
    }

    /** Work of @p force on the step. */
    double work(const Vector &force) const
    {
      double sum = 0;
      for (int a = 0; a <= Beam::order; ++a)
        sum += part_of(&force[6 * a]) *
            (end[a].displacement - start[a].displacement) +
          part_of(&force[6 * a + 3]) *
            cayley_rotation(end[a].rotation * conjugate(start[a].rotation));
      return sum;
    }

    /** Moments about the mean positions of the step, and forces. */
    std::array<SpaceVector, 2> resultants(const Vector &force) const
    {
      std::array<SpaceVector, 2> sums;
      for (int a = 0; a <= Beam::order; ++a)
        {
          const SpaceVector f     = part_of(&force[6 * a]),
                            place = beam.positions[a] +
            (start[a].displacement + end[a].displacement) / 2;
          sums[0] +=
            part_of(&force[6 * a + 3]) + dealii::cross_product_3d(place, f);
          sums[1] += f;
        }
      return sums;
    }

    /** Twice the energy of strains equal to @p increments, point by point. */
    double square_of(const std::vector<double> &increments) const
    {
      double sum = 0;
      for (int g = 0; g < Beam::order; ++g)
        sum += 2 * beam.shape.weight[g] * beam.jacobian *
          Beam3D::energy_density(beam.section,
                                 {part_of(&increments[6 * g]),
                                  part_of(&increments[6 * g + 3])});
      return sum;
    }

    double strain_energy(const Nodes &nodes) const
    {
      Vector unused;
      return beam.force(nodes, unused);
    }

    /** Difference of the tangent from central differences. */
    double error_of_tangent() const
    {
      typename Beam::Matrix matrix;
      Beam3D::mean_tangent(beam.shape,
                           beam.frames.data(),
                           beam.jacobian,
                           Beam3D::ElasticSection{beam.section},
                           at_start(),
                           end.data(),
                           rate_of_step,
                           0.5,
                           rate_of_step,
                           matrix.data());
      const double h     = 1e-5;
      double       error = 0;
      for (int j = 0; j < Beam::n; ++j)
        {
          BeamInStep plus = *this, minus = *this;
          plus.end  = Beam::varied(end, j, h);
          minus.end = Beam::varied(end, j, -h);
          Vector f_plus, f_minus;
          plus.force(f_plus);
          minus.force(f_minus);
          for (int i = 0; i < Beam::n; ++i)
            error = std::max(error,
                             std::abs((f_plus[i] - f_minus[i]) / (2 * h) -
                                      matrix[Beam::n * i + j]));
        }
      return error;
    }
  };

  template <class Check>
  void for_each_step_in_space(const Check &check)
  {
    for_each_beam_3d([&](const auto &beam) {
      using Beam = std::decay_t<decltype(beam)>;
      for (unsigned int seed = 1; seed <= 20; ++seed)
        check(BeamInStep<Beam>(beam, 0.4, seed));
    });
  }
} // namespace

TEST(Beam3DBetween, WorkIsTheEnergyChangePlusDissipation)
{
  for_each_step_in_space([](const auto &step) {
    using Beam = std::decay_t<decltype(step.beam)>;
    typename Beam::Vector force;
    const auto            energy = step.force(force);
    EXPECT_GT(energy.dissipation, 0);
    EXPECT_NEAR(energy.strain, step.strain_energy(step.end), step_round_off);
    EXPECT_NEAR(step.work(force),
                energy.strain - step.strain_energy(step.start) +
                  energy.dissipation,
                step_round_off * (1 + energy.strain + energy.dissipation));
  });
}

TEST(Beam3DBetween, NoWorkOnRigidMotionsAboutTheMeanPositions)
{
  for_each_step_in_space([](const auto &step) {
    using Beam = std::decay_t<decltype(step.beam)>;
    typename Beam::Vector force;
    step.force(force);
    for (const SpaceVector &resultant : step.resultants(force))
      EXPECT_LT(resultant.norm(), step_round_off * (1 + largest(force)));
  });
}

TEST(Beam3DBetween, RigidRotationsGiveNoForces)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    const BeamInStep<Beam> step(beam, 0, 1);
    typename Beam::Vector  force;
    const auto             energy = step.force(force);
    EXPECT_NEAR(largest(force), 0, step_round_off);
    EXPECT_NEAR(energy.dissipation, 0, step_round_off);
  });
}

TEST(Beam3DBetween, ZeroStepGivesTheStaticForce)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam = std::decay_t<decltype(beam)>;
    BeamInStep<Beam> step(beam, 0.4, 7);
    step.end = step.start;
    typename Beam::Vector mean, force;
    step.force(mean);
    beam.force(step.start, force);
    for (int i = 0; i < Beam::n; ++i)
      EXPECT_NEAR(mean[i], force[i], step_round_off * (1 + largest(force)));
  });
}

// The tangent omits the derivative of A_a and B_a, which is proportional to
// section forces; the central difference has an error of 1e-9.
TEST(Beam3DBetween, TangentMatchesDifferencesUpToTheSectionForces)
{
  for_each_beam_3d([](const auto &beam) {
    using Beam          = std::decay_t<decltype(beam)>;
    const double coarse = BeamInStep<Beam>(beam, 1e-2, 3).error_of_tangent(),
                 fine   = BeamInStep<Beam>(beam, 1e-3, 3).error_of_tangent();
    EXPECT_LT(coarse, 0.2);
    EXPECT_LT(fine, 0.12 * coarse + 1e-8);
  });
}

TEST(Beam3DBetween, DampedIncrementsNeverCreateEnergyAndConserveMomenta)
{
  for_each_step_in_space([](const auto &step) {
    using Beam              = std::decay_t<decltype(step.beam)>;
    constexpr int       n   = 6 * Beam::order;
    constexpr double    chi = 0.1;
    std::vector<double> last(n), now(n);
    const auto          some = irregular<std::array<double, n>>(0.5, 3);
    std::copy(some.begin(), some.end(), last.begin());
    for (const double dt_before : {0., 0.1, 0.3, 0.7})
      {
        IncrementDamping damping(chi, 0.3, dt_before);
        damping.previous_increments = last.data();
        damping.current_increments  = now.data();
        typename Beam::Vector force;
        const auto            energy  = step.force(force, damping);
        const double          allowed = step_round_off *
          (1 + energy.strain + energy.dissipation + largest(force));
        EXPECT_NEAR(step.work(force),
                    energy.strain - step.strain_energy(step.start) +
                      energy.dissipation + energy.numerical_dissipation,
                    allowed);
        for (const SpaceVector &resultant : step.resultants(force))
          EXPECT_LT(resultant.norm(), allowed);
        const double before = dt_before > 0 ? step.square_of(last) : 0.;
        EXPECT_GE(energy.numerical_dissipation,
                  chi / 4 * (step.square_of(now) - before) - allowed);
      }
  });
}
