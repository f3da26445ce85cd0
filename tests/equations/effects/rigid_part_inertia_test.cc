#include <auxfem/equations/effects/rigid_part_inertia.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** An L of 4 kg with legs of 3 m and 1 m: its base does not hold its centre.
   */
  struct InertiaOfL
  {
    InertiaOfL()
      : of_scene(frame_scene("0 0; 3 0; 3 1",
                             "0 1; 1 2",
                             "subsection Rigid parts\n"
                             "  subsection L\n"
                             "    set Struts = all\n"
                             "    set Mass = 4\n"
                             "  end\n"
                             "end\n"),
                 {},
                 MPI_COMM_SELF)
      , part(of_scene.lattice.rigid_parts.at(0))
      , inertia(rigid_bodies(of_scene.lattice, of_scene.dofs()))
      , from(of_scene.equations.initial_state())
      , to(from)
    {}

    /** A turn at @p rate about (@p x, @p y) in @p vector. */
    void turn(const double rate,
              const double x,
              const double y,
              Vector      &vector) const
    {
      for (unsigned int joint = 0; joint < 3; ++joint)
        {
          const auto &place = of_scene.lattice.joints[joint];
          vector[of_scene.dofs().joint_unknown(joint, 0)] =
            -rate * (place[1] - y);
          vector[of_scene.dofs().joint_unknown(joint, 1)] =
            rate * (place[0] - x);
        }
    }

    EquationsOnRanks of_scene;
    const RigidPart &part;
    RigidPartInertia inertia;
    State            from, to;
  };
} // namespace

TEST(RigidPartInertia,
     ForcesHaveTheResultantOfTheCentreAndTheMomentOfARigidBody)
{
  InertiaOfL L;
  // Angular acceleration 2 about (-1, 2).
  L.turn(2, -1, 2, *L.to.acceleration);
  const auto         &dofs = L.of_scene.dofs();
  std::vector<double> residual(dofs.n_local(), 0.);
  L.inertia.add_residual({L.from, L.to, 1.}, residual.data());
  double force[2] = {0, 0}, moment = 0;
  for (unsigned int joint = 0; joint < 3; ++joint)
    {
      const double x = residual[dofs.joint_unknown(joint, 0)],
                   y = residual[dofs.joint_unknown(joint, 1)];
      force[0] += x;
      force[1] += y;
      moment +=
        (L.of_scene.lattice.joints[joint][0] - L.part.centre_of_mass[0]) * y -
        (L.of_scene.lattice.joints[joint][1] - L.part.centre_of_mass[1]) * x;
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
  Energies energies;
  L.inertia.add_energies(L.to, energies);
  const double arm = L.part.centre_of_mass.distance_square({-1, 2, 0});
  EXPECT_NEAR(energies.kinetic(),
              (4 * arm + L.part.rotary_inertia[2][2]) * 1.5 * 1.5 / 2,
              1e-12);
}

TEST(RigidPartInertia, TangentIsTheDerivativeByAccelerations)
{
  InertiaOfL    L;
  TangentMatrix matrix(L.of_scene.dofs());
  L.inertia.register_blocks(matrix);
  matrix.finalize();
  matrix.reset();
  L.inertia.add_tangent({L.from, L.to, 1.}, {7., 9., 0.5}, matrix);
  EXPECT_TRUE(L.inertia.is_linear());

  Epetra_Vector a(L.of_scene.dofs().owned_map()), product(a);
  for (int i = 0; i < a.MyLength(); ++i)
    a[i] = (*L.to.acceleration)[i] = std::sin(1 + 1.7 * i);
  matrix.matrix().Multiply(false, a, product);
  std::vector<double> residual(L.of_scene.dofs().n_local(), 0.);
  L.inertia.add_residual({L.from, L.to, 1.}, residual.data());
  for (int i = 0; i < a.MyLength(); ++i)
    EXPECT_NEAR(product[i], 0.5 * residual[i], 1e-14);
}
