#include <auxfem/equations/effects/point_masses.h>

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
      : of_scene(frame_scene("0 0; 1 0", "0 1", ""), {}, MPI_COMM_SELF)
      , y(of_scene.dofs().joint_unknown(1, 1))
      , turn(of_scene.dofs().joint_unknown(1, rotation_z))
      , masses(of_scene.dofs())
      , from(of_scene.equations.initial_state())
      , to(from)
    {
      masses.add(y, 2.);
      masses.add(turn, 5.);
      fill_by_place(of_scene.system, 3., *to.velocity);
      fill_by_place(of_scene.system, 4., *to.acceleration);
    }

    EquationsOnRanks of_scene;
    int              y, turn;
    PointMasses      masses;
    State            from, to;
  };
} // namespace

TEST(PointMasses, ForceIsMassTimesAcceleration)
{
  MassAlone           one;
  std::vector<double> residual(one.of_scene.dofs().n_local(), 0.);
  one.masses.add_residual({one.from, one.to, 1.}, residual.data());
  for (int i = 0; i < int(residual.size()); ++i)
    {
      const double mass = i == one.y ? 2. : i == one.turn ? 5. : 0.;
      EXPECT_EQ(residual[i], mass * (*one.to.acceleration)[i]);
    }
}

TEST(PointMasses, KineticEnergyIsThatOfTheMass)
{
  MassAlone    one;
  Energies     energies;
  const double v     = (*one.to.velocity)[one.y],
               omega = (*one.to.velocity)[one.turn];
  one.masses.add_energies(one.to, energies);
  EXPECT_DOUBLE_EQ(energies.kinetic(), v * v + 2.5 * omega * omega);
}

TEST(PointMasses, TangentHasTheMassOnItsDiagonal)
{
  MassAlone     one;
  TangentMatrix matrix(one.of_scene.dofs());
  one.masses.register_blocks(matrix);
  matrix.finalize();
  matrix.reset();
  one.masses.add_tangent({one.from, one.to, 1.}, {7., 9., 0.5}, matrix);
  const std::vector<double> diagonal = matrix.row_sizes();
  for (int i = 0; i < int(diagonal.size()); ++i)
    EXPECT_EQ(diagonal[i], i == one.y ? 1. : i == one.turn ? 2.5 : 0.);
  EXPECT_TRUE(one.masses.is_linear());
}

TEST(PointMasses, SeveralMassesOnOneUnknownAddUp)
{
  MassAlone one;
  one.masses.add(one.y, 1.);
  std::vector<double> residual(one.of_scene.dofs().n_local(), 0.);
  one.masses.add_residual({one.from, one.to, 1.}, residual.data());
  // 2 a + 1 a against 3 a: one rounding apart.
  EXPECT_DOUBLE_EQ(residual[one.y], 3 * (*one.to.acceleration)[one.y]);
}
