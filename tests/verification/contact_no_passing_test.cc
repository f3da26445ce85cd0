#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/struts/effects/struts.h>

#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <random>

using namespace auxfem;
using namespace auxfem::testing_support;

// Struts thrown at each other at random never pass through each other, however
// long the steps are.

namespace
{
  using Line = std::vector<dealii::Point<3>>;

  /** Struts in two clouds that fly at each other. */
  SceneText thrown_struts(const unsigned int dimension, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    const auto   number = [&](const double low, const double high) {
      return std::uniform_real_distribution<double>(low, high)(generator);
    };
    constexpr unsigned int n_of_cloud = 5;
    std::string            joints, struts, left, right;
    for (unsigned int i = 0; i < 2 * n_of_cloud; ++i)
      {
        // Apart at rest: each in a slice of its own.
        const double y = 0.02 * (i % n_of_cloud), x = i < n_of_cloud ? 0 : 0.05;
        const double from = number(-0.01, 0), to = number(0.02, 0.03);
        for (const double along : {from, to})
          {
            joints += (joints.empty() ? "" : "; ") + text(x + along) + " " +
              text(y + number(-0.006, 0.006));
            if (dimension == 3)
              joints += " " + text(number(-0.004, 0.004));
          }
        struts +=
          (struts.empty() ? "" : "; ") + text(2 * i) + " " + text(2 * i + 1);
        std::string &cloud = i < n_of_cloud ? left : right;
        cloud +=
          (cloud.empty() ? "" : ", ") + text(2 * i) + ", " + text(2 * i + 1);
      }
    const double speed = number(5, 30);
    return SceneText()
      .dimension(dimension)
      .frame(joints, struts)
      .rectangle("strip", "1 mm", "1 mm", {"1 GPa", 1000, 0.3})
      .add("Initial velocities/left",
           "Joints = " + left + " | Velocity x = " + text(speed) +
             " | Velocity y = " + text(number(-5, 5)))
      .add("Initial velocities/right",
           "Joints = " + right + " | Velocity x = " + text(-speed))
      .set("Effects/Contact", "on")
      .mesh(3)
      .add("Time", "Spectral radius = 0.6")
      // Two clouds pass by each other in this time, were it not for contact.
      .time(0.05 / speed, 100e-6, "generalized-alpha");
  }

  /** Axes of all struts at displacements between those of two states. */
  std::vector<Line> axes_of(const SceneRun &run, const Vector &displacement)
  {
    constexpr unsigned int n_points = 13;
    std::vector<Line>      axes(run.lattice.struts.size());
    for (const StrutGroup &group : run.equations.reporting().struts)
      for (unsigned int e = group.forces->elements().begin;
           e < group.forces->elements().end;
           ++e)
        axes[run.model.numbering.elements()[e].interval.strut] =
          group.forces->axis(displacement, e, n_points);
    return axes;
  }

  double least_distance(const Line &one, const Line &other)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < one.size(); ++i)
      for (std::size_t j = 0; j + 1 < other.size(); ++j)
        least =
          std::min(least,
                   distance({one[i], one[i + 1]}, {other[j], other[j + 1]}));
    return least;
  }

  /** How near (m) struts come to each other, on straight ways between steps. */
  double least_distance_in(const SceneText &scene)
  {
    constexpr unsigned int n_parts = 8;
    SceneRun               run(scene.str());
    Vector                 before = run.state.displacement;
    double                 least  = std::numeric_limits<double>::infinity();
    run.run([&] {
      for (unsigned int part = 1; part <= n_parts; ++part)
        {
          Vector between = before;
          for (std::size_t i = 0; i < between.size(); ++i)
            between[i] +=
              double(part) / n_parts * (run.state.displacement[i] - before[i]);
          const std::vector<Line> axes = axes_of(run, between);
          for (std::size_t one = 0; one < axes.size(); ++one)
            for (std::size_t other = 0; other < one; ++other)
              least = std::min(least, least_distance(axes[one], axes[other]));
        }
      before = run.state.displacement;
    });
    return least;
  }

  void expect_no_passing(const unsigned int dimension)
  {
    constexpr double thickness = 1e-3;
    unsigned int     n_touch = 0, n_pass = 0;
    for (unsigned int seed = 1; seed <= 10; ++seed)
      {
        SceneText    scene = thrown_struts(dimension, seed);
        const double least = least_distance_in(scene);
        // Half of the thickness is what a step may take.
        EXPECT_GT(least, 0.45 * thickness) << "seed " << seed;
        n_touch += least < thickness;
        n_pass += least_distance_in(scene.set("Effects/Contact", "off")) <
          0.1 * thickness;
      }
    EXPECT_GE(n_touch, 5u);
    EXPECT_GE(n_pass, 5u);
  }
} // namespace

TEST(NoPassing, StrutsThrownAtEachOtherInThePlane)
{
  expect_no_passing(2);
}

TEST(NoPassing, StrutsThrownAtEachOtherInSpace)
{
  expect_no_passing(3);
}
