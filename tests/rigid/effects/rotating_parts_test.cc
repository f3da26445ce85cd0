#include <auxfem/model/unknown_records.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <equations/space_effect.h>
#include <mesh/cell_from_text.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <array>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SceneText rigid(const std::string &struts,
                  const double       mass,
                  const std::string &entries = "")
  {
    return SceneText()
      .rigid_part("body", struts, mass)
      .add("Rigid parts/body", entries);
  }

  const std::string clamped = "Elastic struts = clamped";

  /** A body of joints 0 to 3, a bar of three joints from joint 3 on, and
   * elastic struts to joint 4, clamped to the body. */
  const std::string body_and_bar =
    space_frame("0 0 0; 2 0.3 0.1; 1.6 1.1 -0.4; 0.2 1.4 0.9; 3 2 0.5; "
                "0.7 2.4 1.4; 1.2 3.4 1.9",
                "0 1; 1 2; 0 3; 2 4; 3 4; 3 5; 5 6",
                rigid("0, 1, 2", 3, clamped).rigid_part("bar", "5, 6", 2));

  struct BodyAndBar : SpaceEffect
  {
    explicit BodyAndBar(const bool large_rotation)
      : SpaceEffect(body_and_bar, large_rotation)
      , constraints(make_rigid_part_constraints(
          rigid_bodies(setup.lattice, setup.dofs()),
          {setup.lattice, setup.dofs(), large_rotation, {}, {}}))
    {}

    std::unique_ptr<RigidPartGroup> constraints;
  };

  const SceneText gravity_down =
    SceneText().set("Gravity/Acceleration z", -9.81);
} // namespace

TEST(RotatingParts, ConstraintsAreThreeAJointAndThoseOfABar)
{
  const EquationsOnRanks setup(body_and_bar, {}, MPI_COMM_SELF);
  EXPECT_TRUE(setup.lattice.rigid_parts.at(0).has_rotation);
  EXPECT_FALSE(setup.lattice.rigid_parts.at(1).has_rotation);
  EXPECT_EQ(setup.dofs().constraints().n_multipliers(0), 12u);
  // 3 joints have 5 of 9 degrees of freedom left.
  EXPECT_EQ(setup.dofs().constraints().n_multipliers(1), 4u);
}

TEST(RotatingParts, ClampedStrutsHaveTheRotationOfTheBody)
{
  const EquationsOnRanks setup(body_and_bar, {}, MPI_COMM_SELF);
  const auto            &dofs = setup.dofs();
  for (unsigned int c = 3; c < 6; ++c)
    {
      EXPECT_EQ(dofs.end_rotation(3, 0, c), dofs.constraints().motion(0, c));
      EXPECT_EQ(dofs.end_rotation(4, 0, c), dofs.constraints().motion(0, c));
      EXPECT_EQ(dofs.joint_unknown(1, c), dofs.constraints().motion(0, c));
      EXPECT_NE(dofs.joint_unknown(4, c), dofs.constraints().motion(0, c));
      EXPECT_FALSE(dofs.joint_has(6, c));
    }
  EXPECT_EQ(describe(dofs, dofs.constraints().motion(0, 4)),
            "rotation about y of the rigid part of joints 0 1 2 3");
}

TEST(RotatingParts, TangentIsThatOfDifferences)
{
  for (const bool large_rotation : {true, false})
    {
      BodyAndBar parts(large_rotation);
      parts.expect_tangent(*parts.constraints, {1., 3., 5.});
      EXPECT_EQ(parts.constraints->is_linear(), !large_rotation);
    }
}

TEST(RotatingParts, ForcesAreDerivativesOfTheConstraints)
{
  for (const bool large_rotation : {true, false})
    {
      BodyAndBar parts(large_rotation);
      parts.expect_forces_by_constraints(*parts.constraints);
    }
}

TEST(RotatingParts, RatesAreThoseOfTheConstraints)
{
  for (const bool large_rotation : {true, false})
    {
      BodyAndBar parts(large_rotation);
      parts.expect_time_derivatives(*parts.constraints);
    }
}

