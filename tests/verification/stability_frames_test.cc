#include <gtest/gtest.h>
#include <support/scene_text.h>
#include <verification/deep_arch.h>
#include <verification/hard_case.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// The catalogue of hard cases: frames that lose their stability.

namespace
{
  /** A rod between a clamp and an end that turns about its axis and moves along
   * it, pushed a little to a side. EI = 1.2566e-2 N m2, L = 1 m. */
  HardCase twisted_shaft()
  {
    SceneText scene;
    scene.dimension(3)
      .frame("0 0 0; 0.5 0 0; 1 0 0", "0 1; 1 2")
      .circle("rod", 0.002, {1e9, 1000, 0.3})
      .support("clamp", "0", "clamp")
      .prescribe("bearing", "2", {"free", "0", "0"}, {"free", "0", "0"})
      .load("torque", "2", {"0", "0", "0"}, {"0.11293 * t / 2", "0", "0"})
      .load("push", "1", {"0", "1e-4", "0"}, {"0", "0", "0"})
      .mesh(3, 1)
      .time(2.4, 5e-3);
    return {"A shaft twisted a fifth beyond Greenhill's torque", scene.str()};
  }

  /** Largest motion in the last third over that in the first. */
  double growth(const Course &course)
  {
    const std::size_t n     = course.motions.size();
    double            first = 0, last = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (const double motion : course.motions[i])
        if (i < n / 3)
          first = std::max(first, std::abs(motion));
        else if (i >= n - n / 3)
          last = std::max(last, std::abs(motion));
    return last / first;
  }

  /** Largest motion of a joint in a direction, over time (m). */
  double largest_motion(const Course &course, const unsigned int motion)
  {
    double largest = 0;
    for (const auto &motions : course.motions)
      largest = std::max(largest, std::abs(motions.at(motion)));
    return largest;
  }

  /** Beck's column, L = EI = 1 and 1 kg, of a strut and a @p part of its flutter
   * load, that a push at the start sets swinging, for some periods. */
  HardCase becks_column(const std::string &title, const double part)
  {
    SceneText scene;
    scene.frame("0 0; 0 1", "0 1")
      .section({1e5, 1e5, 1})
      .set("Sections/section 0/Density", 1e-5)
      .support("clamp", "0", "clamp")
      .load("turning", "1", {"0", text(-20.0509 * part), "0"})
      .set("Loads/turning/Direction", "follows the joint")
      .load("push", "1", {"0.01 * sin(2 * pi * min(t, 0.5))", "0", "0"})
      .mesh(4, 1)
      .time(3, 5e-3)
      .set("Time/Start from", "static equilibrium");
    return {title, scene.str()};
  }

  /** Half of Von Mises' truss, the apex of which moves up and down alone. */
  HardCase von_mises_truss()
  {
    SceneText scene;
    scene.frame("0 0; 1 0.2", "0 1")
      .section({1e6, 1e6, 1e4})
      .set("Sections/section 0/Density", 1e-6)
      .support("foot", "0", "pin")
      .prescribe("slide", "1", {"0", "free", "free"})
      .mass("apex", "1", 5)
      .load("weight", "1", {"0", "-1800 * min(t / 0.3, 1)", "0"})
      .mesh(2)
      .time(0.5, 0.5e-3);
    return {"Von Mises' truss snaps through", scene.str()};
  }

  /** Half of Williams' toggle (in, lb, s) under a load that grows slowly beyond
   * its limit load, 33.87 lb of the whole. */
  HardCase williams_toggle()
  {
    SceneText scene;
    scene.frame("0 0; 12.943 0.386", "0 1")
      .rectangle("member", 0.753, 0.243, {10.3e6, 2.54e-4, 0.33})
      .support("wall", "0", "clamp")
      .prescribe("symmetry", "1", {"0", "free", "0"})
      .load("weight", "1", {"0", "-20 * min(t / 40e-3, 1)", "0"})
      .mesh(3, 1)
      .time(60e-3, 0.1e-3);
    return {"Williams' toggle snaps through", scene.str()};
  }

