#include <auxfem/analysis/reduced_cell/cell_equations.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

using namespace auxfem;

namespace
{
  constexpr double L1 = 0.4, theta0 = 0.6, m1 = 0.2, m2 = 0.7;
  /**
   * Step of central differences; truncation and round-off are both near 1e-10.
   */
  constexpr double h = 1e-5;

  CellEquations cell(const double bar_mass = m1, const double part_mass = m2)
  {
    ReducedCellDefinition definition;
    definition.bar_length = L1;
    definition.angle      = theta0;
    definition.bar_mass   = bar_mass;
    definition.part_mass  = part_mass;
    return CellEquations(definition);
  }

  /** Centre of mass (m) and angle (rad) of one of the six parts. */
  struct Body
  {
    double x, y, angle, mass, inertia;
  };

  /**
   * Positions of the six parts: F = (-w, yF), A further in, B = (-w, yF + 2 L1
   * sin theta); the right side is mirrored.
   */
  std::array<Body, 6> bodies(const CellVector &q)
  {
    const double w = 1, theta = theta0 + q[0], yF = q[1];
    const double I  = m1 * L1 * L1 / 12;
    const double Ax = -w + L1 * std::cos(theta), Ay = yF + L1 * std::sin(theta);
    const double By = yF + 2 * L1 * std::sin(theta);
    return {{{(-w + Ax) / 2, (yF + Ay) / 2, theta, m1, I},
             {(-w + Ax) / 2, (By + Ay) / 2, -theta, m1, I},
             {(w - Ax) / 2, (yF + Ay) / 2, -theta, m1, I},
             {(w - Ax) / 2, (By + Ay) / 2, theta, m1, I},
             {0, By, 0, m2, 0},
             {0, yF, 0, m2, 0}}};
  }

  /** Sum over the bodies, their velocities by differences along the motion. */
  double kinetic_energy(const CellMotion &motion)
  {
    const auto before = bodies(motion.position - h * motion.velocity);
    const auto after  = bodies(motion.position + h * motion.velocity);
    double     energy = 0;
    for (unsigned int i = 0; i < 6; ++i)
      {
        const double vx = (after[i].x - before[i].x) / (2 * h);
        const double vy = (after[i].y - before[i].y) / (2 * h);
        const double w  = (after[i].angle - before[i].angle) / (2 * h);
        energy += 0.5 * before[i].mass * (vx * vx + vy * vy) +
          0.5 * before[i].inertia * w * w;
      }
    return energy;
  }

  CellVector vector(const double a, const double b)
  {
    CellVector v;
    v[0] = a;
    v[1] = b;
    return v;
  }

  /** Motions at angles around the full circle, including cos theta = 0. */
  std::vector<CellMotion> motions()
  {
    std::vector<CellMotion> result;
    for (const double rotation : {0., -0.9, 2.5, M_PI / 2 - theta0, -4.})
      for (const double rate : {-3., 0.5})
        result.push_back({vector(rotation, 0.03), vector(rate, 0.8)});
    return result;
  }

  CellVector derivative(const std::function<CellVector(double)> &f,
                        const double                             x)
  {
    return (f(x + h) - f(x - h)) / (2 * h);
  }

  void expect_near(const CellVector &a, const CellVector &b, const double size)
  {
    EXPECT_NEAR(a[0], b[0], size);
    EXPECT_NEAR(a[1], b[1], size);
  }
} // namespace

TEST(CellEquations, KineticEnergyIsThatOfTheSixBodies)
{
  for (const CellMotion &motion : motions())
    EXPECT_NEAR(cell().kinetic_energy(motion), kinetic_energy(motion), 1e-8);
}

// d/dt (dT/dq') - dT/dq with T of the six bodies: T is quadratic in q', so
// that differences in q' are exact.
TEST(CellEquations, LagrangesEquationsOfTheSixBodies)
{
  const auto momentum = [](const CellVector &q, const CellVector &v) {
    CellVector p;
    for (unsigned int i = 0; i < 2; ++i)
      {
        CellVector e;
        e[i] = 1;
        p[i] = (kinetic_energy({q, v + e}) - kinetic_energy({q, v - e})) / 2;
      }
    return p;
  };
  const double     step = 1e-4;
  const CellVector a    = vector(1.7, -2.1);
  for (const CellMotion &motion : motions())
    {
      const CellVector &q = motion.position, &v = motion.velocity;
      const CellVector  rate = (momentum(q + step * v, v + step * a) -
                               momentum(q - step * v, v - step * a)) /
        (2 * step);
      CellVector by_position;
      for (unsigned int i = 0; i < 2; ++i)
        {
          CellVector e;
          e[i] = step;
          by_position[i] =
            (kinetic_energy({q + e, v}) - kinetic_energy({q - e, v})) /
            (2 * step);
        }
      expect_near(cell().mass(q[0]) * a + cell().velocity_force(q[0], v[0]),
                  rate - by_position,
                  1e-5); // step^2 and 1e-11 / step, times a few units
    }
}

