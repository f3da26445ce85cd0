#include <auxfem/output/recorder.h>
#include <auxfem/simulation.h>
#include <auxfem/time/dense_output.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// Solutions within steps, as rows of a history with an interval of its own.
// The orders of schemes with stages:
// tests/verification/runge_kutta_order_test.cc.

namespace
{
  /**
   * Columns of the history at multiples of @p interval (s), or at steps if it
   * is 0.
   */
  MemoryRecorder history_of(SceneText scene, const double interval)
  {
    if (interval > 0)
      scene.set("Output/Time between rows", interval);
    const Scene    read = read_scene_from_text(scene.str(), "test.prm");
    MemoryRecorder history(read, MPI_COMM_WORLD);
    run(read, MPI_COMM_WORLD, history);
    return history;
  }

  double largest_difference(const std::vector<double> &one,
                            const std::vector<double> &other)
  {
    EXPECT_EQ(one.size(), other.size());
    double largest = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
      largest = std::max(largest, std::abs(one[i] - other.at(i)));
    return largest;
  }

  /** A soft angle with a Maxwell element, struck at its end at 0.1 s. */
  SceneText struck_angle(const unsigned int dimension)
  {
    SceneText scene;
    scene.dimension(dimension).frame(dimension == 2 ? "0 0; 2 0; 2 2"
                                                    : "0 0 0; 2 0 0; 2 2 0.6",
                                     "0 1; 1 2");
    scene.circle("rod", 0.08, {4e6, 1000, 0.3});
    scene.support("clamp", "0", "clamp");
    scene.set("Loads/push/Joints", "2");
    scene.set("Loads/push/Force x", "if(t < 0.1, 0, -8)");
    if (dimension == 3)
      scene.set("Loads/push/Force z", "4 * t");
    scene.connector("damper",
                    "maxwell",
                    std::string("Between = ground: 2 | Ground offset = ") +
                      (dimension == 2 ? "0.3 0.5" : "0.3 0.5 0.2") +
                      " | Spring stiffness = 40 | Damping coefficient = 2");
    scene.probe("tip", "2");
    return scene.mesh(1).time(0.32, 0.004).set("Newton/Tolerance", "1e-12");
  }
} // namespace

TEST(DenseOutput, RowsAtEndsOfStepsAreThoseOfTheSteps)
{
  const SceneText      scene   = struck_angle(3);
  const MemoryRecorder by_step = history_of(scene, 0),
                       by_time = history_of(scene, 0.004);
  EXPECT_EQ(by_step.rows().size(), 81u);
  EXPECT_EQ(by_step.rows(), by_time.rows());
}

TEST(DenseOutput, DoesNotChangeTheSteps)
{
  const SceneText      scene      = struck_angle(3);
  const MemoryRecorder by_step    = history_of(scene, 0),
                       by_time    = history_of(scene, 0.0005);
  const std::vector<double> steps = by_step.column("tip.uy"),
                            times = by_time.column("tip.uy");
  ASSERT_EQ(times.size(), 641u);
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(steps[i], times[8 * i]);
}

TEST(DenseOutput, IsOfSecondOrderWithTheAlphaFamily)
{
  for (const unsigned int dimension : {2, 3})
    {
      // Steps would not resolve the motion that a jump excites.
      const SceneText scene =
        struck_angle(dimension).set("Loads/push/Force x", "-800 * t^3");
      const auto by = [&scene](const char *scheme, const double step) {
        return history_of(SceneText(scene)
                            .set("Time/Scheme", scheme)
                            .set("Time/Time step", step),
                          0.0007);
      };
      const MemoryRecorder reference = by("esdirk", 0.002);
      for (const char *scheme : {"newmark", "generalized-alpha", "hht"})
        {
          const MemoryRecorder coarse = by(scheme, 0.002),
                               fine   = by(scheme, 0.001);
          for (const char *column :
               {"tip.ux", "tip.vx", "damper.force", "dissipated", "external"})
            {
              const std::vector<double> exact = reference.column(column);
              const double              order =
                std::log2(largest_difference(exact, coarse.column(column)) /
                          largest_difference(exact, fine.column(column)));
              EXPECT_NEAR(order, 2, 0.3)
                << dimension << "D " << scheme << ' ' << column;
            }
        }
    }
}

