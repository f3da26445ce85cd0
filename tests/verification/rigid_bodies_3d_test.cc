#include <support/scene_text.h>
#include <verification/result_table.h>
#include <verification/space_frame.h>
#include <verification/space_text.h>

#include <algorithm>
#include <vector>

#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Rigid bodies in space against closed forms and against reference integrations
// of Euler's equations.

namespace
{
  const std::vector<std::string> rigid_scheme = {
    "Time/Scheme=generalized-alpha"};

  /** A free strut of 2 kg with @p inertia that spins as @p rates say. */
  SceneText free_body(const SpaceVector &inertia,
                      const SpaceVector &rates,
                      const double       dt,
                      const double       end)
  {
    return SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0.4 -0.3", "0 1")
      .add(body("0", 2, inertia))
      .add(initial_motion(vector(0.3, -0.2, 0.5), rates))
      .time(end, dt);
  }
} // namespace

TEST(RigidBodies3d, ASpinAboutAPrincipalAxisStaysEven)
{
  // Also about the axis of the middle moment, where the spin is not stable: ten
  // turns are too few for round-off to grow.
  ComparisonTable table("Free rigid body that spins about a principal axis");
  for (unsigned int axis = 0; axis < 3; ++axis)
    {
      SpaceVector rates;
      rates[axis] = 10;
      SceneRun run(free_body(vector(0.3, 0.4, 0.5), rates, 0.01, 1));
      run.run();
      const SpaceVector velocity = part_vector(run, *run.state.velocity, 3);
      table.row(label("error of the rates, axis", axis),
                (velocity - rates).norm(),
                0,
                1e-12);
      table.row(label("error of the rotation, axis", axis),
                rotation_vector(exponential(-1. * rates) *
                                rotation_of_part(run))
                  .norm(),
                0,
                1e-12);
    }
}

namespace
{
  /** Largest errors of a free symmetric top over a run. */
  struct TopErrors
  {
    double rates = 0, momentum = 0, energy = 0;
  };

  TopErrors symmetric_top(const double                    dt,
                          const std::vector<std::string> &overrides)
  {
    const SpaceVector inertia = vector(0.4, 0.4, 0.7), rates = vector(3, 0, 8);
    SceneRun          run(free_body(inertia, rates, dt, 2), overrides);
    // The transverse rate turns by (J3 - J1) / J1 W3.
    const double      precession = 0.3 / 0.4 * 8;
    const SpaceVector momentum   = vector(0.4 * 3, 0, 0.7 * 8);
    const double      energy     = run.state.energies.total();
    TopErrors         errors;
    run.run([&] {
      const double      angle = precession * run.state.time;
      const SpaceVector W     = part_vector(run, *run.state.velocity, 3),
                        expected =
                          vector(3 * std::cos(angle), 3 * std::sin(angle), 8);
      errors.rates = std::max(errors.rates, (W - expected).norm());
      const SpaceVector now =
        rotated(rotation_of_part(run),
                vector(0.4 * W[0], 0.4 * W[1], 0.7 * W[2]));
      errors.momentum = std::max(errors.momentum, (now - momentum).norm());
      errors.energy =
        std::max(errors.energy, std::abs(run.state.energies.total() - energy));
    });
    return errors;
  }
} // namespace

TEST(RigidBodies3d, AFreeSymmetricTopPrecesses)
{
  ComparisonTable table("Free symmetric top, J = 0.4, 0.4, 0.7 kg m2, rates 3, "
                        "0, 8 rad/s, for 2 s");
  for (const auto &[name, overrides] :
       {std::pair(std::string("newmark"), std::vector<std::string>()),
        std::pair(std::string("generalized-alpha"), rigid_scheme)})
    {
      const TopErrors coarse = symmetric_top(4e-3, overrides),
                      fine   = symmetric_top(2e-3, overrides);
      table.row(name + ", order of the body rates",
                std::log2(coarse.rates / fine.rates),
                2,
                0.1);
      table.row(name + ", order of the angular momentum",
                std::log2(coarse.momentum / fine.momentum),
                2,
                0.1);
      // (w dt)^2 / 12 with w of 8 rad/s, of rates of 3 rad/s, for 16 rad.
      table.row(name + ", error of the rates (rad/s), 2 ms",
                fine.rates,
                0,
                1e-3);
      table.row(name + ", error of the momentum (N m s), 2 ms",
                fine.momentum,
                0,
                1e-4);
      // Newmark's method keeps it.
      table.row(name + ", error of the energy (J), 2 ms",
                fine.energy,
                0,
                overrides.empty() ? 1e-11 : 2e-5);
    }
}

namespace
{
  /** The heavy top of Bruels & Cardona 2010, its point at the origin. */
  SceneText heavy_top(const double dt, const double end)
  {
    // The mean of the joints' positions is the centre of mass, (0, 1, 0).
    return SceneText()
      .dimension(3)
      .frame("0 0 0; 0 2 0", "0 1")
      .add(body("0", 15, vector(0.234375, 0.46875, 0.234375)))
      .add(initial_motion(vector(4.61538, 0, 0), vector(0, 150, -4.61538)))
      .support("pivot", "0", "pin")
      .set("Gravity/Acceleration z", -9.81)
      .time(end, dt);
  }

