#include <auxfem/time/consistent_rates.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  void start(EquationsOnRanks &setup, State &state)
  {
    Work          work;
    TangentSolver solver(setup.equations, setup.scene.solver, work);
    ConsistentRates(solver).start(state, 1e-3);
  }

  /** Acceleration at t = 0 of a dynamic scene by the name of the unknown. */
  std::map<UnknownName, double>
  initial_acceleration(const std::string              &text,
                       const std::vector<std::string> &overrides = {})
  {
    EquationsOnRanks setup(text, overrides, MPI_COMM_SELF);
    State            state = setup.equations.initial_state();
    start(setup, state);
    return by_name(setup.model, *state.acceleration);
  }

  const SceneText falling = frame_scene("0 0; 3 4; 5 4", "0 1; 1 2")
                              .set("Gravity/Acceleration y", -9)
                              .mass("weight", "1", 4);
} // namespace

TEST(ConsistentRates, AFreeFrameFallsAtTheAccelerationOfGravity)
{
  for (const auto &[name, acceleration] : initial_acceleration(falling))
    // Round-off times the condition of the mass matrix, about 100.
    EXPECT_NEAR(acceleration, std::get<3>(name) == 1 ? -9. : 0., 1e-12);
}

TEST(ConsistentRates, InitialAccelerationIsFoundWithoutRotaryInertia)
{
  for (const auto &[name, acceleration] :
       initial_acceleration(falling, {"Effects/Rotary inertia=off"}))
    // The stiffness substituted for rotary inertia is 1e-7 of the mass, which
    // costs as many digits.
    EXPECT_NEAR(acceleration, std::get<3>(name) == 1 ? -9. : 0., 1e-8);
}

TEST(ConsistentRates, AShakenBaseAcceleratesAsPrescribed)
{
  const auto acceleration = initial_acceleration(
    frame_scene("0 0; 1 0", "0 1")
      .add("Supports/base",
           "Joints = 0 | Type = prescribed | Displacement x = 2 * t^2"));
  EXPECT_NEAR(acceleration.at({true, 0, 0., 0}), 4., 1e-10);
  EXPECT_NEAR(acceleration.at({true, 0, 0., 1}), 0., 1e-12);
}

namespace
{
  /** A rigid bar from (0, 0) to (1, 0), rotating about its end at 3 rad/s. */
  SceneText rotating_bar(const std::string &speed_apart)
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .rigid_part("bar", "0", 2)
      .add("Initial velocities/spin",
           "Joints = all | Velocity y = 1.5 | Angular velocity z = 3")
      .add("Initial velocities/stretch",
           "Joints = 1 | Velocity x = " + speed_apart + " | Velocity y = 3");
  }
} // namespace

TEST(ConsistentRates, VelocitiesAreProjectedToThoseOfRigidParts)
{
  EquationsOnRanks setup(rotating_bar("2e-6"), {}, MPI_COMM_SELF);
  State            state = setup.equations.initial_state();
  start(setup, state);
  const auto &dofs = setup.dofs();
  // Momentum is preserved and shared by both ends.
  for (unsigned int joint = 0; joint < 2; ++joint)
    EXPECT_NEAR((*state.velocity)[dofs.joint_unknown(joint, 0)], 1e-6, 1e-18);
  EXPECT_NEAR((*state.velocity)[dofs.joint_unknown(1, 1)], 3, 1e-14);
  // Centripetal; the free bar rotates about its middle.
  EXPECT_NEAR((*state.acceleration)[dofs.joint_unknown(0, 0)], 4.5, 1e-13);
  EXPECT_NEAR((*state.acceleration)[dofs.joint_unknown(1, 0)], -4.5, 1e-13);
}

TEST(ConsistentRates, VelocitiesThatStrainRigidPartsAreRefused)
{
  EquationsOnRanks  setup(rotating_bar("2e-4"), {}, MPI_COMM_SELF);
  State             state   = setup.equations.initial_state();
  const std::string message = input_error_of([&] { start(setup, state); });
  EXPECT_TRUE(contains(message, "move apart with 0.0002 m/s")) << message;
}

namespace
{
  /**
   * Expects the initial accelerations of @p text without factorization, equal
   * to a direct solution with the mass matrix.
   */
  void expect_those_of_direct_solution(const std::string &text)
  {
    // The support accelerates, so columns of prescribed rows contribute.
    EquationsOnRanks setup(text,
                           {"Supports/shaker/Displacement x=0.02 * t^2"},
                           MPI_COMM_SELF);
    ASSERT_EQ(setup.dofs().constraints().n_multipliers(), 0u);
    State         state = setup.equations.initial_state();
    Work          work;
    TangentSolver solver(setup.equations, setup.scene.solver, work);
    ConsistentRates(solver).start(state, 1e-3);
    EXPECT_EQ(work.factorizations, 0u);

    State      direct  = state;
    const auto is_free = [&](const unsigned int i) {
      return setup.dofs().unknowns().kinds[i] != UnknownKind::prescribed;
    };
    for (unsigned int i = 0; i < setup.dofs().layout().n_owned(); ++i)
      if (is_free(i))
        (*direct.acceleration)[i] = 0;
    const State      before  = direct;
    const Evaluation instant = Evaluation::consistent_rates(before, direct);
    setup.residual(instant);
    solver.assemble(instant, setup.results, {0., 0., 1.});
    ASSERT_TRUE(solver.factorize());
    Vector increment(setup.dofs().layout().n_local());
    for (unsigned int i = 0; i < setup.dofs().layout().n_owned(); ++i)
      increment[i] = is_free(i) ? -direct.residual[i] : 0.;
    ASSERT_TRUE(solver.solve(increment)) << solver.last_failure();
    add_multiple(1., increment, *direct.acceleration);

    const double largest    = largest_size(*direct.acceleration);
    double       prescribed = 0;
    for (unsigned int i = 0; i < setup.dofs().layout().n_owned(); ++i)
      {
        // Residuals of 1e-13, and inertias that differ by a factor of some
        // hundreds.
        EXPECT_NEAR((*state.acceleration)[i],
                    (*direct.acceleration)[i],
                    1e-10 * largest);
        if (!is_free(i))
          prescribed =
            std::max(prescribed, std::abs((*direct.acceleration)[i]));
      }
    EXPECT_NEAR(prescribed, 0.04, 1e-12);
    EXPECT_GT(largest, 2 * prescribed);
  }
} // namespace

TEST(ConsistentRates, ConjugateGradientsMatchADirectSolution)
{
  expect_those_of_direct_solution(star_with_everything(2, 2));
}

TEST(ConsistentRates, ConjugateGradientsMatchADirectSolutionInSpace)
{
  // A hinge without constraints.
  expect_those_of_direct_solution(space_star_with_everything()
                                    .remove("Joints/axles/Axis")
                                    .set("Joints/axles/Type", "hinge"));
}
