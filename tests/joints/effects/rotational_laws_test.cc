#include <auxfem/joints/effects/rotational_springs.h>

#include <connectors/law_on_trial.h>
#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A law between the rotations of joints 0 and 1, turned by 0.5 rad against
   * each other. */
  struct LawAlone
  {
    LawAlone(const std::string &law, const LawParameters &parameters)
      : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
      , first(setup.dofs().joint_unknown(0, rotation_z))
      , second(setup.dofs().joint_unknown(1, rotation_z))
      , laws(make_rotational_laws(setup.dofs(),
                                  "knee",
                                  make_law(law, parameters),
                                  {{{{first, second}}, 0}},
                                  {0}))
      , from(setup.equations.initial_state())
      , to(from)
    {
      StateLayout layout = setup.equations.layout();
      laws->register_in(layout);
      make_room(layout, from);
      make_room(layout, to);
      to.displacement[first]  = 0.25;
      to.displacement[second] = 0.75;
    }

    Evaluation step()
    {
      return Evaluation::step(from, to, 1.);
    }

    EquationsOnRanks        setup;
    int                     first, second;
    std::unique_ptr<Effect> laws;
    State                   from, to;
  };
} // namespace

TEST(RotationalLaws, MomentAndTangentOfTheLaw)
{
  LawAlone one("cubic", {{"Spring stiffness", "3"}, {"Cubic stiffness", "2"}});
  const EvaluatedAlone evaluated(*one.laws, one.step());
  EXPECT_DOUBLE_EQ(evaluated.residual[one.first], -1.75);
  EXPECT_DOUBLE_EQ(evaluated.residual[one.second], 1.75);
  EXPECT_FALSE(one.laws->is_linear());

  TangentAlone tangent(*one.laws, one.setup.dofs());
  tangent.fill(evaluated, {0.5, 7., 9.});
  Vector unit(one.setup.dofs().layout().n_local()), column(unit);
  unit[one.second] = 1;
  tangent.matrix.multiply(unit.data(), column.data());
  EXPECT_DOUBLE_EQ(column[one.second], 0.5 * 4.5);
  EXPECT_DOUBLE_EQ(column[one.first], -0.5 * 4.5);
  EXPECT_DOUBLE_EQ(evaluated.accept().strain(), 3 * 0.125 + 0.5 * 0.0625);
}

TEST(RotationalLaws, FrictionLosesEnergy)
{
  LawAlone             one("friction-slider",
               {{"Spring stiffness", "10"}, {"Slip force", "2"}});
  const EvaluatedAlone evaluated(*one.laws, one.step());
  EXPECT_DOUBLE_EQ(evaluated.residual[one.second], 2);
  const Energies energies = evaluated.accept();
  EXPECT_DOUBLE_EQ(energies.strain(), 0.2);
  EXPECT_DOUBLE_EQ(energies.dissipated(), 2 * 0.3);
}
