#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/time/consistent_rates.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A free strut in space with translation and rotation. */
  const SceneText flying_strut =
    SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0 0", "0 1")
      .circle("rod", 0.01, {1e9, 1000, 0.3})
      .add("Initial velocities/throw",
           "Joints = all | Velocity x = 1 | Angular velocity z = 2")
      .mesh(2)
      .time(1, 1e-3, "energy-momentum");

  /**
   * Predictor of a step of length @p dt (s); acceleration is the @p change of
   * velocities per second, over themselves.
   */
  struct Guess
  {
    Guess(const double change, const double dt)
      : on_ranks(flying_strut.str())
      , from(on_ranks.equations.initial_state())
      , to(from)
    {
      *from.acceleration = *from.velocity;
      for (double &value : *from.acceleration)
        value *= change;
      const ImplicitScheme &scheme = on_ranks.scene.time.implicit_scheme();
      const Evaluation      step = Evaluation::discrete_gradient(from, to, dt);
      scheme.predict(from, dt, to);
      extrapolate_predictor(scheme, step, on_ranks.model);
    }

    EquationsOnRanks on_ranks;
    State            from, to;
  };
} // namespace

TEST(GuessAhead, UsesConstantAcceleration)
{
  const double dt = 0.01, change = 5;
  const Guess  guess(change, dt);
  for (std::size_t i = 0; i < guess.to.displacement.size(); ++i)
    EXPECT_NEAR(guess.to.displacement[i],
                (dt + dt * dt / 2 * change) * (*guess.from.velocity)[i],
                1e-16);
}

TEST(GuessAhead, ObeysTheScheme)
{
  const double dt = 0.01;
  const Guess  guess(5, dt);
  const auto  &numbering = guess.on_ranks.model.numbering;
  for (std::size_t i = 0; i < guess.to.displacement.size(); ++i)
    {
      // Rotates about z only.
      const double motion = numbering.unknowns().is_rotation[i]
        ? cayley_rotation(guess.to.displacement[i])
        : guess.to.displacement[i];
      EXPECT_NEAR(((*guess.from.velocity)[i] + (*guess.to.velocity)[i]) / 2,
                  motion / dt,
                  1e-13);
      EXPECT_NEAR((*guess.to.acceleration)[i],
                  ((*guess.to.velocity)[i] - (*guess.from.velocity)[i]) / dt,
                  1e-11);
    }
}

TEST(GuessAhead, LongStepsAreNotExtrapolated)
{
  const Guess guess(/*change=*/11, /*dt=*/0.01);
  for (const double value : guess.to.displacement)
    EXPECT_EQ(value, 0.);
}

TEST(GuessAhead, IsExactForFreeFall)
{
  SceneRun run(SceneText(flying_strut)
                 .remove("Initial velocities/throw/Angular velocity z")
                 .set("Initial velocities/throw/Velocity x", 10)
                 .set("Gravity/Acceleration x", 1)
                 .set("Time/End time", 0.1));
  run.run();
  EXPECT_EQ(run.computation.work().steps, 100u);
  EXPECT_LT(run.computation.work().iterations, 10u);
}
