#include <auxfem/model/unknown_records.h>
#include <auxfem/rigid/effects/rigid_part_group.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A rigid part of 4 joints, three of them off its base line, with elastic
   * struts to joint 4, clamped to it at joints 2 and 3. */
  const SceneText plate =
    frame_scene("0 0; 2 0.3; 1.6 1.1; 0.2 1.4; 3 2", "0 1; 1 2; 0 3; 2 4; 3 4")
      .add("Rigid parts/plate",
           "Struts = 0, 1, 2 | Mass = 3 | Elastic struts = clamped")
      .mesh(1);

  /** The constraints of the plate alone, in an irregular motion. */
  struct PlateConstraints
  {
    explicit PlateConstraints(const bool large_rotation)
      : setup(plate, {}, MPI_COMM_SELF)
      , constraints(make_rigid_part_constraints(
          rigid_bodies(setup.lattice, setup.dofs()),
          {setup.lattice, setup.dofs(), large_rotation, {}, {}}))
      , tangent(*constraints, setup.dofs())
      , from(setup.equations.initial_state())
      , to(from)
      , n(setup.dofs().layout().n_global())
    {
      for (unsigned int i = 0; i < n; ++i)
        {
          to.displacement[i]    = 1.5 * std::sin(1 + 2.3 * i);
          (*to.velocity)[i]     = 0.8 * std::sin(2 + 1.7 * i);
          (*to.acceleration)[i] = 1.1 * std::sin(3 + 1.1 * i);
        }
    }

    bool is_multiplier(const unsigned int i) const
    {
      return setup.dofs().unknowns().kinds[i] == UnknownKind::multiplier;
    }

    EvaluatedAlone evaluated()
    {
      return {*constraints, Evaluation::step(from, to, 1.)};
    }

    std::vector<double> residual()
    {
      return evaluated().residual;
    }

    /** Residual of the instant `to`. */
    std::vector<double> residual_of_rates()
    {
      return EvaluatedAlone(*constraints,
                            Evaluation::consistent_rates(from, to))
        .residual;
    }

    /** lambda . g with displacement @p i at @p value and the rest of the motion
     * unchanged. */
    double virtual_work(const unsigned int i, const double value)
    {
      const double kept                = to.displacement[i];
      to.displacement[i]               = value;
      const std::vector<double> rows   = residual();
      double                    result = 0;
      for (unsigned int k = 0; k < n; ++k)
        if (is_multiplier(k))
          result += to.displacement[k] * rows[k];
      to.displacement[i] = kept;
      return result;
    }

    std::vector<double> tangent_times(const std::vector<double> &direction)
    {
      tangent.fill(evaluated(), {1., 3., 5.});
      return tangent.times(direction);
    }

    std::vector<double> direction() const
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < n; ++i)
        result.push_back(std::sin(0.5 + 1.9 * i));
      return result;
    }

    void move(const std::vector<double> &direction, const double size)
    {
      for (unsigned int i = 0; i < n; ++i)
        to.displacement[i] += size * direction[i];
    }

    EquationsOnRanks                setup;
    std::unique_ptr<RigidPartGroup> constraints;
    TangentAlone                    tangent;
    State                           from, to;
    const unsigned int              n;
  };

  /** A bar of 2 m and 3 kg from joint 0, at the origin, to @p end. */
  SceneText bar(const std::string &end, const SceneText &further)
  {
    return SceneText()
      .frame("0 0; " + end, "0 1")
      .rigid_part("bar", "all", 3)
      .add(further);
  }

  const SceneText pivot = SceneText().support("pivot", "0", "pin");

  const SceneText gravity = SceneText().set("Gravity/Acceleration y", -9.81);
} // namespace

TEST(RigidPartConstraints, ThePlateHasOneConstraintPerRemovedDegreeOfFreedom)
{
  PlateConstraints plate(true);
  unsigned int     n_multipliers = 0;
  for (unsigned int i = 0; i < plate.n; ++i)
    n_multipliers += plate.is_multiplier(i);
  // 4 joints have 3 of 8 degrees of freedom left, two sections rotate with the
  // part.
  EXPECT_EQ(n_multipliers, 7u);
}

