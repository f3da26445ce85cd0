#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <verification/star_scene.h>

#include <cmath>
#include <numeric>

using namespace auxfem;
using namespace auxfem::testing_support;

// A lattice of 2 x 2 cells under twice its buckling load: what refined runs
// agree in, path by path and in the mean over imperfections. More of it by
// scripts/stability-page.

namespace
{
  struct Collapse
  {
    double begin      = 0; ///< a tenth of the height is lost (s)
    double dissipated = 0; ///< by then and in the rest of 20 ms (J)
  };

  Collapse collapse(const unsigned int seed, const std::string &time_step)
  {
    constexpr double height = 54.64e-3; // m
    SceneRun         run(star_scene(),
                 star_size(2, 2.6) +
                   std::vector<std::string>{
                             "Effects/Contact=off",
                             "Imperfections/rough/Type=random",
                             "Imperfections/rough/Standard deviation=10 um",
                             "Imperfections/rough/Seed=" + std::to_string(seed),
                             "Time/Scheme=energy-momentum",
                             "Time/Time step=" + time_step});
    const auto      &roof = run.lattice.joint_sets.at("top");
    Collapse         found;
    run.run([&] {
      double sum = 0;
      for (const unsigned int joint : roof)
        sum += run.motion(joint, 1);
      if (found.begin == 0 && -sum / roof.size() > 0.1 * height)
        found.begin = run.state.time;
    });
    found.dissipated = run.state.energies.dissipated();
    return found;
  }

  double mean(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.) / values.size();
  }

  /** Squared standard error of the mean. */
  double squared_error(const std::vector<double> &values)
  {
    double squares = 0;
    for (const double value : values)
      squares += std::pow(value - mean(values), 2);
    return squares / (values.size() - 1) / values.size();
  }
} // namespace

TEST(CollapseStatistics, AQuarterOfTheStepGivesTheSameFallAndTheSameMeans)
{
  std::vector<double> coarse, fine;
  for (unsigned int seed = 1; seed <= 6; ++seed)
    {
      const Collapse one   = collapse(seed, "20 us"),
                     other = collapse(seed, "5 us");
      EXPECT_GT(one.begin, 5e-3);
      EXPECT_NEAR(one.begin, other.begin, 0.05e-3) << seed;
      coarse.push_back(one.dissipated);
      fine.push_back(other.dissipated);
    }
  EXPECT_LT(std::abs(mean(coarse) - mean(fine)),
            3 * std::sqrt(squared_error(coarse) + squared_error(fine)));
}
