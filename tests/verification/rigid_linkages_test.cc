#include <support/scene_run.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <array>

#include <support/pi.h>
#include <verification/label.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Linkages of rigid parts, driven, against closed forms.

namespace
{
  /** A course of angles from rest, at rate 1 (rad/s) from @p first (rad) on. */
  struct Drive
  {
    /** The ramp covers this angle (rad) in twice the time (s). */
    static constexpr double ramp = pi / 18;

    explicit Drive(const double first) : start(first - ramp)
    {}

    /** start + the integral of 3 s^2 - 2 s^3, s = t / (2 ramp). */
    std::string expression() const
    {
      const std::string T = text(2 * ramp);
      return "(" + text(start) + " + if(t < " + T + ", " + T + " * ((t/" + T +
        ")^3 - (t/" + T + ")^4 / 2), t - " + text(ramp) + "))";
    }

    const double start;
  };

  std::string position(const double x, const double y)
  {
    return text(x) + " " + text(y);
  }

  /** Prescribes x of joint 1, at @p radius from the crank's pivot. */
  SceneText crank_drive(const Drive &drive, const double radius)
  {
    return SceneText().add("Supports/drive",
                           "Joints = 1 | Type = prescribed | "
                           "Displacement x = " +
                             text(radius) + " * (cos(" + drive.expression() +
                             ") - " + text(std::cos(drive.start)) + ")");
  }

  // Numerical damping settles the multipliers: their rows have no dynamics of
  // their own, and Newmark's rule would let the start of the drive ring on.
  SceneText damped_time(const double dt, const double end)
  {
    return SceneText()
      .time(end, dt, "generalized-alpha")
      .set("Time/Spectral radius", 0.5);
  }

  struct SliderState
  {
    double x, rate, acceleration;
  };

  /**
   * Slider-crank, crank 0.15 m with a lever of 0.1 m on it, rod 0.3 m with a
   * coupler point off its line, at 30, 60, 90, 120 degrees, with n steps for
   * 10 degrees.
   */
  std::vector<SliderState> slider_crank(const unsigned int n)
  {
    const Drive  drive(pi / 9); // 10 degrees for what the ramp's end leaves
    const double p = drive.start, r = 0.15, l = 0.3;
    const double ax = r * std::cos(p), ay = r * std::sin(p),
                 bx             = ax + std::sqrt(l * l - ay * ay);
    const double             dt = pi / 18 / n;
    SceneRun                 run(SceneText()
                   .frame("0 0; " + position(ax, ay) + "; " + position(bx, 0) +
                            "; " +
                            position(-0.1 * std::sin(p), 0.1 * std::cos(p)) +
                            "; " + position((ax + bx) / 2, ay / 2 + 0.08),
                          "0 1; 0 3; 1 2; 1 4")
                   .rigid_part("crank", "0, 1", 0.5)
                   .rigid_part("rod", "2, 3", 0.7)
                   .support("pivot", "0", "pin")
                   .add(crank_drive(drive, r))
                   .support("guide", "2", "roller x")
                   .mass("slider", "2", 0.3)
                   .add(damped_time(dt, 12 * n * dt)));
    std::vector<SliderState> found;
    run.run([&] {
      const unsigned long step = run.state.step;
      if (step % (3 * n) != 0)
        return;
      const int unknown = run.model.numbering.joint_unknown(2, 0);
      found.push_back({bx + run.motion(2, 0),
                       run.velocity(2, 0),
                       (*run.state.acceleration)[unknown]});
      // The lever stays at a right angle to the crank.
      const double angle = pi / 6 * found.size();
      EXPECT_NEAR(run.motion(3, 0),
                  0.1 * (std::sin(p) - std::sin(angle)),
                  1e-9);
      EXPECT_NEAR(run.motion(3, 1),
                  0.1 * (std::cos(angle) - std::cos(p)),
                  1e-9);
    });
    return found;
  }
} // namespace

TEST(RigidLinkages, SliderCrank)
{
  const std::vector<SliderState> expected = {
    {0.4203775615, -0.1085410197, -0.1725066274},
    {0.3454163457, -0.1659326452, -0.0381977754},
    {0.2598076211, -0.15, 0.0866025404},
    {0.1954163457, -0.0938749760, 0.1118022246}};
  const auto coarse = slider_crank(20), fine = slider_crank(40);
  ASSERT_EQ(coarse.size(), 4u);
  ASSERT_EQ(fine.size(), 4u);
  ComparisonTable table("Slider-crank driven at 1 rad/s: slider");
  for (unsigned int i = 0; i < 4; ++i)
    {
      const std::string at    = label(", deg", 30 * (i + 1));
      const auto       &exact = expected[i];
      // Positions follow from the constraints alone: ten digits are given.
      table.row("x" + at, fine[i].x, exact.x, 1e-9);
      // dt^2 = 2e-5 of the second and third derivatives.
      table.row("x'" + at, fine[i].rate, exact.rate, 1e-5);
      table.row("x''" + at, fine[i].acceleration, exact.acceleration, 1e-5);
      table.row("order of x'" + at,
                std::log2((coarse[i].rate - exact.rate) /
                          (fine[i].rate - exact.rate)),
                2,
                0.2);
    }
}