TEST(CellEquations, ForcesDoTheirWorkOnTheExtension)
{
  const CellEquations equations = cell();
  for (const CellMotion &motion : motions())
    {
      const CellVector &q = motion.position;
      const double      exact =
        q[1] + 2 * L1 * (std::sin(theta0 + q[0]) - std::sin(theta0));
      EXPECT_NEAR(equations.extension(q), exact, 1e-15);
      EXPECT_NEAR(equations.extension_rate(motion),
                  (equations.extension(q + h * motion.velocity) -
                   equations.extension(q - h * motion.velocity)) /
                    (2 * h),
                  1e-8);
    }
  // A rotation far below the last digit of theta0 still counts.
  EXPECT_NEAR(equations.extension(vector(1e-20, 0)),
              2e-20 * L1 * std::cos(theta0),
              1e-34);
}

TEST(CellEquations, DerivativesAgainstDifferences)
{
  const CellEquations equations = cell();
  for (const CellMotion &motion : motions())
    {
      const double     rotation = motion.position[0], rate = motion.velocity[0];
      const CellVector a = vector(1.3, -0.4);
      expect_near(equations.lever_derivative(rotation),
                  derivative([&](double x) { return equations.lever(x); },
                             rotation),
                  1e-8);
      expect_near(equations.mass_derivative(rotation) * a,
                  derivative([&](double x) { return equations.mass(x) * a; },
                             rotation),
                  1e-8);
      expect_near(
        equations.velocity_force_by_rotation(rotation, rate),
        derivative([&](double x) { return equations.velocity_force(x, rate); },
                   rotation),
        1e-7);
      expect_near(equations.velocity_force_by_rate(rotation, rate),
                  derivative(
                    [&](double x) {
                      return equations.velocity_force(rotation, x);
                    },
                    rate),
                  1e-7);
    }
}

// The resultant of all outer forces, -(f1 + F), changes the momentum of the six
// bodies along y, independently of hinge forces.
TEST(CellEquations, MomentumFollowsTheOuterForces)
{
  const double force = 37, step = 1e-4;
  for (const CellMotion &motion : motions())
    {
      const CellVector a         = cell().acceleration(motion, force);
      const auto       height_at = [&](const double t) {
        double sum = 0;
        for (const Body &body :
             bodies(motion.position + t * motion.velocity + t * t / 2 * a))
          sum += body.mass * body.y;
        return sum;
      };
      EXPECT_NEAR((height_at(step) - 2 * height_at(0) + height_at(-step)) /
                    (step * step),
                  -force,
                  1e-3); // fourth derivatives of fast motions times step^2
    }
}

TEST(CellEquations, TotalMass)
{
  EXPECT_DOUBLE_EQ(cell().mass(0.3)[1][1], 4 * m1 + 2 * m2);
}

TEST(CellEquations, OnlyMasslessBarsBecomeSingular)
{
  const double     upright = M_PI / 2 - theta0;
  const CellMotion motion  = {vector(upright, 0), vector(1, 0)};
  // Part mass 0 is no problem: det M = 16/3 m1^2 L1^2.
  EXPECT_NEAR(determinant(cell(m1, 0).mass(0.2)),
              16. / 3 * m1 * m1 * L1 * L1,
              1e-15);
  EXPECT_NO_THROW(cell(m1, 0).acceleration(motion, 1));
  EXPECT_NO_THROW(cell().acceleration(motion, 1));
  EXPECT_THROW(cell(0, m2).acceleration(motion, 1), ComputationError);
  EXPECT_NEAR(determinant(cell(0, m2).mass(0.2)),
              std::pow(2 * L1 * m2 * std::cos(theta0 + 0.2), 2),
              1e-15);
}
