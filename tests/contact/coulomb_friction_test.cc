#include <auxfem/contact/plate_definition.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace auxfem;

namespace
{
  using Vector3 = dealii::Tensor<1, 3>;

  constexpr CoulombFriction law_of_friction = {0.4, 0.3};

  /** Random velocities, normals and pressures. */
  struct RandomFriction
  {
    explicit RandomFriction(const unsigned int seed) : generator(seed)
    {
      velocity = vector();
      normal   = vector();
      normal /= normal.norm();
      pressure = 2 + number();
    }

    double number()
    {
      return std::uniform_real_distribution<double>(-1, 1)(generator);
    }

    Vector3 vector()
    {
      Vector3 result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = number();
      return result;
    }

    std::mt19937 generator;
    Vector3      velocity, normal;
    double       pressure;
  };

  Vector3
  force(const Vector3 &velocity, const Vector3 &normal, const double pressure)
  {
    return law_of_friction.force(velocity, normal, pressure).force;
  }
} // namespace

TEST(CoulombFriction, IsAlongTheFaceAgainstTheSlipAndBelowItsLimit)
{
  for (unsigned int seed = 1; seed <= 20; ++seed)
    {
      RandomFriction      at(seed);
      const FrictionForce found =
        law_of_friction.force(at.velocity, at.normal, at.pressure);
      EXPECT_NEAR(found.force * at.normal, 0, 1e-15 * at.pressure);
      EXPECT_LT(found.force.norm(), 0.4 * at.pressure);
      EXPECT_GT(found.lost_power(), 0);
      EXPECT_NEAR(found.lost_power(),
                  -(found.force * at.velocity),
                  1e-15 * at.pressure);
      // Normal motion causes no friction.
      EXPECT_LT((found.force -
                 force(at.velocity + 5 * at.normal, at.normal, at.pressure))
                  .norm(),
                1e-14 * at.pressure);
    }
  // At the slip velocity the limit over sqrt(2); the full limit for much faster
  // slip.
  EXPECT_NEAR(force(Vector3({0.3, 0, 0}), Vector3({0, 1, 0}), 2)[0],
              -0.4 * 2 / std::sqrt(2.),
              1e-15);
  EXPECT_NEAR(force(Vector3({0, 0, 3e6}), Vector3({0, 1, 0}), 2)[2],
              -0.8,
              1e-13);
}

TEST(CoulombFriction, ChangesAreDerivatives)
{
  // Differences over 2e-6 of forces of about one.
  constexpr double h = 1e-6, allowed = 1e-8;
  for (unsigned int seed = 1; seed <= 20; ++seed)
    {
      RandomFriction       at(seed);
      const FrictionChange change = law_of_friction.change(
        law_of_friction.force(at.velocity, at.normal, at.pressure),
        at.normal);
      const auto difference = [&](const Vector3 &velocity_direction,
                                  const Vector3 &normal_direction,
                                  const double   pressure_direction) {
        const auto moved = [&](const double step) {
          Vector3 normal = at.normal + step * normal_direction;
          normal /= normal.norm();
          return force(at.velocity + step * velocity_direction,
                       normal,
                       at.pressure + step * pressure_direction);
        };
        return (moved(-h) - moved(h)) / (2 * h);
      };
      const Vector3 any        = at.vector(), none,
                    along_face = any - (any * at.normal) * at.normal;
      EXPECT_LT((change.by_velocity * any - difference(any, none, 0)).norm(),
                allowed);
      EXPECT_LT((change.by_normal * along_face -
                 difference(none, along_face, 0))
                  .norm(),
                allowed);
      EXPECT_LT((change.by_pressure - difference(none, none, 1)).norm(),
                allowed);
    }
}
