#include <auxfem/joints/effects/rotational_springs.h>

#include <gtest/gtest.h>
#include <joints/effects/two_rotations.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A spring of 3 N m/rad between the rotations of joints 0 and 1. */
  struct SpringAlone : TwoRotations
  {
    SpringAlone()
      : springs(
          make_rotational_springs(setup.dofs(), {{{{first, second}}, 3.}}))
    {
      prepare(*springs, 0.25, 20.75);
    }

    std::unique_ptr<Effect> springs;
  };

  double sum_of_sizes(const Vector &values)
  {
    double sum = 0;
    for (const double value : values)
      sum += std::abs(value);
    return sum;
  }
} // namespace

TEST(RotationalSprings, MomentIsStiffnessTimesRelativeRotation)
{
  SpringAlone               one;
  const std::vector<double> residual =
    EvaluatedAlone(*one.springs, one.step()).residual;
  // Also after several turns.
  EXPECT_EQ(residual[one.first], -3 * 20.5);
  EXPECT_EQ(residual[one.second], 3 * 20.5);
  for (unsigned int i = 0; i < residual.size(); ++i)
    if (int(i) != one.first && int(i) != one.second)
      {
        EXPECT_EQ(residual[i], 0.);
      }
}

TEST(RotationalSprings, EnergyIsHalfOfMomentTimesRotation)
{
  SpringAlone    one;
  const Energies energies = EvaluatedAlone(*one.springs, one.step()).accept();
  EXPECT_EQ(energies.strain(), 1.5 * 20.5 * 20.5);
}

TEST(RotationalSprings, TangentIsTheStiffnessTimesItsFactor)
{
  SpringAlone  one;
  TangentAlone tangent(*one.springs, one.setup.dofs());
  tangent.fill(EvaluatedAlone(*one.springs, one.step()), {0.5, 7., 9.});

  EXPECT_TRUE(one.springs->is_linear());
  Vector unit(one.setup.dofs().layout().n_local()), column(unit);
  unit[one.second] = 1;
  tangent.matrix.multiply(unit.data(), column.data());
  EXPECT_EQ(column[one.second], 1.5);
  EXPECT_EQ(column[one.first], -1.5);
  EXPECT_EQ(sum_of_sizes(column), 3.);
  unit.assign(unit.size(), 1.);
  tangent.matrix.multiply(unit.data(), column.data());
  EXPECT_EQ(sum_of_sizes(column), 0.);
}
