#include <auxfem/mathematics/rotation.h>

#include <gtest/gtest.h>
#include <mathematics/sample_rotation.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  // A few roundings of numbers of about one.
  constexpr double rotation_round_off = 2e-15;

  const SpaceVector some_axis({2. / 7, -3. / 7, 6. / 7});
  const SpaceVector some_vector({0.3, 1.1, -0.7});

  SpaceVector column(const SpaceTensor &matrix, const int j)
  {
    return SpaceVector({matrix[0][j], matrix[1][j], matrix[2][j]});
  }

  /** Rodrigues' formula. */
  SpaceVector rotated_by_formula(const SpaceVector &axis,
                                 const double       angle,
                                 const SpaceVector &v)
  {
    return std::cos(angle) * v +
      std::sin(angle) * dealii::cross_product_3d(axis, v) +
      (1 - std::cos(angle)) * (axis * v) * axis;
  }
} // namespace

TEST(Rotation, ExponentialTurnsByAngleAboutAxis)
{
  for (const double angle : {0., 1e-9, 0.4, 3.1, pi, 5., -2.})
    EXPECT_LT(
      distance_between(rotated(exponential(angle * some_axis), some_vector),
                       rotated_by_formula(some_axis, angle, some_vector)),
      rotation_round_off)
      << "angle " << angle;
}

TEST(Rotation, ExponentialIsTwoValuedBeyondOneTurn)
{
  const Quaternion q    = exponential(0.7 * some_axis),
                   next = exponential((0.7 + 2 * pi) * some_axis);
  EXPECT_NEAR(next.scalar, -q.scalar, rotation_round_off);
  EXPECT_LT(distance_between(next.vector, -q.vector), rotation_round_off);
}

TEST(Rotation, RotationVectorInvertsTheExponential)
{
  for (const double angle :
       {1e-300, 1e-160, 1e-12, 1e-5, 0.4, 2., pi - 1e-5, pi - 1e-12})
    {
      const SpaceVector v = angle * some_axis;
      // The tolerance of the smallest angle is denormal and counts as zero.
      EXPECT_LE(distance_between(rotation_vector(exponential(v)), v),
                rotation_round_off * angle)
        << "angle " << angle;
      EXPECT_LE(distance_between(rotation_vector(-1 * exponential(v)), v),
                rotation_round_off * angle)
        << "angle " << angle;
    }
  EXPECT_EQ(rotation_vector(Quaternion()).norm(), 0);
  EXPECT_EQ(rotation_vector(Quaternion{-1, {}}).norm(), 0);
}

TEST(Rotation, RotationVectorIsTheShorterOnePastAHalfTurn)
{
  const double excess = 1e-7;
  EXPECT_LT(distance_between(rotation_vector(
                               exponential((pi + excess) * some_axis)),
                             (excess - pi) * some_axis),
            rotation_round_off);
  EXPECT_NEAR(rotation_vector(exponential(pi * some_axis)).norm(),
              pi,
              rotation_round_off);
}

TEST(Rotation, ProductComposes)
{
  const Quaternion first  = exponential(1.2 * some_axis),
                   second = exponential(SpaceVector({0.2, 2., -0.9}));
  EXPECT_LT(distance_between(rotated(second * first, some_vector),
                             rotated(second, rotated(first, some_vector))),
            rotation_round_off);
  EXPECT_LT(distance_between(rotated(conjugate(first),
                                     rotated(first, some_vector)),
                             some_vector),
            rotation_round_off);
}

TEST(Rotation, ProductOfManyKeepsUnitNormWhenNormalized)
{
  const Quaternion step = exponential(0.01 * some_axis);
  Quaternion       q;
  for (int i = 0; i < 1000; ++i)
    q = normalized(step * q);
  EXPECT_NEAR(dot(q, q), 1, rotation_round_off);
  // One rounding a step.
  EXPECT_LT(distance_between(rotated(q, some_vector),
                             rotated_by_formula(some_axis, 10, some_vector)),
            1000 * rotation_round_off);
}

