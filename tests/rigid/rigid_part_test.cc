#include <auxfem/rigid/rigid_part.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Round-off of some ten operations on numbers of size ten. */
  constexpr double rigid_part_round_off = 1e-13;

  const dealii::Point<3> r0(0.3, -0.2, 0), r1(1.5, 0.7, 0); // 1.5 m apart
  constexpr double       length = 1.5;

  PlaneVector vector(const double x, const double y)
  {
    PlaneVector v;
    v[0] = x;
    v[1] = y;
    return v;
  }

  PlaneVector turned_by(const PlaneVector &v, const double angle)
  {
    return std::cos(angle) * v + std::sin(angle) * perpendicular(v);
  }

  /** The base at rest. */
  const PlaneVector rest = vector(1.2, 0.9);

  /** Position of @p p after a rigid motion, a rotation about the origin and a
   * translation. */
  PlaneVector moved(const dealii::Point<3> &p, const double angle)
  {
    return turned_by(vector(p[0], p[1]), angle) + vector(4., -7.);
  }

  /** Velocity of @p p in a rotation at @p rate about @p pole. */
  PlaneVector turning(const dealii::Point<3> &p,
                      const dealii::Point<3> &pole,
                      const double            rate)
  {
    return rate * perpendicular(vector(p[0] - pole[0], p[1] - pole[1]));
  }

  /** (v0, v1) . M . (v0, v1) / 2 */
  double kinetic_energy(const std::array<double, 16> &mass,
                        const PlaneVector            &v0,
                        const PlaneVector            &v1)
  {
    const double v[4]   = {v0[0], v0[1], v1[0], v1[1]};
    double       energy = 0;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        energy += mass[4 * i + j] * v[i] * v[j] / 2;
    return energy;
  }
} // namespace

TEST(RigidPartElement, BasePointsHaveBasePositions)
{
  const NaturalPosition first  = natural_position<2>(r0, r1, r0),
                        second = natural_position<2>(r0, r1, r1);
  EXPECT_NEAR(first.a, 0, rigid_part_round_off);
  EXPECT_NEAR(first.b, 0, rigid_part_round_off);
  EXPECT_NEAR(second.a, 1, rigid_part_round_off);
  EXPECT_NEAR(second.b, 0, rigid_part_round_off);
}

TEST(RigidPartElement, PositionsArePositiveToTheLeftOfTheBase)
{
  // Base from (0, 0) to (2, 0): half a base along, a quarter to the left.
  const NaturalPosition position =
    natural_position<2>({0, 0, 0}, {2, 0, 0}, {1, 0.5, 0});
  EXPECT_NEAR(position.a, 0.5, rigid_part_round_off);
  EXPECT_NEAR(position.b, 0.25, rigid_part_round_off);
}

TEST(RigidPartElement, ShapeFollowsARigidMotion)
{
  for (const dealii::Point<3> &point :
       {dealii::Point<3>(2, 3, 0), dealii::Point<3>(-5, 0.1, 0)})
    for (const double angle : {0., 0.7, 2.5, -3.})
      {
        const PlaneVector at0 = moved(r0, angle), at1 = moved(r1, angle),
                          expected     = moved(point, angle);
        const NaturalPosition position = natural_position<2>(r0, r1, point);
        for (unsigned int c = 0; c < 2; ++c)
          {
            const std::array<double, 4> shares = shape<2>(position, c);
            EXPECT_NEAR(shares[0] * at0[0] + shares[1] * at0[1] +
                          shares[2] * at1[0] + shares[3] * at1[1],
                        expected[c],
                        rigid_part_round_off);
          }
      }
}

TEST(RigidPartElement, ShapeGivesAForceItsResultantAndMoment)
{
  const dealii::Point<3> point(2, 3, 0);
  for (unsigned int c = 0; c < 2; ++c)
    {
      const auto   f = shape<2>(natural_position<2>(r0, r1, point), c);
      const double moment =
        r0[0] * f[1] - r0[1] * f[0] + r1[0] * f[3] - r1[1] * f[2];
      EXPECT_NEAR(f[0] + f[2], c == 0 ? 1 : 0, rigid_part_round_off);
      EXPECT_NEAR(f[1] + f[3], c == 0 ? 0 : 1, rigid_part_round_off);
      EXPECT_NEAR(moment, c == 0 ? -point[1] : point[0], rigid_part_round_off);
    }
}

TEST(RigidPartElement, MassOfAnEvenBarIsAThirdAndASixth)
{
  const double mass = 6;
  const auto   M =
    rigid_mass_matrix<2>(mass, mass * length * length / 12, length, {0.5, 0});
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      EXPECT_NEAR(M[4 * i + j],
                  i == j             ? 2.
                    : i % 2 == j % 2 ? 1.
                                     : 0.,
                  rigid_part_round_off);
}

