#include <auxfem/connectors/maxwell.h>

#include <gtest/gtest.h>

#include <cmath>

#include "law_on_trial.h"

using namespace auxfem;

namespace
{
  LawOnTrial maxwell(const std::string &stiffness = "1000",
                     const std::string &damping   = "50")
  {
    return LawOnTrial(make_law("maxwell",
                               {{"Spring stiffness", stiffness},
                                {"Damping coefficient", damping}}));
  }

  /** Relaxation time tau = c / k of maxwell() (s). */
  constexpr double tau = 0.05;

  /** dt / tau from 1e-6 to 1e6. */
  std::vector<double> reduced_steps()
  {
    std::vector<double> steps;
    for (int exponent = -6; exponent <= 6; ++exponent)
      for (const double digit : {1., 2.5, 4.9, 5.1})
        steps.push_back(digit * std::pow(10., exponent));
    steps.back() = 1e6;
    return steps;
  }

  /** Energy lost in a step at a constant rate. */
  double lost_in_ramp(const MaxwellElement &element,
                      const double          force,
                      const double          increment,
                      const double          dt)
  {
    return element.dissipated_energy(force, increment, increment / dt, dt);
  }

  /**
   * Integral of F^2/c over a step that starts with the steady-flow force c v.
   */
  long double loss(const long double k,
                   const long double force,
                   const long double increment,
                   const long double a)
  {
    const long double flow = k * increment / a, rest = force - flow;
    return (flow * flow * a - 2 * flow * rest * std::expm1(-a) -
            0.5L * rest * rest * std::expm1(-2 * a)) /
      k;
  }

  /** Amplitude ratios of force and extension in the last of @p cycles, and
   * dissipation. */
  struct Harmonic
  {
    double storage = 0, loss = 0, dissipated = 0;
  };

  Harmonic harmonic(LawOnTrial         law,
                    const double       w,
                    const double       U,
                    const unsigned int n_steps,
                    const unsigned int n_cycles)
  {
    Harmonic     result;
    const double dt = 2 * M_PI / (w * n_steps);
    for (unsigned int i = 1; i <= n_steps * n_cycles; ++i)
      {
        const double before = law.dissipated;
        const double phase  = 2 * M_PI * i / n_steps;
        const double force =
          law.step(U * std::sin(phase), U * w * std::cos(phase), dt).force;
        if (i > n_steps * (n_cycles - 1))
          {
            result.storage += 2 * force * std::sin(phase) / (U * n_steps);
            result.loss += 2 * force * std::cos(phase) / (U * n_steps);
            result.dissipated += law.dissipated - before;
          }
      }
    return result;
  }
} // namespace

TEST(Maxwell, Relaxation)
{
  // ten printed digits
  const double times[]  = {0.01, 0.05, 0.1, 0.2};
  const double forces[] = {8.1873075308,
                           3.6787944117,
                           1.3533528324,
                           0.1831563889};
  LawOnTrial   law      = maxwell();
  double       previous = 0;
  EXPECT_DOUBLE_EQ(law.ramp(0.01, 0.).force, 10.);
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(law.ramp(0.01, times[i] - previous).force, forces[i], 1e-10);
      previous = times[i];
    }
}

TEST(Maxwell, Ramp)
{
  const double times[]  = {0.01, 0.05, 0.1, 0.2};
  const double forces[] = {0.9063462346,
                           3.1606027941,
                           4.3233235838,
                           4.9084218056};
  LawOnTrial   law      = maxwell();
  double       previous = 0;
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(law.step(0.1 * times[i], 0.1, times[i] - previous).force,
                  forces[i],
                  1e-10);
      previous = times[i];
    }
}

