#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double dt = 0.3;

  /** Two states of a strut with large rotations. */
  struct TwoStates
  {
    TwoStates()
      : setup(frame_scene("0 0; 1 0", "0 1"),
              {"Time/Scheme=energy-momentum"},
              MPI_COMM_SELF)
      , scheme(setup.scene.time.implicit_scheme())
      , from(setup.equations.initial_state())
      , to(from)
    {
      fill_by_position(setup.model, 0.3, from.displacement);
      fill_by_position(setup.model, 1.7, *from.velocity);
      fill_by_position(setup.model, 2.3, *from.acceleration);
    }

    bool is_plane_rotation(const int i) const
    {
      return std::count(to.plane_rotations->begin(),
                        to.plane_rotations->end(),
                        i) > 0;
    }

    void expect_mean_rates() const
    {
      for (unsigned int i = 0; i < to.displacement.size(); ++i)
        {
          const double moved = to.displacement[i] - from.displacement[i],
                       travel =
                         is_plane_rotation(i) ? cayley_rotation(moved) : moved;
          EXPECT_NEAR(((*from.velocity)[i] + (*to.velocity)[i]) / 2,
                      travel / dt,
                      1e-14);
          EXPECT_NEAR(((*to.velocity)[i] - (*from.velocity)[i]) / dt,
                      (*to.acceleration)[i],
                      1e-13);
        }
    }

    EquationsOnRanks      setup;
    const ImplicitScheme &scheme;
    State                 from, to;
  };
} // namespace

TEST(EnergyMomentum, MeanVelocityIsTheIncrementOverTheStep)
{
  TwoStates states;
  // Rotations of all nodes.
  EXPECT_EQ(states.to.plane_rotations->size(),
            states.setup.dofs().layout().n_local() / 3);
  states.scheme.predict(states.from, dt, states.to);
  states.expect_mean_rates();
  Vector increment(states.from.displacement);
  fill_by_position(states.setup.model, -0.4, increment);
  for (unsigned int i = 0; i < 3; ++i)
    states.scheme.correct(states.from, increment, dt, states.to);
  states.expect_mean_rates();
}

TEST(EnergyMomentum, PredictorIsThePositionAtTheStart)
{
  TwoStates states;
  states.scheme.predict(states.from, dt, states.to);
  for (unsigned int i = 0; i < states.to.displacement.size(); ++i)
    EXPECT_EQ(states.to.displacement[i], states.from.displacement[i]);
}

TEST(EnergyMomentum, SmallRotationsAreNotLargeOnes)
{
  const EquationsOnRanks setup(frame_scene("0 0; 1 0", "0 1"),
                               {"Time/Scheme=energy-momentum",
                                "Effects/Large rotation=off"},
                               MPI_COMM_SELF);
  EXPECT_TRUE(setup.equations.initial_state().plane_rotations->empty());
  EXPECT_TRUE(setup.equations.is_linear());
}

TEST(EnergyMomentum, BalancesMeansWithoutRestoredRates)
{
  const TwoStates states;
  EXPECT_TRUE(states.scheme.uses_discrete_gradient());
  EXPECT_TRUE(states.scheme.is_dynamic());
  EXPECT_FALSE(states.scheme.propagates_alternating_errors());
}