TEST(DenseOutput, MotionsOfSupportsAreExact)
{
  SceneText scene = struck_angle(3);
  scene.set("Supports/clamp/Type", "prescribed");
  for (const char *component : {"Displacement x",
                                "Displacement y",
                                "Rotation x",
                                "Rotation y",
                                "Rotation z"})
    scene.set(std::string("Supports/clamp/") + component, "0");
  scene.set("Supports/clamp/Displacement z", "0.1 * sin(20 * t)")
    .probe("base", "0");
  const MemoryRecorder      history  = history_of(scene, 0.0011);
  const std::vector<double> time     = history.column("time"),
                            position = history.column("base.uz"),
                            velocity = history.column("base.vz");
  for (std::size_t i = 0; i < time.size(); ++i)
    {
      EXPECT_NEAR(position[i], 0.1 * std::sin(20 * time[i]), 1e-15);
      EXPECT_NEAR(velocity[i], 2 * std::cos(20 * time[i]), 1e-12);
    }
}

TEST(DenseOutput, WorkWithStagesIsThatOfLoadsBeforeTheyJump)
{
  // The eighth step ends at 0.1 s and has rows within.
  const MemoryRecorder history =
    history_of(struck_angle(2)
                 .set("Loads/push/Force x", "if(t < 0.1, 80 * t, -8)")
                 .set("Time/Scheme", "esdirk")
                 .set("Time/Time step", 0.0125)
                 .set("Time/End time", 0.1125),
               0.0025);
  const double largest = history.column("external").back();
  for (const double balance : history.column("balance"))
    EXPECT_NEAR(balance, 0, 1e-3 * largest);
}

TEST(DenseOutput, IsLinearWithoutInertia)
{
  SceneText scene;
  scene.frame("0 0; 1 0", "0 1").circle("rod", 0.02, {4e6, 1000, 0.3});
  scene.support("clamp", "0", "clamp").probe("tip", "1");
  scene.set("Loads/pull/Joints", "1").set("Loads/pull/Force x", "10 * t");
  scene.mesh(1).time(1, 0.25).set("Time/Scheme", "static");
  const MemoryRecorder      history = history_of(scene, 0.1);
  const std::vector<double> u       = history.column("tip.ux"),
                            work    = history.column("external");
  ASSERT_EQ(u.size(), 11u);
  for (unsigned int i = 0; i < u.size(); ++i)
    EXPECT_NEAR(u[i], i / 10. * u.back(), 1e-3 * u.back());
  // Work is quadratic in the load: 0.4 is on the chord from 0.25 to 0.5.
  EXPECT_NEAR(work[4],
              (0.0625 + 0.6 * (0.25 - 0.0625)) * work.back(),
              1e-3 * work.back());
}

TEST(DenseOutput, ForcesOfStiffStrutsAreThoseOfTheSteps)
{
  // A rod of mass m and length l that rotates about its end with w: m w^2 l /
  // 2 at the support, N = m w^2 (l^2 - x^2) / 2l along it.
  SceneText scene;
  scene.frame("0 0; 0 0.02", "0 1").circle("rod", 5e-4, {70e9, 1500});
  scene.support("pin", "0", "pin")
    .add("Initial velocities/spin",
         "Joints = all | Angular velocity z = 40 | Velocity x = -0.4");
  scene.time(0.02, 5e-4);
  const double area = std::acos(-1.) * 5e-4 * 5e-4, mass = 1500 * area * 0.02,
               force  = mass * 40 * 40 * 0.02 / 2,
               strain = 4 * force * force * 0.02 / (15 * 70e9 * area);
  for (const char *scheme :
       {"newmark", "generalized-alpha", "hht", "energy-momentum", "esdirk"})
    {
      const MemoryRecorder history =
        history_of(SceneText(scene).set("Time/Scheme", scheme), 1.7e-4);
      const std::vector<double> x       = history.column("pin.rx"),
                                y       = history.column("pin.ry"),
                                stored  = history.column("strain"),
                                kinetic = history.column("kinetic"),
                                balance = history.column("balance");
      for (std::size_t i = 1; i < x.size(); ++i)
        {
          // The rod starts without strain and vibrates about its mean stretch.
          EXPECT_LE(std::hypot(x[i], y[i]), 2.1 * force) << scheme << ' ' << i;
          EXPECT_LE(stored[i], 4.5 * strain) << scheme << ' ' << i;
          EXPECT_NEAR(balance[i], 0, 1e-3 * kinetic[0]) << scheme << ' ' << i;
        }
    }
}
