#include <analysis/verdict/findings_of.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>
#include <cstdlib>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double rod_modulus = 70e9, rod_radius = 2e-3, rod_span = 0.5;

  /** A rod with a transverse load in its middle. */
  SceneText pushed_rod(const std::string &held_joints, const double force)
  {
    return SceneText()
      .frame("0 0; 0.25 0; 0.5 0", "0 1; 1 2")
      .circle("rod", rod_radius, {rod_modulus, 2700})
      .support("held", held_joints, "clamp")
      .add("Loads/push", "Joints = 1 | Force y = " + text(force) + " * t")
      .set("Effects/Large rotation", "off")
      .time(1, 0.1, "static");
  }

  /**
   * Relative decrease of the linear deflection of a clamped rod by its
   * stretch, with a cosine shape:
   *
   *     P = 192 EI / L^3 (w + A / (16 I) w^3)
   *
   * (S. Timoshenko, S. Woinowsky-Krieger, Theory of Plates and Shells, 1959,
   * chapter 1, energy method).
   */
  double error_by_stretching(const double force)
  {
    const double linear = force * std::pow(rod_span, 3) /
      (192 * rod_modulus * pi * std::pow(rod_radius, 4) / 4),
                 cubic = 4 / (rod_radius * rod_radius) / 16;
    double w           = linear;
    for (unsigned int i = 0; i < 100; ++i)
      w -= (w + cubic * w * w * w - linear) / (1 + 3 * cubic * w * w);
    return 1 - w / linear;
  }

  /** The number before ` %`, as a fraction. */
  double percentage_in(const std::string &text)
  {
    const std::size_t end = text.find(" %"), begin = text.rfind(' ', end - 1);
    return std::atof(text.substr(begin, end - begin).c_str()) / 100;
  }
} // namespace

TEST(ComparisonWithLargeRotation, KnowsTheStretchOfClampedStruts)
{
  for (const double force : {2., 4., 8., 16.})
    {
      const double expected = error_by_stretching(force);
      const auto   found    = findings_of(pushed_rod("0, 2", force));
      ASSERT_EQ(found.size(), 1u) << force;
      EXPECT_EQ(found[0].verdict,
                expected > 0.25 ? Verdict::not_to_be_used : Verdict::doubtful);
      EXPECT_NEAR(percentage_in(found[0].text), expected, 0.03)
        << found[0].text;
    }
}

TEST(ComparisonWithLargeRotation, IsSilentIfTheStretchIsSmall)
{
  // Either a stretch effect below 1 %, or one end free to move.
  EXPECT_LT(error_by_stretching(0.5), 0.01);
  EXPECT_TRUE(findings_of(pushed_rod("0, 2", 0.5)).empty());
  EXPECT_TRUE(findings_of(pushed_rod("0", 2)).empty());
}
