#include <support/followed_path.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Divergence under loads that follow the structure, where the stiffness is not
// symmetric: singular points by the sign of its determinant.

namespace
{
  /** Axial and shear stiffness of columns, whose strains change loads by 1e-6.
   */
  constexpr double stout = 1e7;

  /** Adds a force of @p force down the column at @p joint, of which the part
   * @p follower turns with the joint. */
  SceneText &press(SceneText         &column,
                   const std::string &joint,
                   const double       force,
                   const double       follower)
  {
    column
      .load("dead", joint, {"0", text(-force * (1 - follower)) + " * t", "0"})
      .load("turning", joint, {"0", text(-force * follower) + " * t", "0"})
      .set("Loads/turning/Direction", "follows the joint")
      .time(1, 1);
    return column;
  }

  /** L = EI = 1, clamped below. */
  SceneText column(const double force, const double follower)
  {
    SceneText scene = static_frame("0 0; 0 1", "0 1");
    scene.section({stout, stout, 1}).support("clamp", "0", "clamp").mesh(4, 3);
    return press(scene, "1", force, follower);
  }

  /** kL at which a column has other equilibria: cos kL = -a/(1 - a). */
  double first_kl(const double follower)
  {
    return std::acos(-follower / (1 - follower));
  }

  TEST(FollowerStability, ColumnUnderAPartlyTangentialLoad)
  {
    ComparisonTable table("Column clamped below, the part a of its load turns "
                          "with the top: divergence, closed form");
    const double    force = 25;
    for (const double follower : {0., 0.2, 0.4, 0.49})
      {
        const FollowedPath path(column(force, follower).str());
        const auto         found = path.bifurcations();
        ASSERT_EQ(path.limits().size(), 0u);
        ASSERT_EQ(found.size(), 2u) << follower;
        const double      first = first_kl(follower);
        const std::string at    = "a = " + text(follower) + ": ";
        table.relative(at + "first",
                       force * found[0].load_factor,
                       first * first,
                       2e-5);
        table.relative(at + "second",
                       force * found[1].load_factor,
                       std::pow(2 * pi - first, 2),
                       2e-5);
      }
  }

  TEST(FollowerStability, WhatIsNoDivergenceIsNotSeen)
  {
    // From a = 1/2 on columns flutter, by Beck (1952) at 20.05 if a = 1.
    for (const double follower : {0.55, 1.})
      {
        const FollowedPath path(column(30, follower).str());
        EXPECT_EQ(path.points.back().load_factor, 1.);
        EXPECT_TRUE(path.singular_points.empty());
        for (const FollowedPath::Point &point : path.points)
          EXPECT_EQ(point.determinant_sign, 1);
      }
  }

