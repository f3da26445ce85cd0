#include <auxfem/joints/effects/rotational_springs.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A spring of 3 N m/rad between the rotations of joints 0 and 1. */
  struct SpringAlone
  {
    SpringAlone()
      : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
      , first(setup.dofs().joint_unknown(0, rotation_z))
      , second(setup.dofs().joint_unknown(1, rotation_z))
      , springs(
          make_rotational_springs(setup.dofs(), {{{{first, second}}, 3.}}))
      , from(setup.equations.initial_state())
      , to(from)
    {
      StateLayout layout = setup.equations.layout();
      springs->register_in(layout);
      make_room(layout, from);
      make_room(layout, to);
      to.displacement[first]  = 0.25;
      to.displacement[second] = 20.75;
    }

    Evaluation step()
    {
      return Evaluation::step(from, to, 1.);
    }

    EquationsOnRanks        setup;
    int                     first, second;
    std::unique_ptr<Effect> springs;
    State                   from, to;
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
