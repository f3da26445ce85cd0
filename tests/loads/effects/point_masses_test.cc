#include <auxfem/loads/effects/point_masses.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** 2 kg on the vertical displacement and 5 kg m2 on the rotation of joint 1.
   */
  struct MassAlone
  {
    MassAlone()
      : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
      , y(setup.dofs().joint_unknown(1, 1))
      , turn(setup.dofs().joint_unknown(1, rotation_z))
      , masses(make_point_masses(setup.dofs(), {{y, 2.}, {turn, 5.}}))
      , from(setup.equations.initial_state())
      , to(from)
    {
      StateLayout layout = setup.equations.layout();
      masses->register_in(layout);
      make_room(layout, from);
      make_room(layout, to);
      fill_by_position(setup.model, 3., *to.velocity);
      fill_by_position(setup.model, 4., *to.acceleration);
    }

    Evaluation step()
    {
      return Evaluation::step(from, to, 1.);
    }

    EquationsOnRanks        setup;
    int                     y, turn;
    std::unique_ptr<Effect> masses;
    State                   from, to;
  };
} // namespace

TEST(PointMasses, ForceIsMassTimesAcceleration)
{
  MassAlone                 one;
  const std::vector<double> residual =
    EvaluatedAlone(*one.masses, one.step()).residual;
  for (int i = 0; i < int(residual.size()); ++i)
    {
      const double mass = i == one.y ? 2. : i == one.turn ? 5. : 0.;
      EXPECT_EQ(residual[i], mass * (*one.to.acceleration)[i]);
    }
}

TEST(PointMasses, KineticEnergyIsThatOfTheMass)
{
  MassAlone    one;
  const double v          = (*one.to.velocity)[one.y],
               omega      = (*one.to.velocity)[one.turn];
  const Energies energies = EvaluatedAlone(*one.masses, one.step()).accept();
  EXPECT_DOUBLE_EQ(energies.kinetic(), v * v + 2.5 * omega * omega);
}

TEST(PointMasses, TangentHasTheMassOnItsDiagonal)
{
  MassAlone    one;
  TangentAlone tangent(*one.masses, one.setup.dofs());
  tangent.fill(EvaluatedAlone(*one.masses, one.step()), {7., 9., 0.5});
  const std::vector<double> diagonal = tangent.matrix.row_sizes();
  for (int i = 0; i < int(diagonal.size()); ++i)
    EXPECT_EQ(diagonal[i], i == one.y ? 1. : i == one.turn ? 2.5 : 0.);
  EXPECT_TRUE(one.masses->is_linear());
}

TEST(PointMasses, SeveralMassesOnOneUnknownAddUp)
{
  MassAlone                     one;
  const std::unique_ptr<Effect> masses =
    make_point_masses(one.setup.dofs(), {{one.y, 2.}, {one.y, 1.}});
  const std::vector<double> residual =
    EvaluatedAlone(*masses, one.step()).residual;
  // 2 a + 1 a against 3 a: one rounding apart.
  EXPECT_DOUBLE_EQ(residual[one.y], 3 * (*one.to.acceleration)[one.y]);
}