// w tau = 1: K' = K'' = k/2. The rate is linear in each step instead of a
// cosine: third order in dt, fourth for the dissipation of a cycle. After 12
// cycles the start has decayed to e^-75.
TEST(Maxwell, HarmonicModuliAndLossOfACycle)
{
  const Harmonic coarse = harmonic(maxwell(), 20, 0.01, 100, 12);
  const Harmonic fine   = harmonic(maxwell(), 20, 0.01, 200, 12);
  const double   bound  = std::pow(2 * M_PI / 200, 2) / 5;
  EXPECT_NEAR(fine.storage, 500, 500 * bound);
  EXPECT_NEAR(fine.loss, 500, 500 * bound);
  EXPECT_NEAR(fine.dissipated, 0.1570796327, 0.157 * bound);

  EXPECT_NEAR((coarse.loss - 500) / (fine.loss - 500), 8, 0.1);
  EXPECT_NEAR((coarse.dissipated - 0.15707963268) /
                (fine.dissipated - 0.15707963268),
              16,
              0.1);
}

TEST(Maxwell, HarmonicStartFromRest)
{
  // F = U (K' sin + K'' cos) - k U x / (1 + x^2) e^(-t/tau) with x = w tau = 1
  const double w = 20, U = 0.01, dt = 1e-4;
  LawOnTrial   law = maxwell();
  for (unsigned int i = 1; i <= 1000; ++i)
    {
      const double t = i * dt;
      const double exact =
        U * 500 * (std::sin(w * t) + std::cos(w * t) - std::exp(-t / tau));
      // second order: (w dt)^2 / 12 of k U
      EXPECT_NEAR(law.ramp(U * std::sin(w * t), dt).force,
                  exact,
                  10 * std::pow(w * dt, 2) / 12);
    }
}

TEST(Maxwell, SubstepsEqualOneStepForLinearExtension)
{
  for (const double a : reduced_steps())
    {
      LawOnTrial whole = maxwell(), halves = maxwell();
      for (LawOnTrial *law : {&whole, &halves})
        law->ramp(0.004, 0.);
      whole.ramp(0.01, a * tau);
      halves.ramp(0.007, 0.5 * a * tau);
      halves.ramp(0.01, 0.5 * a * tau);
      EXPECT_NEAR(halves.force, whole.force, 1e-14 * 10) << a;
      EXPECT_NEAR(halves.stored, whole.stored, 1e-14 * 0.05) << a;
      // The dissipation of a half step is a quadratic form whose coefficients
      // have errors up to 3 eps / a^2, at a = 0.5.
      EXPECT_NEAR(halves.dissipated, whole.dissipated, 1e-13 * whole.dissipated)
        << a;
    }
}

// The reference loses about 1e-19 / a^2 of the dissipation to cancellation.
TEST(Maxwell, UpdateAndLossForAllStepLengths)
{
  const MaxwellElement element = {1000., tau};
  for (const double a : reduced_steps())
    {
      const MaxwellElement::Step step = element.step(a * tau);
      // A relative error eps of a is one of a eps in e^(-a).
      EXPECT_NEAR(step.decay, std::exp(-a), 1e-15 * (1 + a) * std::exp(-a));
      const long double mean = -std::expm1(-static_cast<long double>(a)) / a;
      EXPECT_NEAR((step.stiffness + step.damping / (a * tau)) /
                    (1000 * static_cast<double>(mean)),
                  1,
                  1e-14)
        << a;

      if (a > 1e-3)
        for (const double force : {0., 4., -7.})
          {
            const double exact = loss(1000, force, 0.01, a);
            EXPECT_NEAR(lost_in_ramp(element, force, 0.01, a * tau),
                        exact,
                        (1e-13 + 1e-18 / (a * a)) * exact)
              << a << ' ' << force;
          }
    }
}

TEST(Maxwell, LossOfShortStepsIsThatOfTheMeanSquareForce)
{
  // For a -> 0 the force goes linearly from F0 to F1 = F0 + k du up to terms
  // of relative size a, and the loss is (F0^2 + F0 F1 + F1^2) / 3 dt / c.
  const MaxwellElement element = {1000., tau};
  for (const double a : {1e-6, 1e-9, 1e-12})
    EXPECT_NEAR(lost_in_ramp(element, 4., 0.006, a * tau) /
                  ((16. + 40. + 100.) / 3. * a / 1000.),
                1,
                a + 1e-14);
}

