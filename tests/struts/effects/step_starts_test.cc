#include <auxfem/struts/effects/beam_mean_forces.h>

#include <gtest/gtest.h>

using namespace auxfem;

TEST(StepStarts, AreRecomputedIfTheStartDiffersInItsLastBit)
{
  StateLayout layout;
  layout.compensation = true;
  layout.n_rotations  = 1;
  State             state(/*n_unknowns=*/3, layout);
  StepStarts<Lanes> starts;
  unsigned int      n_made = 0;
  const auto        value  = [&](const unsigned int e) {
    return lane_value(starts[e / n_lanes], e % n_lanes);
  };
  const auto update = [&] {
    starts.update(state, /*n_elements=*/2, [&](const ElementBatch &batch) {
      n_made += batch.size;
      return batch.numbers([&](const unsigned int e) {
        return state.displacement[e] + (*state.compensation)[e];
      });
    });
  };
  update();
  EXPECT_EQ(n_made, 2u);
  update();
  EXPECT_EQ(n_made, 2u);

  state.displacement[1] = 1;
  update();
  EXPECT_EQ(n_made, 4u);
  EXPECT_EQ(value(1), 1.);
  (*state.compensation)[0] = 1e-300;
  update();
  EXPECT_EQ(n_made, 6u);
  EXPECT_EQ(value(0), 1e-300);
  state.rotations[0].vector[2] = 1e-17;
  update();
  EXPECT_EQ(n_made, 8u);
  // Negative zero has the same value.
  state.displacement[2] = -0.;
  update();
  EXPECT_EQ(n_made, 10u);
  update();
  EXPECT_EQ(n_made, 10u);
}
