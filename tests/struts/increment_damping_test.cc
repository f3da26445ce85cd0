#include <auxfem/struts/beam_dispatch.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  constexpr double chi_on_trial = 0.1;

  /**
   * Added stress over C for the increments @p last and @p now of one strain.
   */
  double added_strain(const double dt_before,
                      const double dt,
                      const double last,
                      const double now)
  {
    double           remembered = 0;
    IncrementDamping damping(chi_on_trial, dt, dt_before);
    damping.previous_increments = &last;
    damping.current_increments  = &remembered;
    const double added          = damping(0, now);
    EXPECT_EQ(remembered, now);
    return added;
  }
} // namespace

TEST(IncrementDamping, EqualStepsUseTheChangeOfTheIncrement)
{
  EXPECT_NEAR(added_strain(0.2, 0.2, 3, 5), chi_on_trial / 2 * 2, 1e-16);
  EXPECT_NEAR(IncrementDamping(chi_on_trial, 0.2, 0.2).current_factor,
              IncrementDamping(chi_on_trial, 0.2, 0.2).tangent_factor,
              1e-16);
}

TEST(IncrementDamping, ConstantRatesAreNotDampedInShorterSteps)
{
  EXPECT_NEAR(added_strain(0.4, 0.1, 4, 1), 0, 1e-16);
}

TEST(IncrementDamping, DissipatesAtLeastTheGrowthOfItsEnergy)
{
  for (const double dt_before : {0.01, 0.1, 0.2, 0.3, 3.})
    for (const double last : {-2., -0.3, 0., 0.7, 1., 4.})
      EXPECT_GE(added_strain(dt_before, 0.2, last, 1.) * 1,
                chi_on_trial / 4 * (1 - last * last) - 1e-15);
}

TEST(IncrementDamping, TheFirstStepHasNoPreviousIncrement)
{
  EXPECT_NEAR(added_strain(0, 0.2, 1e9, 1), chi_on_trial / 4, 1e-16);
}