TEST(RigidPartConstraints, ForcesAreDerivativesOfTheConstraints)
{
  for (const bool large_rotation : {true, false})
    {
      PlateConstraints          plate(large_rotation);
      const std::vector<double> rows = plate.residual();
      const double              h    = 1e-5;
      for (unsigned int i = 0; i < plate.n; ++i)
        {
          if (plate.is_multiplier(i))
            continue;
          const double here = plate.to.displacement[i];
          // Third derivatives of about 5 m and N: h^2; round-off 1e-15 / h.
          EXPECT_NEAR(rows[i],
                      (plate.virtual_work(i, here + h) -
                       plate.virtual_work(i, here - h)) /
                        (2 * h),
                      2e-9)
            << describe(plate.setup.dofs(), i);
        }
    }
}

TEST(RigidPartConstraints, TangentIsThatOfDifferencesAtALargeRotation)
{
  for (const bool large_rotation : {true, false})
    {
      PlateConstraints          plate(large_rotation);
      const std::vector<double> direction = plate.direction(),
                                product   = plate.tangent_times(direction);
      const double h                      = 1e-5;
      plate.move(direction, h);
      const std::vector<double> forward = plate.residual();
      plate.move(direction, -2 * h);
      const std::vector<double> backward = plate.residual();
      double                    size     = 0;
      for (const double value : product)
        size = std::max(size, std::abs(value));
      for (unsigned int i = 0; i < plate.n; ++i)
        EXPECT_NEAR(product[i],
                    (forward[i] - backward[i]) / (2 * h),
                    1e-8 * size)
          << describe(plate.setup.dofs(), i);
    }
}

TEST(RigidPartConstraints, AtAnInstantTheRowsAreSecondDerivatives)
{
  for (const bool large_rotation : {true, false})
    {
      PlateConstraints          plate(large_rotation);
      const std::vector<double> rows = plate.residual_of_rates();
      const Vector              u    = plate.to.displacement;
      const auto                at   = [&](const double t) {
        for (unsigned int i = 0; i < plate.n; ++i)
          plate.to.displacement[i] = u[i] + t * (*plate.to.velocity)[i] +
            t * t / 2 * (*plate.to.acceleration)[i];
        return plate.residual();
      };
      const double h       = 1e-3;
      const auto   forward = at(h), here = at(0), backward = at(-h);
      for (unsigned int i = 0; i < plate.n; ++i)
        // Fourth derivatives of about 10: h^2; round-off 1e-15 / h^2.
        if (plate.is_multiplier(i))
          {
            EXPECT_NEAR(rows[i],
                        (forward[i] - 2 * here[i] + backward[i]) / (h * h),
                        1e-5)
              << describe(plate.setup.dofs(), i);
          }
    }
}

TEST(RigidPartConstraints, SmallDisplacementsAreLinear)
{
  PlateConstraints plate(false);
  EXPECT_TRUE(plate.constraints->is_linear());
  EXPECT_FALSE(PlateConstraints(true).constraints->is_linear());
  // A linear residual without constant is its tangent times the unknowns.
  const std::vector<double> unknowns(plate.to.displacement.data(),
                                     plate.to.displacement.data() + plate.n);
  const std::vector<double> product = plate.tangent_times(unknowns),
                            rows    = plate.residual();
  for (unsigned int i = 0; i < plate.n; ++i)
    EXPECT_NEAR(product[i], rows[i], 1e-13);
}

