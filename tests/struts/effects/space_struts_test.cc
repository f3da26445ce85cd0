#include <auxfem/loads/effects/point_masses.h>
#include <auxfem/struts/effects/beam_forces.h>
#include <auxfem/struts/effects/strut_inertia.h>
#include <auxfem/struts/effects/struts.h>

#include <equations/space_effect.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two struts, one an arc, with different axes, damped. */
  const SceneText two_struts =
    SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0.2 0.3; 1.5 0.9 0.1", "0 1; 1 2 0.2 0 1 2")
      .given("blade", {3, 5, 0.7}, {1, 0.5, 0.25})
      .add("Sections/blade",
           "Shear area 3 = 4 | Second moment of area 2 = 0.9 | "
           "Torsion constant = 0.6 | "
           "Stiffness-proportional damping = 0.3 | "
           "Mass-proportional damping = 0.4 | Reference vector = 0.3 1 0.4");

  /** One effect without the others. */
  struct Struts : SpaceEffect
  {
    explicit Struts(const bool large_rotation, const unsigned int order)
      : SpaceEffect(SceneText(two_struts).mesh(order), large_rotation)
    {
      // Nodes of a strut must stay within half a turn of their neighbours.
      State near      = setup.equations.initial_state();
      to.displacement = near.displacement;
      to.rotations    = near.rotations;
      to              = moved(irregular(0.4), 0.4);
    }

    std::unique_ptr<StrutForces> forces(const bool large_rotation,
                                        const bool damping) const
    {
      return StrutForces::make(setup.lattice,
                               setup.dofs(),
                               setup.dofs().groups().front(),
                               setup.model.sections,
                               {large_rotation, true, damping});
    }

    std::unique_ptr<Effect> inertia(const bool large_rotation,
                                    const bool damping) const
    {
      return make_strut_inertia(setup.lattice,
                                setup.dofs(),
                                setup.dofs().groups().front(),
                                setup.model.sections,
                                {large_rotation, true, damping});
    }
  };

  template <class Check>
  void for_all(const Check &check)
  {
    for (const bool large_rotation : {true, false})
      for (const bool damping : {true, false})
        for (unsigned int order = 1; order <= 4; ++order)
          {
            SCOPED_TRACE(std::string(large_rotation ? "large" : "small") +
                         (damping ? ", damped" : "") + ", order " +
                         std::to_string(order));
            Struts struts(large_rotation, order);
            check(struts, large_rotation, damping);
          }
  }
} // namespace

TEST(SpaceStruts, TangentOfForcesIsThatOfDifferences)
{
  for_all([](Struts &struts, const bool large_rotation, const bool damping) {
    const auto forces = struts.forces(large_rotation, damping);
    struts.expect_tangent(*forces, {1., 0.7, 0.});
  });
}

TEST(SpaceStruts, TangentOfInertiaIsThatOfDifferences)
{
  for_all([](Struts &struts, const bool large_rotation, const bool damping) {
    const auto inertia = struts.inertia(large_rotation, damping);
    struts.expect_tangent(*inertia, {1., 0.7, 1.9});
  });
}

TEST(SpaceStruts, InertiaHasThePowerOfItsKineticEnergy)
{
  for (unsigned int order = 1; order <= 4; ++order)
    {
      Struts     struts(true, order);
      const auto inertia = struts.inertia(true, false);
      struts.make_room_for(*inertia);
      const auto rows   = struts.residual(*inertia, struts.to);
      const auto energy = [&](const double time) {
        State state = struts.to;
        add_multiple(time, *struts.to.acceleration, *state.velocity);
        return EvaluatedAlone(*inertia,
                              Evaluation::step(struts.from, state, 1.))
          .accept()
          .kinetic();
      };
      // Moments are in the global frame, angular velocities material.
      Vector velocity = *struts.to.velocity;
      for (unsigned int i = 0; i < struts.to.rotations.size(); ++i)
        struts.rotations.set_values(
          rotated(struts.to.rotations[i],
                  struts.rotations.values(*struts.to.velocity, i)),
          i,
          velocity);
      double power = 0;
      for (unsigned int i = 0; i < struts.n; ++i)
        power += rows[i] * velocity[i];
      const double h = 1e-4;
      EXPECT_NEAR(power, (energy(h) - energy(-h)) / (2 * h), 1e-9);
    }
}

TEST(RotaryMasses, TangentIsThatOfDifferences)
{
  SpaceEffect mass(space_frame("0 0 0; 1 0 0.3", "0 1"), true);
  SpaceTensor inertia;
  inertia[0][0] = 1;
  inertia[1][1] = 2.5;
  inertia[2][2] = 1.7;
  inertia[0][1] = inertia[1][0] = 0.3;
  const std::unique_ptr<Effect> masses =
    make_rotary_masses(mass.setup.dofs(), true, {{1, inertia}});
  mass.expect_tangent(*masses, {1., 0.7, 1.9});
}
