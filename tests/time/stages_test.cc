#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// Runge-Kutta steps with prescribed rotations in space. The orders of free
// motions: tests/verification/runge_kutta_order_test.cc.

namespace
{
  /**
   * A soft angle in space, rotated by a strong load; its foot is free to
   * rotate.
   */
  SceneText pushed_angle()
  {
    SceneText scene;
    scene.dimension(3).frame("0 0 0; 2 0 0; 2 2 0.6", "0 1; 1 2");
    scene.circle("rod", 0.08, {4e6, 1000, 0.3});
    scene.load("push",
               "2",
               {"-8000 * t^3", "-16000 * t^3", "20000 * t^3"},
               {"0", "0", "0"});
    return scene.mesh(1).time(0.24, 0.001).set("Newton/Tolerance", "1e-13");
  }

  SceneText with_foot(SceneText scene, const SpaceTexts &rotation)
  {
    return scene.prescribe("foot", "0", {"0", "0", "0"}, rotation);
  }

  /** Displacements (m) of the free joints of @p scene at its end by @p scheme. */
  std::vector<double>
  motion_at_end(SceneText scene, const std::string &scheme, const double dt)
  {
    SceneRun run(
      scene.set("Time/Scheme", scheme).set("Time/Time step", dt).str());
    run.run();
    std::vector<double> motion;
    for (const unsigned int joint : {1, 2})
      for (unsigned int c = 0; c < 3; ++c)
        motion.push_back(run.motion(joint, c));
    return motion;
  }

  double distance(const std::vector<double> &one,
                  const std::vector<double> &other)
  {
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      largest = std::max(largest, std::abs(one[i] - other.at(i)));
    return largest;
  }

  void expect_fourth_order(const SceneText &scene)
  {
    const auto reference = motion_at_end(scene, "esdirk", 0.0005);
    EXPECT_LT(distance(motion_at_end(scene, "newmark", 0.0005), reference),
              1e-4);
    const double coarse =
                   distance(motion_at_end(scene, "esdirk", 0.002), reference),
                 fine =
                   distance(motion_at_end(scene, "esdirk", 0.001), reference);
    EXPECT_LT(fine, 1e-8);
    EXPECT_NEAR(std::log2(coarse / fine), 4, 0.3);
  }
} // namespace

TEST(Stages, KeepTheirOrderWhereASupportTurnsAboutAllAxes)
{
  expect_fourth_order(
    with_foot(pushed_angle(), {"6 * t^2", "1.5 * sin(8 * t)^2", "4 * t^2"}));
}

TEST(Stages, KeepTheirOrderWhereASupportHoldsTheRotationAboutOneAxis)
{
  expect_fourth_order(with_foot(pushed_angle(), {"free", "0", "free"}));
}

TEST(Stages, KeepTheirOrderWhereASupportHoldsTheRotationAboutTwoAxes)
{
  expect_fourth_order(with_foot(pushed_angle(), {"free", "0", "0"}));
}
