#include <auxfem/equations/make_effects.h>

#include <equations/space_effect.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** 0.4 kg on joint 1; 0.5 kg with rotary inertia on joints 1 and 2. */
  const SceneText masses =
    SceneText().mass("first", "1", 0.4).mass("second", "1, 2", 0.5, 0.1);

  /** Inertia forces of the masses alone under acceleration 1 everywhere. */
  std::vector<double> under_unit_acceleration(const EquationsOnRanks &setup)
  {
    State from = setup.equations.initial_state(), to = from;
    to.acceleration->assign(to.acceleration->size(), 1.);
    const Evaluation    step = Evaluation::step(from, to, 1.);
    std::vector<double> residual(setup.dofs().layout().n_local(), 0.);
    for (const auto &effect : make_masses(setup.model))
      effect->add_residual(step, residual.data(), effect->make_results().get());
    return residual;
  }
} // namespace

TEST(MakeMasses, MassesOfOneJointAddUpInThePlane)
{
  const EquationsOnRanks    setup(frame_scene("0 0; 2 0; 2 1.5",
                                           "0 1; 1 2",
                                           masses),
                               {},
                               MPI_COMM_SELF);
  const auto               &dofs = setup.dofs();
  const std::vector<double> sums = under_unit_acceleration(setup);
  EXPECT_DOUBLE_EQ(sums[dofs.joint_unknown(1, 0)], 0.9);
  EXPECT_DOUBLE_EQ(sums[dofs.joint_unknown(1, 1)], 0.9);
  EXPECT_DOUBLE_EQ(sums[dofs.joint_unknown(1, rotation_z)], 0.1);
  EXPECT_DOUBLE_EQ(sums[dofs.joint_unknown(2, 0)], 0.5);
  EXPECT_EQ(sums[dofs.joint_unknown(0, 0)], 0.);
}

TEST(MakeMasses, MassesOfOneJointAddUpInSpace)
{
  const EquationsOnRanks    setup(space_frame("0 0 0; 2 0 1; 2 1.5 0",
                                           "0 1; 1 2",
                                           masses),
                               {},
                               MPI_COMM_SELF);
  const auto               &dofs = setup.dofs();
  const std::vector<double> sums = under_unit_acceleration(setup);
  for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_DOUBLE_EQ(sums[dofs.joint_unknown(1, c)], 0.9);
      EXPECT_DOUBLE_EQ(sums[dofs.joint_unknown(1, first_rotation + c)], 0.1);
    }
}

TEST(MakeMasses, RotaryInertiaNeedsARotation)
{
  // A joint on which no strut ends has displacements only.
  const SceneText lonely =
    frame_scene("0 0; 2 0; 5 5", "0 1").mass("lump", "2", 1, 0.1);
  expect_parts(input_error_of(
                 [&] { EquationsOnRanks(lonely, {}, MPI_COMM_SELF); }),
               {"Masses/lump/Rotary inertia", "joint 2", "no rotation"});
}
