#include <auxfem/struts/rotary_inertia.h>
#include <auxfem/struts/section.h>

#include <gtest/gtest.h>
#include <mathematics/sample_rotation.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;
using dealii::cross_product_3d;

namespace
{
  const SpaceTensor some_axes =
    section_frame(SpaceVector({0.3, 1.1, -0.7}), SpaceVector({0., 0., 1.}));

  const SpaceTensor some_inertia =
    with_principal_values(some_axes, SpaceVector({1.7, 0.9, 1.1}));

  const RotaryInertia::Motion some_motion = {SpaceVector({2., -1., 3.}),
                                             SpaceVector({-4., 0.6, 1.5})};

  /**
   * Tolerance for numbers of about 10 with errors of step^2 and 1e-16 / step.
   */
  constexpr double step = 1e-5, difference_error = 1e-8;

  /** The rotation exp(t a) exp(t b) with its material velocity and acceleration
   * in closed form. */
  struct TwoTurns
  {
    SpaceVector a{{1.3, -0.4, 0.8}}, b{{-0.5, 2.2, 0.3}};

    Quaternion rotation(const double t) const
    {
      return exponential(t * a) * exponential(t * b);
    }

    RotaryInertia::Motion motion(const double t) const
    {
      const SpaceVector first = rotated(conjugate(exponential(t * b)), a);
      return {first + b, -1. * cross_product_3d(b, first)};
    }
  };
} // namespace

TEST(RotaryInertia, TorqueIsTheRateOfTheAngularMomentum)
{
  const TwoTurns turns;
  const auto     momentum = [&](const double t) {
    return rotated(turns.rotation(t), some_inertia * turns.motion(t).velocity);
  };
  for (const double t : {0., 0.7, 3.})
    EXPECT_LT(
      (RotaryInertia::torque(some_inertia, turns.rotation(t), turns.motion(t)) -
       (momentum(t + step) - momentum(t - step)) / (2 * step))
        .norm(),
      difference_error)
      << "t = " << t;
}

TEST(RotaryInertia, PowerOfTheTorqueIsTheRateOfKineticEnergy)
{
  const TwoTurns turns;
  const auto     energy = [&](const double t) {
    return RotaryInertia::kinetic_energy(some_inertia,
                                         turns.motion(t).velocity);
  };
  const double      t = 0.7;
  const SpaceVector angular_velocity =
    rotated(turns.rotation(t), turns.motion(t).velocity);
  EXPECT_NEAR(RotaryInertia::torque(some_inertia,
                                    turns.rotation(t),
                                    turns.motion(t)) *
                angular_velocity,
              (energy(t + step) - energy(t - step)) / (2 * step),
              difference_error);
}

TEST(RotaryInertia, SteadyPrecessionOfASymmetricTopNeedsNoTorque)
{
  // Spin s about the axis of symmetry and precession p about a fixed axis at
  // the angle theta to it: free if J3 (s + p cos) = J1 p cos.
  const double inertia_1 = 0.6, inertia_3 = 1, precession = 3, theta = 0.7;
  const double spin =
    (inertia_1 / inertia_3 - 1) * precession * std::cos(theta);
  SpaceTensor inertia;
  inertia[0][0] = inertia[1][1] = inertia_1;
  inertia[2][2]                 = inertia_3;
  const SpaceVector velocity(
    {0., precession * std::sin(theta), precession * std::cos(theta) + spin});
  // The precession rotates backwards about axis 3 of the body at the spin rate.
  const SpaceVector acceleration =
    -spin * cross_product_3d(SpaceVector({0., 0., 1.}), SpaceVector(velocity));
  EXPECT_LT(RotaryInertia::torque(inertia,
                                  some_rotation,
                                  {velocity, acceleration})
              .norm(),
            1e-14);
}

TEST(RotaryInertia, TangentIsTheDerivativeOfTheTorque)
{
  const auto tangent =
    RotaryInertia::tangent(some_inertia, some_rotation, some_motion);
  for (int j = 0; j < 3; ++j)
    {
      SpaceVector variation;
      variation[j]      = step;
      const auto torque = [&](const int sign, const int which) {
        auto       motion   = some_motion;
        Quaternion rotation = some_rotation;
        if (which == 0)
          rotation = exponential(sign * variation) * rotation;
        else if (which == 1)
          motion.velocity += sign * variation;
        else
          motion.acceleration += sign * variation;
        return RotaryInertia::torque(some_inertia, rotation, motion);
      };
      const SpaceTensor *derivatives[] = {&tangent.by_spin,
                                          &tangent.by_velocity,
                                          &tangent.by_acceleration};
      for (int which = 0; which < 3; ++which)
        {
          const SpaceVector slope =
            (torque(1, which) - torque(-1, which)) / (2 * step);
          for (int i = 0; i < 3; ++i)
            EXPECT_NEAR((*derivatives[which])[i][j], slope[i], difference_error)
              << "kind " << which;
        }
    }
}

TEST(RotaryInertia, SectionInertiaIsPolarAboutTheStrut)
{
  Section section;
  section.density          = 1;
  section.second_moment_2  = 2;
  section.second_moment_3  = 3;
  const auto        values = section.rotary_inertia_per_length();
  const SpaceTensor inertia =
    with_principal_values(some_axes,
                          SpaceVector({values[0], values[1], values[2]}));
  const double expected[] = {5, 2, 3};
  for (int j = 0; j < 3; ++j)
    {
      const SpaceVector axis(
        {some_axes[0][j], some_axes[1][j], some_axes[2][j]});
      EXPECT_LT((inertia * axis - expected[j] * axis).norm(), 1e-14);
    }
}
