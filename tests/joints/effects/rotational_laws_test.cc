#include <auxfem/joints/effects/rotational_springs.h>

#include <connectors/law_on_trial.h>
#include <gtest/gtest.h>
#include <joints/effects/two_rotations.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A law between the rotations of joints 0 and 1, turned by 0.5 rad against
   * each other. */
  struct LawAlone : TwoRotations
  {
    LawAlone(const std::string &law, const LawParameters &parameters)
      : laws(make_rotational_laws(setup.dofs(),
                                  "knee",
                                  make_law(law, parameters),
                                  {{{first, second}}},
                                  {0}))
    {
      prepare(*laws, 0.25, 0.75);
    }

    std::unique_ptr<Effect> laws;
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