TEST(RigidPartConstraints, AFiniteRigidMotionSatisfiesThem)
{
  PlateConstraints plate(true);
  plate.to.displacement.assign(plate.to.displacement.size(), 0.);
  const double angle = 2.2;
  for (unsigned int joint = 0; joint < 4; ++joint)
    {
      const dealii::Point<3> x = plate.setup.lattice.joints[joint];
      const auto set           = [&](const unsigned int c, const double value) {
        plate.to.displacement[plate.setup.dofs().joint_unknown(joint, c)] =
          value;
      };
      set(0, std::cos(angle) * x[0] - std::sin(angle) * x[1] - x[0] + 5);
      set(1, std::sin(angle) * x[0] + std::cos(angle) * x[1] - x[1] - 4);
      if (plate.setup.dofs().joint_has(joint, rotation_z))
        set(rotation_z, angle);
    }
  for (const double row : plate.residual())
    EXPECT_NEAR(row, 0, 1e-14);
  EXPECT_NEAR(plate.constraints->rotation(0, plate.to)[2], angle, 1e-14);

  // Full turns of the sections are the same motion.
  for (const unsigned int joint : {2u, 3u})
    plate.to
      .displacement[plate.setup.dofs().joint_unknown(joint, rotation_z)] +=
      2 * std::acos(-1.);
  for (const double row : plate.residual())
    EXPECT_NEAR(row, 0, 1e-14);
}

TEST(RigidPartConstraints, RatesAreThoseOfTheConstraints)
{
  for (const bool large_rotation : {true, false})
    {
      PlateConstraints plate(large_rotation);
      const Vector     u  = plate.to.displacement;
      const auto       at = [&](const double t) {
        for (unsigned int i = 0; i < plate.n; ++i)
          plate.to.displacement[i] = u[i] + t * (*plate.to.velocity)[i];
        return plate.residual();
      };
      const double h       = 1e-5;
      const auto   forward = at(h), backward = at(-h);
      plate.to.displacement = u;
      std::vector<double> rates(plate.n, 0.);
      plate.constraints->find_rates(plate.to, rates.data());
      for (unsigned int i = 0; i < plate.n; ++i)
        EXPECT_NEAR(rates[i],
                    plate.is_multiplier(i)
                      ? (forward[i] - backward[i]) / (2 * h)
                      : 0.,
                    1e-8);
    }
}

TEST(RigidPartConstraints, AHangingBarIsHeldByItsWeight)
{
  const SceneRun        run(bar("0 -2", pivot + gravity));
  const RigidPartReport report =
    run.equations.reporting().rigid_parts->report(0, run.state);
  ASSERT_EQ(report.forces.size(), 2u);
  EXPECT_NEAR(report.forces[0][0], 0, 1e-13);
  EXPECT_NEAR(report.forces[0][1], 3 * 9.81, 1e-13);
  EXPECT_NEAR(report.forces[1].norm(), 0, 1e-13);
  EXPECT_NEAR(run.reaction("pivot", 1), 3 * 9.81, 1e-13);
}

TEST(RigidPartConstraints, AHorizontalBarFallsOffItsHinge)
{
  // Released: angular acceleration 3 g / (2 L), hinge force m g / 4.
  const SceneRun        run(bar("2 0", pivot + gravity));
  const RigidPartReport report =
    run.equations.reporting().rigid_parts->report(0, run.state);
  EXPECT_NEAR(report.forces[0][0], 0, 1e-13);
  EXPECT_NEAR(report.forces[0][1], 3 * 9.81 / 4, 1e-13);
  EXPECT_NEAR(report.forces[1].norm(), 0, 1e-13);
}

TEST(RigidPartConstraints, ATurningBarIsHeldByTheCentripetalForce)
{
  // 3 kg, their centre at 1 m, 5 rad/s.
  const SceneRun run(
    bar("2 0",
        SceneText(pivot).add(
          "Initial velocities/spin",
          "Joints = all | Velocity y = 5 | Angular velocity z = 5")));
  const RigidPartReport report =
    run.equations.reporting().rigid_parts->report(0, run.state);
  EXPECT_NEAR(report.forces[0][0], -3 * 25., 1e-12);
  EXPECT_NEAR(report.forces[0][1], 0, 1e-12);
  EXPECT_NEAR(report.forces[1].norm(), 0, 1e-12);
  EXPECT_NEAR(run.equations.reporting()
                .rigid_parts->motion(0, run.lattice.joints[1], run.state)
                .velocity[1],
              10,
              1e-14);
}
