#include <auxfem/joints/effects/rotational_springs.h>

#include <connectors/law_on_trial.h>
#include <equations/space_effect.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string axis_knee_entries =
    "Joints = 1 | Struts = 1 | "
    "Type = rotational cubic | "
    "Spring stiffness = 3 | Cubic stiffness = 2";

  const std::string axis_knee =
    space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2",
                "0 1; 1 2",
                SceneText().add("Joints/knee",
                                axis_knee_entries + " | Axis = 1 2 -2"));

  const SpaceVector knee_axis({1. / 3, 2. / 3, -2. / 3});

  constexpr double axis_angle = 0.7;

  /** The law of the knee alone, or one to the ground, turned by the axis_angle
   * about the axis, which has turned as well. */
  struct KneeLaw : SpaceEffect
  {
    KneeLaw(const bool to_ground, const bool large_rotation)
      : SpaceEffect(axis_knee, large_rotation)
    {
      const auto &dofs = setup.dofs();
      AxisPair    pair{{{-1, -1, -1}}, {}, knee_axis, 0};
      for (unsigned int c = 0; c < 3; ++c)
        {
          if (!to_ground)
            pair.base[c] = dofs.end_rotation(0, 1, 3 + c);
          pair.end[c] = dofs.end_rotation(1, 0, 3 + c);
        }
      base =
        to_ground || !large_rotation ? -1 : dofs.rotations().with(pair.base[0]);
      end = dofs.rotations().with(pair.end[0]);
      law = make_axis_laws(dofs,
                           large_rotation,
                           "knee",
                           make_law("cubic",
                                    {{"Spring stiffness", "3"},
                                     {"Cubic stiffness", "2"}}),
                           {pair});
      make_room_for(*law);
      if (large_rotation)
        turn(to, axis_angle);
    }

    /** Turns the end by @p angle about the axis against the base. */
    void turn(State &state, const double angle) const
    {
      state.rotations[end] = (base < 0 ? Quaternion() : state.rotations[base]) *
        exponential(angle * knee_axis);
    }

    std::unique_ptr<Effect> law;
    int                     base, end;
  };
} // namespace

TEST(AxisLaws, MomentsActAboutTheAxis)
{
  KneeLaw                   one(false, true);
  const std::vector<double> rows = one.residual(*one.law, one.to);
  const SpaceVector moment = (3 * axis_angle + 2 * std::pow(axis_angle, 3)) *
    rotated(one.to.rotations[one.base], knee_axis);
  for (unsigned int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(rows[one.setup.dofs().end_rotation(1, 0, 3 + c)],
                  moment[c],
                  1e-12);
      EXPECT_NEAR(rows[one.setup.dofs().end_rotation(0, 1, 3 + c)],
                  -moment[c],
                  1e-12);
    }
}

TEST(AxisLaws, TangentIsThatOfDifferences)
{
  for (const bool large_rotation : {true, false})
    for (const bool to_ground : {false, true})
      {
        KneeLaw one(to_ground, large_rotation);
        one.expect_tangent(*one.law, {1., 3., 5.});
      }
}

TEST(AxisLaws, TurnsAreCountedWhileBothTumble)
{
  KneeLaw            one(false, true);
  State              before  = one.from;
  const unsigned int n_steps = 100;
  const double       end     = 20;
  for (unsigned int step = 1; step <= n_steps; ++step)
    {
      const double part       = double(step) / n_steps;
      State        now        = before;
      now.rotations[one.base] = exponential(SpaceVector({0, 0, 30 * part})) *
        exponential(SpaceVector({std::sin(17 * part), 25 * part, 0}));
      one.turn(now, end * part);
      const Energies energies =
        EvaluatedAlone(*one.law, Evaluation::step(before, now, 1.)).accept();
      const double square = std::pow(end * part, 2);
      EXPECT_NEAR(energies.strain(),
                  1.5 * square + 0.5 * square * square,
                  1e-8 * (1 + square * square));
      before = now;
    }
}

TEST(AxisLaws, InSpaceTheAxisIsRequired)
{
  expect_parts(input_error_of([] {
                 EquationsOnRanks(
                   space_frame("0 0 0; 1 0 0; 1.5 0.9 0.2",
                               "0 1; 1 2",
                               SceneText().add("Joints/knee",
                                               axis_knee_entries)),
                   {},
                   MPI_COMM_SELF);
               }),
               {"Joints/knee/Axis", "0 0 1", "rotational spring"});
}
