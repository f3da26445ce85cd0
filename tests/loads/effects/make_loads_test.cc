#include <auxfem/equations/make_effects.h>

#include <deal.II/base/numbers.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <map>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** An L of two struts, 2 m along x and 1.5 m along y, and a half circle of
   * radius 1. */
  SceneText three_struts()
  {
    return frame_scene("0 0; 2 0; 2 1.5; 2 3.5", "0 1; 1 2; 2 3 1");
  }

  constexpr double total_length = 2 + 1.5 + dealii::numbers::PI;

  /** Applied forces at time @p t on the unloaded lattice, and their sums. */
  struct AppliedForces
  {
    AppliedForces(const std::string              &text,
                  const double                    t,
                  const std::vector<std::string> &overrides = {})
      : setup(text, complete(overrides), MPI_COMM_SELF)
      , forces(setup.dofs().layout().n_local())
    {
      State from = setup.equations.initial_state(), to = from;
      to.time               = t;
      const Evaluation step = setup.step(from, to, t);
      setup.residual(step);
      const auto names = name_unknowns(setup.model);
      for (unsigned int i = 0; i < names.size(); ++i)
        {
          const unsigned int c = std::get<3>(names[i].name);
          forces[i]            = -to.residual[i];
          sum[c] += forces[i];
          if (c < first_rotation)
            moment += forces[i] *
              (c == 0 ? -names[i].position[1] : names[i].position[0]);
        }
    }

    static std::vector<std::string> complete(std::vector<std::string> overrides)
    {
      overrides.push_back("Time/Scheme=static");
      return overrides;
    }

    EquationsOnRanks setup;
    Vector           forces;
    double           sum[n_motion_components] = {};
    double           moment = 0; ///< of the forces about (0, 0)
  };

  // Sums of some 50 numbers of about 10, of expressions in t as well.
  constexpr double force_round_off = 1e-13;
} // namespace

TEST(MakeLoads, AJointLoadActsOnItsJointOnlyAndFollowsTime)
{
  const AppliedForces applied(
    three_struts().add(
      "Loads/push",
      "Joints = 2 | Force x = 3 * t | Force y = -2 | Moment z = t^2"),
    0.5);
  const auto  &dofs        = applied.setup.dofs();
  const double expected[3] = {1.5, -2., 0.25};
  for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_DOUBLE_EQ(
        applied.forces[dofs.joint_unknown(2, dofs.components()[c])],
        expected[c]);
      EXPECT_DOUBLE_EQ(applied.sum[dofs.components()[c]], expected[c]);
    }
}

TEST(MakeLoads, LoadsOfOneJointAddUp)
{
  const AppliedForces applied(three_struts()
                                .add("Loads/push", "Joints = 2 | Force x = 3")
                                .add("Loads/pull",
                                     "Joints = 1, 2 | Force x = 0.5"),
                              1.);
  const auto         &dofs = applied.setup.dofs();
  EXPECT_DOUBLE_EQ(applied.forces[dofs.joint_unknown(2, 0)], 3.5);
  EXPECT_DOUBLE_EQ(applied.forces[dofs.joint_unknown(1, 0)], 0.5);
}

TEST(MakeLoads, ALineLoadSumsToForcePerLengthTimesLength)
{
  const SceneText text = three_struts().add(
    "Loads/wind",
    "Type = line | Struts = all | Force per length x = 4 * t | "
    "Force per length y = -1");
  for (const char *order : {"1", "2", "3", "4", "5", "6"})
    for (const char *refinements : {"0", "2"})
      {
        const AppliedForces applied(
          text,
          0.5,
          {std::string("Discretization/Order=") + order,
           std::string("Discretization/Global refinements=") + refinements});
        EXPECT_NEAR(applied.sum[0], 2 * total_length, force_round_off);
        EXPECT_NEAR(applied.sum[1], -total_length, force_round_off);
        EXPECT_NEAR(applied.sum[2], 0., force_round_off);
      }
}

TEST(MakeLoads, ALineLoadActsInTheMiddleOfItsStrut)
{
  const AppliedForces applied(
    three_struts().add("Loads/wind",
                       "Type = line | Struts = 1 | Force per length x = 4"),
    1.);
  EXPECT_NEAR(applied.sum[0], 4 * 1.5, force_round_off);
  EXPECT_NEAR(applied.moment, -4 * 1.5 * 0.75, force_round_off);
  EXPECT_EQ(applied.forces[applied.setup.dofs().joint_unknown(0, 0)], 0.);
}

TEST(MakeLoads, GravityPullsStrutsAndPointMasses)
{
  const SceneText text =
    three_struts()
      .add("Gravity", "Acceleration x = 2 | Acceleration y = -10")
      .mass("weights", "1, 3", 0.4, 5);
  const double        mass = 0.5 * 3 * total_length + 2 * 0.4;
  const AppliedForces applied(text, 1.);
  EXPECT_NEAR(applied.sum[0], 2 * mass, 10 * force_round_off);
  EXPECT_NEAR(applied.sum[1], -10 * mass, 10 * force_round_off);
  EXPECT_NEAR(applied.sum[2], 0., force_round_off);

  const AppliedForces off(text, 1., {"Effects/Gravity=off"});
  EXPECT_EQ(off.sum[1], 0.);
}

TEST(MakeLoads, ASceneWithoutLoadsHasNone)
{
  const EquationsOnRanks setup(three_struts(), {}, MPI_COMM_SELF);
  EXPECT_TRUE(make_loads(setup.model).empty());
}

TEST(MakeLoads, InitialVelocitiesAreThoseOfARigidBody)
{
  const EquationsOnRanks setup(
    three_struts().add("Initial velocities/spin",
                       "Joints = all | Velocity x = 3 | Velocity y = -1 | "
                       "Angular velocity z = 2"),
    {"Discretization/Order=4", "Discretization/Global refinements=1"},
    MPI_COMM_SELF);
  const State  state     = setup.equations.initial_state();
  const double centre[2] = {(0. + 2 + 2 + 2) / 4, (0. + 0 + 1.5 + 3.5) / 4};
  const auto   names     = name_unknowns(setup.model);
  for (unsigned int i = 0; i < names.size(); ++i)
    {
      const double x = names[i].position[0] - centre[0],
                   y = names[i].position[1] - centre[1];
      const std::map<unsigned int, double> expected = {{0, 3 - 2 * y},
                                                       {1, -1 + 2 * x},
                                                       {rotation_z, 2.}};
      EXPECT_NEAR((*state.velocity)[i],
                  expected.at(std::get<3>(names[i].name)),
                  force_round_off);
    }
  EXPECT_EQ(state.displacement[5], 0.);
}

TEST(MakeLoads, StrutsMoveAlongOnlyIfBothEndsDo)
{
  const EquationsOnRanks setup(
    three_struts().add("Initial velocities/impact",
                       "Joints = 0, 1 | Velocity y = -1"),
    {},
    MPI_COMM_SELF);
  const State state = setup.equations.initial_state();
  const auto  names = name_unknowns(setup.model);
  for (unsigned int i = 0; i < names.size(); ++i)
    {
      const auto &[at_joint, index, fraction, component] = names[i].name;
      const bool moves = at_joint ? index <= 1 : index == 0;
      EXPECT_EQ((*state.velocity)[i], moves && component == 1 ? -1. : 0.);
    }
}
