#include <auxfem/loads/effects/applied_loads.h>

#include <equations/effect_alone.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  TimeFunction course(const std::string &text)
  {
    return TimeFunction(text, "Force", SceneContext());
  }

  /** Two loads: 3 t on unknowns 1 and 2 (weights 1 and -2), and 5 on 2. */
  struct LoadsAlone
  {
    explicit LoadsAlone(const bool raised_from_zero = false)
      : setup(frame_scene("0 0; 1 0", "0 1"), {}, MPI_COMM_SELF)
      , from(setup.equations.initial_state())
      , to(from)
    {
      const EnergyEntry work{EnergyKind::work, "load_work", "work of loads"};
      loads              = make_applied_loads(setup.dofs(),
                                 raised_from_zero,
                                 {{course("3 * t"), work, {{1, 1.}, {2, -2.}}},
                                               {course("5"), work, {{2, 1.}}}});
      from.time          = 0.5;
      to.time            = 1.5;
      StateLayout layout = setup.equations.layout();
      loads->register_in(layout);
      work_entry = layout.energies.enter(work);
      make_room(layout, from);
      make_room(layout, to);
    }

    EvaluatedAlone evaluated()
    {
      return {*loads, Evaluation::step(from, to, 1.)};
    }

    EquationsOnRanks        setup;
    std::unique_ptr<Effect> loads;
    State                   from, to;
    unsigned int            work_entry;
  };
} // namespace

TEST(AppliedLoads, ResidualIsMinusTheForceAtTheEndOfTheStep)
{
  LoadsAlone                applied;
  const std::vector<double> residual = applied.evaluated().residual;
  for (unsigned int i = 0; i < residual.size(); ++i)
    EXPECT_EQ(residual[i], i == 1 ? -4.5 : i == 2 ? 9. - 5. : 0.);
}

TEST(AppliedLoads, FollowTheLoadFactorOnAPath)
{
  LoadsAlone applied;
  applied.to.path.emplace();
  const auto residual = [&](const double load_factor) {
    applied.to.path->load_factor = load_factor;
    return EvaluatedAlone(*applied.loads,
                          Evaluation::step(applied.from, applied.to, 1.))
      .residual;
  };
  const std::vector<double> less = residual(0.25), more = residual(1.25);
  applied.to.path->load_factor = 0.75;
  std::vector<double> derivative(less.size(), 0.);
  applied.loads->add_load_derivative(Evaluation::step(applied.from,
                                                      applied.to,
                                                      1.),
                                     derivative.data());
  for (unsigned int i = 0; i < less.size(); ++i)
    EXPECT_NEAR(derivative[i], more[i] - less[i], 1e-14);
  EXPECT_NE(derivative[1], 0);
}

TEST(AppliedLoads, WorkIsTheMeanForceTimesTheDisplacement)
{
  LoadsAlone applied;
  applied.from.displacement[1]                 = 0.25;
  applied.to.displacement[1]                   = 0.75;
  applied.to.displacement[2]                   = 0.125;
  applied.from.energy_sums[applied.work_entry] = 10;
  // Means: 3 N and 5 N; exact in binary numbers.
  EXPECT_EQ(applied.evaluated().accept().external(),
            10 + 3 * (0.5 - 2 * 0.125) + 5 * 0.125);
}

TEST(AppliedLoads, LoadsRaisedFromZeroDoLessWorkInTheFirstStep)
{
  for (const bool raised : {false, true})
    {
      LoadsAlone applied(raised);
      applied.from.time          = 0;
      applied.to.displacement[2] = 0.125;
      // 3 t grows to 4.5 anyway; 5 acts from the start or grows as well.
      EXPECT_EQ(applied.evaluated().accept().external(),
                (-2 * 4.5 / 2 + (raised ? 2.5 : 5.)) * 0.125);
    }
}

TEST(AppliedLoads, DeadLoadsAreLinear)
{
  EXPECT_TRUE(LoadsAlone().loads->is_linear());
}
