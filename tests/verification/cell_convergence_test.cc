#include <gtest/gtest.h>
#include <support/cell_scene.h>

#include <cmath>
#include <cstdio>

#include "result_table.h"

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
    ResultTable table(
      "Reduced cell by " + scheme +
        ", largest differences from arkode, of the largest value",
      {"case", "steps", "theta", "order", "f2", "order"});
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
            table.row({std::to_string(n),
                       std::to_string(n_steps),
                       formatted("%.2e", now.theta),
                       n_steps > 500 ? formatted("%.2f", theta_order) : "",
                       formatted("%.2e", now.f2),
                       n_steps > 500 ? formatted("%.2f", f2_order) : ""});
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
  ResultTable table("Reduced cell by as printed, rotation at 50 ms",
                    {"case", "steps", "rotation (deg)", "ratio"});
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
          table.row(
            {std::to_string(n),
             std::to_string(n_steps),
             formatted("%.5f", rotation),
             n_steps > 4000 ? formatted("%.3f", rotation / before) : ""});
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
  ResultTable table(
    "Reduced cell by newmark, energy balance over the work done",
    {"case", "step (us)", "balance / work"});
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
        table.row({std::to_string(n),
                   formatted("%.0f", 1e6 * c.end / n_steps),
                   formatted("%.2e", largest_error / work)});
        if (n_steps == 25000)
          {
            EXPECT_LT(largest_error, 1e-8 * work) << n;
          }
      }
}
