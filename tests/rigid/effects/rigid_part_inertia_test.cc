#include <auxfem/loads/effects/point_masses.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /**
   * An L of 4 kg with legs of 3 m and 1 m; its centre of mass is off its base.
   */
  struct InertiaOfL
  {
    InertiaOfL()
      : setup(
          frame_scene("0 0; 3 0; 3 1", "0 1; 1 2").rigid_part("L", "all", 4),
          {},
          MPI_COMM_SELF)
      , part(setup.lattice.rigid_parts.at(0))
      , inertia(
          make_rigid_part_inertia(rigid_bodies(setup.lattice, setup.dofs())))
      , from(setup.equations.initial_state())
      , to(from)
    {
      StateLayout layout = setup.equations.layout();
      inertia->register_in(layout);
      make_room(layout, from);
      make_room(layout, to);
    }

    Evaluation step()
    {
      return Evaluation::step(from, to, 1.);
    }

    /** Sets a rotation at @p rate about (@p x, @p y) in @p vector. */
    void turn(const double rate,
              const double x,
              const double y,
              Vector      &vector) const
    {
      for (unsigned int joint = 0; joint < 3; ++joint)
        {
          const auto &position = setup.lattice.joints[joint];
          vector[setup.dofs().joint_unknown(joint, 0)] =
            -rate * (position[1] - y);
          vector[setup.dofs().joint_unknown(joint, 1)] =
            rate * (position[0] - x);
        }
    }

    EquationsOnRanks        setup;
    const RigidPart        &part;
    std::unique_ptr<Effect> inertia;
    State                   from, to;
  };
} // namespace

TEST(RigidPartInertia,
     ForcesHaveTheResultantOfTheCentreAndTheMomentOfARigidBody)
{
  InertiaOfL L;
  // Angular acceleration 2 about (-1, 2).
  L.turn(2, -1, 2, *L.to.acceleration);
  const auto               &dofs = L.setup.dofs();
  const std::vector<double> residual =
    EvaluatedAlone(*L.inertia, L.step()).residual;
  double force[2] = {0, 0}, moment = 0;
  for (unsigned int joint = 0; joint < 3; ++joint)
    {
      const double x = residual[dofs.joint_unknown(joint, 0)],
                   y = residual[dofs.joint_unknown(joint, 1)];
      force[0] += x;
      force[1] += y;
      moment +=
        (L.setup.lattice.joints[joint][0] - L.part.centre_of_mass[0]) * y -
        (L.setup.lattice.joints[joint][1] - L.part.centre_of_mass[1]) * x;
    }
  const double rx = L.part.centre_of_mass[0] + 1,
               ry = L.part.centre_of_mass[1] - 2;
  EXPECT_NEAR(force[0], 4 * -2 * ry, 1e-12);
  EXPECT_NEAR(force[1], 4 * 2 * rx, 1e-12);
  EXPECT_NEAR(moment, 2 * L.part.rotary_inertia[2][2], 1e-12);
}

TEST(RigidPartInertia, KineticEnergyIsThatOfTheRigidBody)
{
  InertiaOfL L;
  L.turn(1.5, -1, 2, *L.to.velocity);
  const Energies energies = EvaluatedAlone(*L.inertia, L.step()).accept();
  const double   arm      = L.part.centre_of_mass.distance_square({-1, 2, 0});
  EXPECT_NEAR(energies.kinetic(),
              (4 * arm + L.part.rotary_inertia[2][2]) * 1.5 * 1.5 / 2,
              1e-12);
}

TEST(RigidPartInertia, TangentIsTheDerivativeByAccelerations)
{
  InertiaOfL          L;
  std::vector<double> a(L.setup.dofs().layout().n_global());
  for (unsigned int i = 0; i < a.size(); ++i)
    a[i] = (*L.to.acceleration)[i] = std::sin(1 + 1.7 * i);
  const EvaluatedAlone evaluated(*L.inertia, L.step());
  TangentAlone         tangent(*L.inertia, L.setup.dofs());
  tangent.fill(evaluated, {7., 9., 0.5});
  EXPECT_TRUE(L.inertia->is_linear());

  const std::vector<double> product = tangent.times(a);
  for (unsigned int i = 0; i < a.size(); ++i)
    EXPECT_NEAR(product[i], 0.5 * evaluated.residual[i], 1e-14);
}