namespace
{
  struct FourBarState
  {
    double coupler, rocker, coupler_ratio, rocker_ratio;
  };

  /**
   * Four-bar linkage, ground 1, crank 0.4, coupler 1.2, rocker 0.8 m, open or
   * crossed, when the driven crank is at 40 degrees.
   */
  FourBarState four_bar(const bool is_open, const unsigned int n)
  {
    const Drive  drive(pi / 6);
    const double p = drive.start, ax = 0.4 * std::cos(p),
                 ay = 0.4 * std::sin(p);
    // The joint of coupler and rocker: on circles about (ax, ay) and (1, 0).
    const double dx = 1 - ax, dy = -ay, distance = std::hypot(dx, dy),
                 along  = (1.44 - 0.64 + distance * distance) / (2 * distance),
                 across = (is_open ? 1 : -1) * std::sqrt(1.44 - along * along);
    const double bx     = ax + (along * dx - across * dy) / distance,
                 by     = ay + (along * dy + across * dx) / distance;
    const double dt     = pi / 18 / n;
    SceneRun     run(
      SceneText()
        .frame("0 0; " + position(ax, ay) + "; " + position(bx, by) + "; 1 0",
               "0 1; 1 2; 2 3")
        .add("Rigid parts/bars",
             "Struts = all | Parts = single struts | Mass = 1")
        .support("pivot", "0, 3", "pin")
        .add(crank_drive(drive, 0.4))
        .add(damped_time(dt, 3 * n * dt)));
    run.run();

    const auto angle_and_rate = [&](const unsigned int from,
                                    const unsigned int to) {
      const auto  &r0 = run.lattice.joints[from], &r1 = run.lattice.joints[to];
      const double x  = r1[0] + run.motion(to, 0) - r0[0] - run.motion(from, 0),
                   y  = r1[1] + run.motion(to, 1) - r0[1] - run.motion(from, 1),
                   vx = run.velocity(to, 0) - run.velocity(from, 0),
                   vy = run.velocity(to, 1) - run.velocity(from, 1);
      return std::array<double, 2>{
        {std::atan2(y, x) * 180 / pi, (x * vy - y * vx) / (x * x + y * y)}};
    };
    const auto crank = angle_and_rate(0, 1), coupler = angle_and_rate(1, 2),
               rocker = angle_and_rate(3, 2);
    EXPECT_NEAR(crank[0], 40, 1e-9);
    // dt^2 = 2e-5, four times that with the coarser steps.
    EXPECT_NEAR(crank[1], 1, 1e-4);
    return {coupler[0], rocker[0], coupler[1], rocker[1]};
  }
} // namespace

TEST(RigidLinkages, FourBarLinkage)
{
  const FourBarState expected[2] = {
    {-60.9779668, -98.00496408, -0.3703508920, -0.8151068783},
    {20.29788279, 57.32488007, -0.1648365766, 0.2799194097}};
  ComparisonTable table("Four-bar linkage, crank at 40 degrees and 1 rad/s");
  for (const bool is_open : {true, false})
    {
      const FourBarState &exact = expected[is_open];
      const FourBarState  fine  = four_bar(is_open, 40),
                         coarse = four_bar(is_open, 20);
      const std::string name    = is_open ? "open: " : "crossed: ";
      // Seven to eight decimals are given.
      table.row(name + "coupler (deg)", fine.coupler, exact.coupler, 6e-8);
      table.row(name + "rocker (deg)", fine.rocker, exact.rocker, 6e-8);
      // Twice dt^2 = 2e-5 of the third derivatives.
      // Twice dt^2 = 2e-5 of the third derivatives.
      table.row(name + "w3 / w2",
                fine.coupler_ratio,
                exact.coupler_ratio,
                4e-5);
      table.row(name + "w4 / w2", fine.rocker_ratio, exact.rocker_ratio, 4e-5);
      table.row(name + "order of w4",
                std::log2((coarse.rocker_ratio - exact.rocker_ratio) /
                          (fine.rocker_ratio - exact.rocker_ratio)),
                2,
                0.2);
    }
}