TEST(RigidPartElement, EnergyIsThatOfTranslationAndOfRotationAboutAnyPoint)
{
  const double mass = 2.3, inertia = 0.9;
  // On the base line and off it, to either side.
  for (const dealii::Point<3> &centre : {dealii::Point<3>(0.9, 0.25, 0),
                                         dealii::Point<3>(2, 3, 0),
                                         dealii::Point<3>(0, -4, 0)})
    {
      const auto        M = rigid_mass_matrix<2>(mass,
                                          inertia,
                                          length,
                                          natural_position<2>(r0, r1, centre));
      const PlaneVector v = vector(0.8, -1.7);
      EXPECT_NEAR(kinetic_energy(M, v, v),
                  mass * v.norm_square() / 2,
                  10 * rigid_part_round_off);
      for (const dealii::Point<3> &pole :
           {centre, r0, dealii::Point<3>(-1, 5, 0)})
        {
          const double rate = 1.9;
          EXPECT_NEAR(
            kinetic_energy(M, turning(r0, pole, rate), turning(r1, pole, rate)),
            (mass * centre.distance_square(pole) + inertia) * rate * rate / 2,
            // Round-off of sums of up to a few thousand joules.
            1e-11);
        }
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < i; ++j)
          EXPECT_EQ(M[4 * i + j], M[4 * j + i]);
    }
}

TEST(RigidPartElement, EveryRotationSatisfiesTheDistance)
{
  const DistanceConstraint<2> distance = {rest, length};
  for (const double angle : {0.7, 2.5, pi, -3., 2 * pi + 0.7})
    EXPECT_NEAR(distance.value(turned_by(rest, angle) - rest),
                0,
                rigid_part_round_off);
  // A base longer by s: (L + s)^2 - L^2 over 2 L.
  const double s = 1e-3;
  EXPECT_NEAR(distance.value(s / length * rest),
              s + s * s / (2 * length),
              rigid_part_round_off);
}

TEST(RigidPartElement, DistanceIsExactForTinyMotions)
{
  // 1e-12 m along the base: round-off of the product, not of the length.
  const DistanceConstraint<2> distance = {rest, length};
  EXPECT_NEAR(distance.value(1e-12 / length * rest), 1e-12, 1e-24);
}

TEST(RigidPartElement, DerivativesOfDistanceAreItsDifferences)
{
  const DistanceConstraint<2> distance = {rest, length};
  const PlaneVector           stretch  = vector(-0.4, 0.9);
  const PlaneVector           gradient = distance.gradient(stretch);
  const double                h        = 1e-4;
  for (unsigned int c = 0; c < 2; ++c)
    {
      PlaneVector step;
      step[c] = h;
      // Central differences of a quadratic have only round-off, eps / h.
      EXPECT_NEAR((distance.value(stretch + step) -
                   distance.value(stretch - step)) /
                    (2 * h),
                  gradient[c],
                  1e-11);
      for (unsigned int d = 0; d < 2; ++d)
        EXPECT_NEAR((distance.gradient(stretch + step)[d] - gradient[d]) / h,
                    c == d ? distance.curvature() : 0,
                    1e-11);
    }
}

TEST(RigidPartElement, SectionsThatRotateWithTheBodySatisfyTheClamp)
{
  const ClampConstraint clamp = {rest, length};
  for (const double angle : {0., 0.7, 2 * pi + 0.7, -2.5})
    EXPECT_NEAR(clamp.normal(angle) * turned_by(rest, angle),
                0,
                rigid_part_round_off);
  // L sin(angle of the base - angle of the section).
  EXPECT_NEAR(clamp.normal(0.2) * turned_by(rest, 0.9),
              length * std::sin(0.7),
              rigid_part_round_off);
  // The section may also rotate alone.
  EXPECT_NEAR(clamp.normal(2 * pi + 0.2) * turned_by(rest, 0.9),
              length * std::sin(0.7),
              rigid_part_round_off);
}

TEST(RigidPartElement, DerivativesOfTheClampAreItsDifferences)
{
  const ClampConstraint clamp = {rest, length};
  const double          phi = 0.8, h = 1e-4;
  const PlaneVector     first =
    (clamp.normal(phi + h) - clamp.normal(phi - h)) / (2 * h);
  const PlaneVector second =
    (clamp.normal_derivative(phi + h) - clamp.normal_derivative(phi - h)) /
    (2 * h);
  for (unsigned int c = 0; c < 2; ++c)
    {
      // Central differences: h^2 / 6 = 2e-9.
      EXPECT_NEAR(clamp.normal_derivative(phi)[c], first[c], 3e-9);
      EXPECT_NEAR(-clamp.normal(phi)[c], second[c], 3e-9);
    }
}