TEST(Rotation, ChangeOfAVectorIsAccurateForTinyAngles)
{
  const double angle = 1e-20;
  EXPECT_LT(distance_between(rotation_change(exponential(angle * some_axis),
                                             some_vector) /
                               angle,
                             dealii::cross_product_3d(some_axis, some_vector)),
            rotation_round_off);
}

TEST(Rotation, FrameIsRotatedColumnByColumn)
{
  const Quaternion  q = exponential(2.5 * some_axis);
  const SpaceTensor frame =
    section_frame(some_vector, default_reference(some_vector));
  for (int j = 0; j < 3; ++j)
    EXPECT_LT(distance_between(column(rotated(q, frame), j),
                               rotated(q, column(frame, j))),
              rotation_round_off);
}

TEST(Rotation, CrossProductTensorMultiplies)
{
  EXPECT_LT(distance_between(cross_product_tensor(some_axis) * some_vector,
                             dealii::cross_product_3d(some_axis, some_vector)),
            rotation_round_off);
}

TEST(Rotation, TensorHasItsPrincipalValuesAlongTheAxes)
{
  const SpaceTensor frame =
    section_frame(some_vector, default_reference(some_vector));
  const SpaceVector values({3., -1., 0.5});
  const SpaceTensor tensor = with_principal_values(frame, values);
  for (int j = 0; j < 3; ++j)
    EXPECT_LT(distance_between(tensor * column(frame, j),
                               values[j] * column(frame, j)),
              3 * rotation_round_off);
}

TEST(Rotation, SectionFrameIsRightHandedWithAxisThreeTowardsTheReference)
{
  const SpaceVector reference({0.1, -2, 0.4});
  const SpaceTensor frame = section_frame(some_vector, reference);
  for (int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(column(frame, j).norm(), 1, rotation_round_off);
      EXPECT_LT(distance_between(dealii::cross_product_3d(column(frame, j),
                                                          column(frame,
                                                                 (j + 1) % 3)),
                                 column(frame, (j + 2) % 3)),
                rotation_round_off);
    }
  EXPECT_LT(distance_between(column(frame, 0),
                             some_vector / some_vector.norm()),
            rotation_round_off);
  EXPECT_NEAR(column(frame, 1) * reference, 0, rotation_round_off);
  EXPECT_GT(column(frame, 2) * reference, 0);
}

TEST(Rotation, SectionFrameTurnsByThePrincipalAngle)
{
  const SpaceVector along({0.6, 0.8, 0});
  const SpaceTensor drawn = section_frame(along, SectionOrientation()),
                    principal =
                      section_frame(along, SectionOrientation{{}, 0.4});
  const Quaternion turn = exponential(0.4 * along);
  for (int j = 0; j < 3; ++j)
    EXPECT_LT(distance_between(column(principal, j),
                               rotated(turn, column(drawn, j))),
              rotation_round_off);
}

TEST(Rotation, DefaultFrameOfAPlanarStrutHasAxisThreeAlongZ)
{
  const SpaceVector along({0.6, 0.8, 0});
  const SpaceTensor frame = section_frame(along, default_reference(along));
  EXPECT_LT(distance_between(column(frame, 1), SpaceVector({-0.8, 0.6, 0})),
            rotation_round_off);
  EXPECT_LT(distance_between(column(frame, 2), SpaceVector({0, 0, 1})),
            rotation_round_off);
}

TEST(Rotation, DefaultReferenceOfAVerticalStrutIsX)
{
  const auto leaning = [](const double degrees) {
    return SpaceVector(
      {0., std::sin(degrees * pi / 180), -std::cos(degrees * pi / 180)});
  };
  for (const double degrees : {0., 4.9})
    EXPECT_EQ(default_reference(3. * leaning(degrees))[0], 1) << degrees;
  for (const double degrees : {5.1, 90.})
    EXPECT_EQ(default_reference(3. * leaning(degrees))[2], 1) << degrees;
}

TEST(Rotation, NearlyParallelCountsOppositeDirectionsAndIgnoresLength)
{
  EXPECT_TRUE(nearly_parallel(some_axis, -100. * some_axis));
  EXPECT_FALSE(nearly_parallel(some_axis, some_vector));
}
