#include <auxfem/contact/effects/strut_proximity.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <functional>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Two rods side by side, 10 mm thick, with 90 mm between them. */
  SceneText rods(const std::string &scheme)
  {
    return SceneText()
      .frame("0 0; 1 0; 0.3 0.1; 0.7 0.1", "0 1; 2 3")
      .circle("rod", 0.005, {70e9, 2700, 0.3})
      .mesh(2)
      .time(1, 0.01, scheme);
  }

  /**
   * First step in which contact of the rods is detected, if one rod moves by
   * @p way(step) (m); 0 if never.
   */
  unsigned int step_of_touch(const std::function<double(unsigned int)> &way,
                             const unsigned int                         n_steps,
                             const std::string &scheme       = "newmark",
                             const MPI_Comm     communicator = MPI_COMM_SELF)
  {
    EquationsOnRanks         setup(rods(scheme), {}, communicator);
    std::vector<ContactAxis> axes = make_contact_axes(setup.model, 1);
    const StrutCurves        curves(setup.model, axes);
    FirstContactDetector     detector(setup.model,
                                  curves,
                                  StrutProximity(setup.model, curves));
    State                    from = setup.equations.initial_state(), to = from;
    for (unsigned int step = 1; step <= n_steps; ++step)
      {
        const std::vector<int> &moved = axes.back().unknowns;
        for (std::size_t i = 1; i < moved.size(); i += 2)
          if (const int local = setup.dofs().layout().local(moved[i]);
              local >= 0)
            to.displacement[local] = -way(step);
        if (detector.find(from, to))
          return step;
        from = to;
      }
    return 0;
  }
} // namespace

TEST(FirstContactDetector, DetectsSlowContactInItsStep)
{
  const auto steady = [](const unsigned int step) { return 1e-5 * step; };
  EXPECT_EQ(step_of_touch(steady, 8999), 0u);
  EXPECT_NEAR(step_of_touch(steady, 9100), 9001, 1);
}

TEST(FirstContactDetector, DetectsThePeakOfASwing)
{
  // With 20 steps a period; the peaks are between two steps.
  const auto swing = [](const double amplitude) {
    return [amplitude](const unsigned int step) {
      return amplitude * std::sin(2 * pi * (step - 0.5) / 20);
    };
  };
  const double peak = std::sin(2 * pi * 4.5 / 20);
  EXPECT_EQ(step_of_touch(swing(0.0895 / peak), 200), 0u);
  EXPECT_EQ(step_of_touch(swing(0.0905 / peak), 200), 5u);
}

TEST(FirstContactDetector, DetectsThePeakOfASmallSwingNearTheOtherRod)
{
  const auto swing = [](const double nearest) {
    return [nearest](const unsigned int step) {
      const double peak = std::sin(2 * pi * 4.5 / 20);
      return nearest + 1e-4 * (std::sin(2 * pi * (step - 0.5) / 20) / peak - 1);
    };
  };
  EXPECT_EQ(step_of_touch(swing(0.089995), 200), 0u);
  EXPECT_EQ(step_of_touch(swing(0.090003), 200), 5u);
}

TEST(FirstContactDetector, DetectsMotionsAfterLongRest)
{
  const auto pushed = [](const unsigned int step) {
    return step > 100 ? 0.0901 * std::min((step - 100) / 5., 1.) : 0.;
  };
  const unsigned int found = step_of_touch(pushed, 200);
  EXPECT_GE(found, 105u);
  EXPECT_LE(found, 108u);

  // Independent of the number of unchecked steps.
  for (const double peak : {20021., 20022., 20023., 20024.})
    {
      const auto pulse = [peak](const unsigned int step) {
        return 0.0901 * std::exp(-std::pow((step - peak) / 8, 2));
      };
      EXPECT_EQ(step_of_touch(pulse, 20100), peak);
    }
}

TEST(FirstContactDetector, ChecksEveryStepWithoutInertia)
{
  const auto jump = [](const unsigned int step) {
    return step == 51 ? 0.0901 : 0.;
  };
  EXPECT_EQ(step_of_touch(jump, 100, "static"), 51u);
}

TEST(FirstContactDetectorOnRanks, AgreesWithOneRank)
{
  const auto swing = [](const unsigned int step) {
    return 0.0905 * std::sin(2 * pi * step / 47.);
  };
  const unsigned int alone = step_of_touch(swing, 100);
  EXPECT_GT(alone, 0u);
  EXPECT_EQ(step_of_touch(swing, 100, "newmark", MPI_COMM_WORLD), alone);
}