TEST(Maxwell, StepsFromTinyToInfinite)
{
  const MaxwellElement element = {1000., tau};
  EXPECT_NEAR(element.step(1e-12 * tau).stiffness, 1000., 1e-9);
  EXPECT_EQ(element.step(0.).stiffness, 1000.);
  EXPECT_EQ(element.step(0.).damping, 0.);
  EXPECT_EQ(element.step(0.).decay, 1.);
  EXPECT_EQ(element.step(infinity).stiffness, 0.);
  EXPECT_EQ(element.step(infinity).damping, 50.);
  EXPECT_EQ(element.step(infinity).decay, 0.);
  EXPECT_EQ(element.dissipated_energy(4., 0.01, 0., 0.), 0.);
}

TEST(Maxwell, InfiniteStepDissipatesAllStoredEnergy)
{
  LawOnTrial law = maxwell();
  law.ramp(0.01, 0.);
  EXPECT_DOUBLE_EQ(law.stored, 0.05);
  const ConnectorResponse response = law.ramp(0.02, infinity);
  EXPECT_EQ(response.force, 0.);
  EXPECT_EQ(response.stiffness, 0.);
  EXPECT_EQ(law.stored, 0.);
  EXPECT_DOUBLE_EQ(law.dissipated, 0.05);
  EXPECT_EQ(law.law->relaxed(0).stiffness, 0.);
}

TEST(Maxwell, LimitOfNoDamping)
{
  LawOnTrial law = maxwell("1000", "0");
  for (const double dt : {0., 1e-9, 1., infinity})
    {
      const ConnectorResponse response = law.step(law.extension + 0.01, 1., dt);
      EXPECT_EQ(response.force, 0.);
      EXPECT_EQ(response.stiffness, 0.);
      EXPECT_EQ(law.stored, 0.);
      EXPECT_EQ(law.dissipated, 0.);
    }
  // The upper limit is the steady-flow force c v.
  EXPECT_NEAR(maxwell("1000", "1e-9").step(0.01, 0.1, 0.1).force, 1e-10, 1e-20);
}

TEST(Maxwell, LimitOfInfiniteDampingIsASpring)
{
  // The force decays by the fraction a / 2: dt k / (2 c) = 5e-14.
  LawOnTrial law = maxwell("1000", "1e15");
  EXPECT_NEAR(law.step(0.01, 0.1, 0.1).force, 10., 1e-12);
  EXPECT_NEAR(law.stored, 0.05, 1e-14);
  EXPECT_NEAR(law.dissipated, 0., 1e-14);
}

TEST(Maxwell, LimitOfInfiniteStiffnessIsADashpot)
{
  // a = 2e14: the spring stretches by F / k = 5e-15 m.
  LawOnTrial law = maxwell("1e15", "50");
  EXPECT_NEAR(law.step(0.01, 0.1, 0.1).force, 5., 1e-12);
  EXPECT_NEAR(law.stored, 0., 1e-12);
  EXPECT_NEAR(law.dissipated, 0.05, 1e-12);
}

// Stored and dissipated energy are exact for extensions linear in the steps;
// the trapezoidal work has an error of order dt^2.
TEST(Maxwell, EnergyBalanceConvergesWithSecondOrder)
{
  double error[2];
  for (const unsigned int level : {0, 1})
    {
      const unsigned int n   = 200u << level;
      const double       dt  = 0.3 / n;
      LawOnTrial         law = maxwell();
      for (unsigned int i = 1; i <= n; ++i)
        law.ramp(0.01 * std::sin(15 * i * dt) * i * dt, dt);
      error[level] =
        std::abs(law.stored + law.dissipated - law.work) / law.dissipated;
    }
  EXPECT_LT(error[1], 1e-4);
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2, 0.05);
}

TEST(Maxwell, RefusesZeroStiffness)
{
  EXPECT_ANY_THROW(maxwell("0", "50"));
}