  struct TopState
  {
    double      time;
    SpaceVector centre;
    double      rate_1, rate_3;
  };

  /** Euler's equations by a Runge-Kutta method of order 8, rtol 1e-13. */
  const std::vector<TopState> top_reference = {
    {0.1, vector(0.42129666, 0.89457197, -0.14916470), 4.80894133, 1.02830076},
    {0.2, vector(0.60555056, 0.59895768, -0.52398303), -2.69159091, 4.91726099},
    {0.5,
     vector(-0.70246830, -0.02116518, -0.71140026),
     -0.47105310,
     5.90108305},
    {1, vector(0.17334396, 0.64008859, -0.74849079), -0.82207810, -5.92329135},
    {2,
     vector(-0.15041682, -0.72416559, -0.67302227),
     0.12223322,
     -5.85562459}};

  struct HeavyTopErrors
  {
    std::vector<double> centre, rates; ///< at the reference's times
    double              spin = 0, energy = 0, pivot = 0;
  };

  HeavyTopErrors heavy_top_errors(const double                    dt,
                                  const double                    end,
                                  const std::vector<std::string> &overrides)
  {
    SceneRun       run(heavy_top(dt, end), overrides);
    HeavyTopErrors errors;
    EXPECT_NEAR(run.state.energies.kinetic(), 5435.696790866, 1e-8);
    run.run([&] {
      const SpaceVector W = part_vector(run, *run.state.velocity, 3);
      errors.spin         = std::max(errors.spin, std::abs(W[1] - 150));
      errors.energy       = std::max(errors.energy, std::abs(run.balance()));
      for (const TopState &state : top_reference)
        if (std::abs(run.state.time - state.time) < 1e-9)
          {
            const SpaceVector centre =
              vector(0, 1, 0) + part_vector(run, run.state.displacement, 0);
            errors.centre.push_back((centre - state.centre).norm());
            errors.rates.push_back(
              std::hypot(W[0] - state.rate_1, W[2] - state.rate_3));
            errors.pivot =
              std::max(errors.pivot,
                       (centre -
                        rotated(rotation_of_part(run), vector(0, 1, 0)))
                         .norm());
          }
    });
    return errors;
  }
} // namespace

TEST(RigidBodies3d, HeavyTopIsOfSecondOrder)
{
  // The spin turns the body by 30 rad: errors of (w dt)^2 / 12, w = 150 rad/s,
  // of that.
  ComparisonTable table("Heavy top of Bruels & Cardona 2010 at 0.2 s");
  for (const auto &[name, overrides] :
       {std::pair(std::string("newmark"), std::vector<std::string>()),
        std::pair(std::string("generalized-alpha"), rigid_scheme)})
    {
      std::vector<HeavyTopErrors> errors;
      for (const double dt : {1e-3, 5e-4, 2.5e-4})
        {
          errors.push_back(heavy_top_errors(dt, 0.2, overrides));
          table.row(name + label(", error of the centre (m), dt", dt),
                    errors.back().centre.back(),
                    0,
                    2500 * dt * dt);
          table.row(name + label(", error of the rates (rad/s), dt", dt),
                    errors.back().rates.back(),
                    0,
                    4e4 * dt * dt);
        }
      for (unsigned int i = 1; i < 3; ++i)
        {
          table.row(name + label(", order of the centre, halving", i),
                    std::log2(errors[i - 1].centre.back() /
                              errors[i].centre.back()),
                    2,
                    0.02);
          table.row(name + label(", order of the rates, halving", i),
                    std::log2(errors[i - 1].rates.back() /
                              errors[i].rates.back()),
                    2,
                    0.02);
        }
      table.row(name + ", spin (rad/s)", errors.back().spin, 0, 1e-8);
      table.row(name + ", energy (J)", errors.back().energy, 0, 5e-3);
      table.row(name + ", centre and rotation (m)",
                errors.back().pivot,
                0,
                1e-13);
    }
}

TEST(RigidBodies3d, HeavyTopFor2Seconds)
{
  const HeavyTopErrors errors = heavy_top_errors(1e-4, 2, {});
  ComparisonTable table("Heavy top of Bruels & Cardona 2010, newmark, steps "
                        "of 0.1 ms");
  for (unsigned int i = 0; i < top_reference.size(); ++i)
    {
      table.row(label("error of the centre (m), t", top_reference[i].time),
                errors.centre[i],
                0,
                2e-4);
      table.row(label("error of the rates (rad/s), t", top_reference[i].time),
                errors.rates[i],
                0,
                2e-3);
    }
  table.row("energy balance (J of 5436)", errors.energy, 0, 5e-3);
}
