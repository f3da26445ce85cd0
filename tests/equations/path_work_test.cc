#include <auxfem/equations/load_work.h>

#include <gtest/gtest.h>

using namespace auxfem;

namespace
{
  /** At 0.2 s, in a step to 0.7 s; the one before began at 0.1 s. */
  struct TwoSteps
  {
    TwoSteps() : from(1, StateLayout()), to(from)
    {
      from.time   = 0.2;
      from.before = State::Before{0.1, 0.1, from.displacement, from.residual};
      to.time     = 0.7;
    }

    Evaluation step() const
    {
      return Evaluation::static_step(from, to, 0.5);
    }

    State         from;
    mutable State to;
  };
} // namespace

TEST(PathWork, IsExactForParabolas)
{
  const auto F = [](const double t) { return 2 - 3 * t + 4 * t * t; };
  const auto u = [](const double t) { return 1 + 5 * t - 2 * t * t; };
  // The integral of F du/dt, (2 - 3 t + 4 t^2) (5 - 4 t).
  const auto work = [](const double t) {
    return 10 * t - 23. / 2 * t * t + 32. / 3 * t * t * t - 4 * t * t * t * t;
  };
  const TwoSteps steps;
  const PathWork path(steps.step());
  ASSERT_EQ(path.state_before(), &*steps.from.before);
  EXPECT_NEAR((F(0.2) + F(0.7)) / 2 * (u(0.7) - u(0.2)) +
                path.beyond_mean({{F(0.1), F(0.2), F(0.7)}},
                                 {{u(0.1), u(0.2), u(0.7)}}),
              work(0.7) - work(0.2),
              1e-15);
}

TEST(PathWork, NeedsTwoElasticStaticSteps)
{
  TwoSteps first;
  first.from.before.reset();
  EXPECT_EQ(PathWork(first.step()).state_before(), nullptr);

  TwoSteps viscous;
  viscous.to.velocity.emplace(1, 0.);
  EXPECT_EQ(PathWork(viscous.step()).state_before(), nullptr);

  const TwoSteps steps;
  EXPECT_EQ(
    PathWork(Evaluation::step(steps.from, steps.to, 0.5)).state_before(),
    nullptr);
}