  /** The frame of Lee, Manuel & Rossow, 1.2 m high, under a load that grows
   * slowly beyond its limit load of 18557 N. */
  HardCase lee_frame()
  {
    SceneText scene;
    scene.frame("0 0; 0 1.2; 0.24 1.2; 1.2 1.2", "0 1; 1 2; 2 3")
      .rectangle("bar", 0.03, 0.02, {72e9, 2700, 0.3})
      .support("hinges", "0, 3", "pin")
      .load("weight", "2", {"0", "-20000 * min(t / 0.2, 1)", "0"})
      .mesh(4, 1)
      .time(0.3, 0.2e-3);
    return {"Lee's frame snaps back", scene.str()};
  }

  /** A load on its crown grows slowly beyond the limit load, 897. */
  HardCase snapping_arch()
  {
    SceneText scene = deep_arch();
    scene.set("Sections/section 0/Density", 1e-12)
      .load("weight", "1", {"0", "-1000 * min(t / 4, 1)", "0"})
      .mesh(4, 1)
      .time(4.4, 2e-3);
    return {"A deep arch snaps through", scene.str()};
  }

  /** A cantilever strip on edge, pushed a little to a side, under a force at
   * its end that grows beyond that of Prandtl, 4.013 sqrt(EI GJ) / L^2. */
  HardCase prandtls_strip()
  {
    SceneText scene;
    scene.dimension(3)
      .frame("0 0 0; 0.5 0 0; 1 0 0", "0 1; 1 2")
      .space_section({1e6, 1e6, 1e6, 1, 1, 1000})
      .set("Sections/all/Density", 1e-6)
      .support("clamp", "0", "clamp")
      .load("end", "2", {"0", "-4.8 * min(t / 5, 1)", "0"}, {"0", "0", "0"})
      .load("push", "2", {"0", "0", "1e-3"}, {"0", "0", "0"})
      .mesh(3, 1)
      .time(10, 20e-3);
    return {"A strip buckles sideways", scene.str()};
  }
} // namespace

TEST(StabilityOfFrames, TwistedShaft)
{
  go_through(twisted_shaft());
}

// Below the flutter load the vibration goes on as it began, beyond it grows.
TEST(StabilityOfFrames, BecksColumn)
{
  const Course below = go_through(
                 becks_column("Beck's column, 0.9 of its flutter load", 0.9)),
               beyond = go_through(
                 becks_column("Beck's column, 1.1 of its flutter load", 1.1));
  EXPECT_LT(growth(below), 2);
  EXPECT_GT(growth(beyond), 50);
}

// The apex goes to where the truss hangs below its feet.
TEST(StabilityOfFrames, VonMisesTruss)
{
  const Course reference = go_through(von_mises_truss());
  EXPECT_GT(largest_motion(reference, 3), 2 * 0.2);
}

TEST(StabilityOfFrames, WilliamsToggle)
{
  const Course reference = go_through(williams_toggle());
  EXPECT_GT(largest_motion(reference, 3), 0.386);
}

// The loaded joint is 0.49 m lower at the limit load.
TEST(StabilityOfFrames, LeesFrame)
{
  const Course reference = go_through(lee_frame());
  EXPECT_GT(largest_motion(reference, 5), 0.8);
}

// At the limit load the crown is 113 lower; it falls below the feet.
TEST(StabilityOfFrames, DeepArch)
{
  const Course reference = go_through(snapping_arch());
  EXPECT_GT(largest_motion(reference, 3), 150);
}

// The push alone moves the end by 0.33 mm.
TEST(StabilityOfFrames, PrandtlsStrip)
{
  const Course reference = go_through(prandtls_strip());
  EXPECT_GT(largest_motion(reference, 8), 0.1);
}