TEST(RotatingParts, MotionOfItsJointsIsThatOfTheBody)
{
  BodyAndBar  parts(true);
  const auto &dofs = parts.setup.dofs();
  // Joints at positions that satisfy the constraints.
  const auto rows = parts.residual(*parts.constraints, parts.to);
  for (unsigned int k = 0; k < 4; ++k)
    {
      const unsigned int joint = parts.setup.lattice.rigid_parts[0].joints[k];
      const PointMotion  motion =
        parts.constraints->motion(0,
                                  parts.setup.lattice.joints[joint],
                                  parts.to);
      for (unsigned int c = 0; c < 3; ++c)
        EXPECT_NEAR(motion.displacement[c],
                    parts.to.displacement[dofs.joint_unknown(joint, c)] -
                      rows[dofs.constraints().multiplier(0, 3 * k + c)],
                    1e-13);
    }
}

TEST(RotatingParts, AHangingBodyIsHeldByItsWeight)
{
  // A tripod of three legs of 2 m, suspended at its ends.
  SceneRun run(SceneText()
                 .dimension(3)
                 .frame("0 0 0; 1 0 1; -1 1 1; -1 -1 1", "0 1; 0 2; 0 3")
                 .add(rigid("all", 3))
                 .support("ceiling", "1", "pin")
                 .add("Supports/slide",
                      "Joints = 2 | Type = prescribed | Displacement z = 0 | "
                      "Displacement x = 0")
                 .add("Supports/rest",
                      "Joints = 3 | Type = prescribed | Displacement z = 0")
                 .add(gravity_down)
                 .time(1, 1, "static"));
  run.run();
  const auto report =
    run.equations.reporting().rigid_parts->report(0, run.state);
  const auto  &part    = run.lattice.rigid_parts[0];
  const double lengths = std::sqrt(2.) + 2 * std::sqrt(3.);
  // Moments about y: the centre of mass is at x = (sqrt 2 - 2 sqrt 3) / 2 of
  // all lengths; supports at 1 and -1.
  const double centre = (std::sqrt(2.) - 2 * std::sqrt(3.)) / 2 / lengths;
  const double weight = 3 * 9.81;
  for (unsigned int k = 0; k < 4; ++k)
    {
      const unsigned int joint    = part.joints[k];
      const double       expected = joint == 0 ? 0.
              : joint == 1                     ? weight * (1 + centre) / 2
                                               : weight * (1 - centre) / 4;
      EXPECT_NEAR(report.forces[k][2], expected, 1e-11) << joint;
      EXPECT_NEAR(report.forces[k][0], 0, 1e-11);
      EXPECT_NEAR(report.forces[k][1], 0, 1e-11);
    }
}

TEST(RotatingParts, LoadsOnRigidStrutsAndMomentsActAtTheirPlace)
{
  // An L in the x-y plane, only its leg along y loaded, and a moment about z;
  // free in space.
  for (const char *large_rotation : {"on", "off"})
    {
      SceneRun    run(SceneText()
                     .dimension(3)
                     .frame("0 0 0; 2 0 0; 2 1 0", "0 1; 1 2")
                     .add(rigid("all", 6, "Rotary inertia = 2 3 4"))
                     .add("Loads/line",
                          "Type = line | Struts = 1 | Force per length z = 12")
                     .add("Loads/turn", "Joints = 0 | Moment z = 8")
                     .time(1, 0.1),
                   {std::string("Effects/Large rotation=") + large_rotation});
      const auto &dofs = run.model.numbering;
      const auto &part = run.lattice.rigid_parts[0];
      // The resultant of 12 N acts at (2, 0.5).
      const double x          = 2 - part.centre_of_mass[0],
                   y          = 0.5 - part.centre_of_mass[1];
      const auto acceleration = [&](const unsigned int c) {
        return (*run.state.acceleration)[dofs.constraints().motion(0, c)];
      };
      EXPECT_NEAR(acceleration(2), 12. / 6, 1e-13);
      EXPECT_NEAR(acceleration(3), 12 * y / 2, 1e-13);
      EXPECT_NEAR(acceleration(4), -12 * x / 3, 1e-13);
      EXPECT_NEAR(acceleration(5), 8. / 4, 1e-13);
    }
}

TEST(RotatingParts, TwoClampingBodiesAtAJointAreRefused)
{
  const std::string message = input_error_of([] {
    const EquationsOnRanks setup(space_frame("0 0 0; 1 0 0; 2 0 1; 1 1 0",
                                             "0 1; 1 2; 1 3",
                                             rigid("0", 1, clamped)
                                               .add("Rigid parts/other",
                                                    "Struts = 1 | " + clamped)),
                                 {},
                                 MPI_COMM_SELF);
  });
  EXPECT_TRUE(contains(message, "Rigid parts/other/Elastic struts = clamped"))
    << message;
  EXPECT_TRUE(contains(message, "joint 1")) << message;
}