  /** As above with a rigid bar of the length @p bar on top, on which the load
   * acts. */
  double rigid_top_kl(const double bar, const double follower)
  {
    // w = A (sin kx - kx) + B (cos kx - 1), with the moment
    // (1 - a) P bar w' and the shear force -(1 - a) P w' at the end.
    const auto determinant = [&](const double kl) {
      const double c = std::cos(kl), s = std::sin(kl), dead = 1 - follower,
                   arm      = dead * bar * kl;
      const double moment_a = -s - arm * (c - 1), moment_b = -c + arm * s,
                   shear_a = -c + dead * (c - 1), shear_b = s - dead * s;
      return moment_a * shear_b - moment_b * shear_a;
    };
    double low = 1e-3, high = low;
    while (determinant(high) * determinant(low) > 0)
      high += 1e-3;
    low = high - 1e-3;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = (low + high) / 2;
        (determinant(middle) * determinant(low) > 0 ? low : high) = middle;
      }
    return low;
  }

  TEST(FollowerStability, ColumnWithARigidTop)
  {
    ComparisonTable table("Column with a rigid bar on top, the part a of the "
                          "load on it turns with it: divergence, closed form");
    const double    force = 8, bar = 0.4;
    for (const double follower : {0., 0.15, 0.3})
      for (const bool in_space : {false, true})
        {
          // A following load needs an elastic strut, short and stiff.
          const std::string joints = "0 0; 0 1; 0 1.38; 0 1.4",
                            struts = "0 1; 1 2; 2 3";
          SceneText scene = in_space ? static_space_frame(joints, struts)
                                     : static_frame(joints, struts);
          if (in_space)
            scene.space_section({stout, stout, stout, 1, 1.7, 1});
          else
            scene.given("all", {stout, stout, 1}, {1, "", -0.5});
          scene.set("Sections/all/Struts", "0, 1")
            .set("Sections/end/Struts", "2")
            .rectangle("end", 1, 1, {1e4, "", 0})
            .support("clamp", "0", "clamp")
            .rigid_part("bar", "1", 1)
            .set("Rigid parts/bar/Elastic struts", "clamped")
            .mesh(4, 1);
          press(scene, "3", force, follower);
          const FollowedPath path(scene.str());
          ASSERT_FALSE(path.bifurcations().empty());
          const double kl = rigid_top_kl(bar, follower);
          table.relative("a = " + text(follower) +
                           (in_space ? ", in space" : ", in the plane"),
                         force * path.bifurcations()[0].load_factor,
                         kl * kl,
                         2e-5);
        }
  }

  TEST(FollowerStability, ColumnInSpace)
  {
    const double    force = 20, follower = 0.3, other = 1.7;
    SceneText       scene = static_space_frame("0 0; 0 1", "0 1");
    ComparisonTable table("Column in space, 30 % of its load turn with the "
                          "top, EI = 1 and 1.7: divergence, closed form");
    scene.space_section({stout, stout, stout, 1, other, 1})
      .support("clamp", "0", "clamp")
      .mesh(4, 3);
    const FollowedPath path(press(scene, "1", force, follower).str());
    const auto         found = path.bifurcations();
    const double       first = first_kl(follower);
    ASSERT_EQ(found.size(), 3u);
    table.relative("first", force * found[0].load_factor, first * first, 2e-5);
    table.relative("first of the stiffer direction",
                   force * found[1].load_factor,
                   other * first * first,
                   2e-5);
    table.relative("second",
                   force * found[2].load_factor,
                   std::pow(2 * pi - first, 2),
                   2e-5);
  }

  /** The arc of R = EI = 1 from the angle @p begin to @p end in @p n chords,
   * which are arcs, pressed by forces in its joints. @p half_ends: whether what
   * lies beyond is its mirror image. */
  SceneText pressed_arc(const double       begin,
                        const double       end,
                        const unsigned int n,
                        const double       pressure,
                        const bool         follows,
                        const bool         half_ends)
  {
    std::string  joints, struts;
    const double step = (end - begin) / n, rise = 1 - std::cos(step / 2);
    SceneText    scene = static_scene();
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double angle = begin + i * step, x = std::cos(angle),
                     y = std::sin(angle);
        joints += (i > 0 ? "; " : "") + text(x) + " " + text(y);
        if (i > 0)
          struts += (i > 1 ? "; " : "") + std::to_string(i - 1) + " " +
            std::to_string(i) + " " + text(-rise);
        const bool is_end = i == 0 || i == n;
        if (is_end && !half_ends)
          continue;
        // Balances the chords on both sides of it in a state without bending.
        const double      force = pressure * step * (is_end ? 0.5 : 1);
        const std::string name  = "joint " + std::to_string(i);
        scene.load(name,
                   std::to_string(i),
                   {text(-force * x) + " * t", text(-force * y) + " * t", "0"});
        if (follows)
          scene.set("Loads/" + name + "/Direction", "follows the joint");
      }
    scene.frame(joints, struts).section({1e6, 1e6, 1}).mesh(3).time(1, 1);
    return scene;
  }

  /** From values with n, 2 n and 4 n chords, the error of which begins with
   * 1/n^2 and 1/n^4. */
  double
  extrapolated_load(const double coarse, const double middle, const double fine)
  {
    const double one   = (4 * middle - coarse) / 3,
                 other = (4 * fine - middle) / 3;
    return (16 * other - one) / 15;
  }

  template <class SceneOf>
  double first_pressure(const SceneOf &scene_of, const double pressure)
  {
    std::vector<double> found;
    for (const unsigned int n : {8, 16, 32})
      {
        const FollowedPath path(scene_of(n).str());
        EXPECT_FALSE(path.bifurcations().empty());
        if (path.bifurcations().empty())
          return 0;
        found.push_back(pressure * path.bifurcations()[0].load_factor);
      }
    return extrapolated_load(found[0], found[1], found[2]);
  }

  TEST(FollowerStability, RingsAndArchesUnderPressure)
  {
    ComparisonTable table("Inextensible rings and arches under forces in "
                          "joints, ever more of them: pressure of divergence, "
                          "closed forms");
    const auto      ring = [&](const bool follows) {
      const double pressure = 6;
      return first_pressure(
        [&](const unsigned int n) {
          SceneText scene = pressed_arc(0, pi / 2, n, pressure, follows, true);
          scene.prescribe("side", "0", {"free", "0", "0"})
            .prescribe("top", std::to_string(n), {"0", "free", "0"});
          return scene;
        },
        pressure);
    };
    table.relative("ring, hydrostatic pressure: 3 EI/R3", ring(true), 3, 1e-4);
    table.relative("ring, dead pressure: 4 EI/R3", ring(false), 4, 1e-4);
    const double pressure = 12;
    table.relative(
      "arch of 120 degrees on hinges, hydrostatic: 8 EI/R3",
      first_pressure(
        [&](const unsigned int n) {
          SceneText scene =
            pressed_arc(pi / 6, 5 * pi / 6, n, pressure, true, false);
          scene.support("feet", "0, " + std::to_string(n), "pin");
          return scene;
        },
        pressure),
      8,
      1e-4);
  }
} // namespace
