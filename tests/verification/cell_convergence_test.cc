#include <gtest/gtest.h>
#include <support/cell_scene.h>

#include <cmath>
#include <cstdio>

// Schemes of the rigid cell against arkode (see cell_reference_test.cc): order
// of the consistent ones, failure of the printed one, energies.

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::vector<unsigned int> cases = {1, 4, 5, 8};

  struct Errors
  {
    double theta, f2;
  };

  Errors errors_of(CellCase c, const unsigned int n_steps)
  {
    const auto exact   = complete_history([c, n_steps]() {
      CellCase reference = c;
      reference.scheme   = "arkode";
      reference.n_steps  = n_steps;
      return reference;
    }());
    c.n_steps          = n_steps;
    const auto samples = complete_history(c);
    return {largest_difference(samples, exact, &CellSample::angle),
            largest_difference(samples, exact, &CellSample::transmitted)};
  }

  void expect_second_order(const std::string &scheme)
  {
    std::printf("\n**%s**\n\n| case | steps | theta | order | f2 | order |\n"
                "|---|---|---|---|---|---|\n",
                scheme.c_str());
    for (const unsigned int n : cases)
      {
        CellCase c = table_case(n);
        c.scheme   = scheme;
        Errors before{NAN, NAN};
        for (const unsigned int n_steps : {500, 1000, 2000, 4000})
          {
            const Errors now         = errors_of(c, n_steps);
            const double theta_order = std::log2(before.theta / now.theta);
            const double f2_order    = std::log2(before.f2 / now.f2);
            std::printf("| %u | %u | %.2e | %.2f | %.2e | %.2f |\n",
                        n,
                        n_steps,
                        now.theta,
                        theta_order,
                        now.f2,
                        f2_order);
            // Two halvings in which the leading term must show.
            if (n_steps > 1000)
              {
                EXPECT_NEAR(theta_order, 2, 0.15) << scheme << n;
                EXPECT_NEAR(f2_order, 2, 0.15) << scheme << n;
              }
            before = now;
          }
      }
  }
} // namespace

TEST(CellConvergence, SecondOrderOfTheAlphaFamily)
{
  for (const std::string scheme : {"newmark", "hht", "generalized-alpha"})
    expect_second_order(scheme);
}

TEST(CellConvergence, SecondOrderOfTheCorrectedCentralDifference)
{
  expect_second_order("central difference");
}

// Without - 2 x(i) the printed Eqs. (24), (25) make x(i+2) - x(i-2), a velocity
// times 4 dt, equal to 4 dt^2 times the acceleration: a velocity that vanishes
// with dt. So does the motion, to first order; what moves the cell nearly at
// once is the spring, which Eq. (18) stretches from the start.
TEST(CellConvergence, ThePrintedSchemeStopsMovingWithSmallSteps)
{
  std::printf("\n**as printed**: turn at 50 ms\n\n"
              "| case | steps | turn (deg) | ratio |\n|---|---|---|---|\n");
  for (const unsigned int n : cases)
    {
      CellCase c    = table_case(n);
      c.scheme      = "as printed";
      double before = NAN;
      for (const unsigned int n_steps : {4000, 8000, 16000, 32000})
        {
          c.n_steps = n_steps;
          const double rotation =
            (complete_history(c).back().angle - M_PI / 6) * 180 / M_PI;
          std::printf("| %u | %u | %.5f | %.3f |\n",
                      n,
                      n_steps,
                      rotation,
                      rotation / before);
          if (n_steps > 8000)
            {
              EXPECT_NEAR(rotation / before, 0.5, 0.1) << n;
            }
          before = rotation;
        }
    }
}

// The work of the load is trapezoidal, the masses change with the angle: the
// balance is of second order in dt, and at 2 us below 1e-8 of the work.
TEST(CellConvergence, EnergyBalanceAtAFineStep)
{
  std::printf("\n**newmark**: energy balance over the work done\n\n"
              "| case | dt | balance / work |\n|---|---|---|\n");
  for (const unsigned int n : cases)
    for (const unsigned int n_steps : {1000, 5000, 25000})
      {
        CellCase c           = table_case(n);
        c.scheme             = "newmark";
        c.n_steps            = n_steps;
        double largest_error = 0, work = 0;
        for (const CellSample &sample : complete_history(c))
          {
            largest_error =
              std::max(largest_error, std::abs(sample.energies.balance(0)));
            work = std::max(work, std::abs(sample.energies.external()));
          }
        std::printf("| %u | %.0f us | %.2e |\n",
                    n,
                    1e6 * c.end / n_steps,
                    largest_error / work);
        if (n_steps == 25000)
          {
            EXPECT_LT(largest_error, 1e-8 * work) << n;
          }
      }
}
