#include <auxfem/output/recorder.h>
#include <auxfem/simulation.h>

#include <gtest/gtest.h>
#include <support/scene_run.h>
#include <support/scene_text.h>

#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

// Straight cables, which resist transverse loads by tension only.

namespace
{
  constexpr double cable_span = 10, cable_axial = 1e6,
                   cable_weight = 49.05; ///< m, N, N/m

  /** EA = 1e6 N, EI = 0.1 N m2, 5 kg/m, between two pins. */
  SceneText cable()
  {
    return SceneText()
      .frame("0 0; 5 0; 10 0", "0 1; 1 2")
      .given("rope", {1e-5, 1e-5, 1e-12}, {100e9, 5e5})
      .support("left", "0", "pin")
      .support("right", "2", "pin")
      .probe("mid", "1")
      .mesh(4, 3);
  }

  struct Catenary
  {
    double sag, pull; ///< m, N
  };

  /**
   * The elastic catenary (H. M. Irvine, Cable Structures, 1981, section 1.4) of
   * a cable as long as its span under @p w (N/m) of its unstretched length.
   */
  Catenary catenary(const double w)
  {
    const auto span_of = [w](const double pull) {
      return pull * cable_span / cable_axial +
        2 * pull / w * std::asinh(w * cable_span / (2 * pull));
    };
    double low = 1, high = cable_axial;
    while (high - low > 1e-12 * high)
      {
        const double pull                         = (low + high) / 2;
        (span_of(pull) < cable_span ? low : high) = pull;
      }
    return {w * cable_span * cable_span / (8 * cable_axial) +
              low / w * (std::hypot(1, w * cable_span / (2 * low)) - 1),
            low};
  }

  MemoryRecorder sound_history_of(const SceneText &text)
  {
    const Scene     scene = read_scene_from_text(text.str(), "test.prm");
    MemoryRecorder  history(scene, MPI_COMM_SELF);
    const RunResult result = run(scene, MPI_COMM_SELF, history);
    EXPECT_TRUE(result.findings.empty()) << verdict_text(result.findings);
    return history;
  }

  void expect_catenary(const MemoryRecorder &history,
                       const std::size_t     row,
                       const double          w)
  {
    const Catenary right = catenary(w);
    // Bending adds boundary layers at the pins.
    EXPECT_NEAR(history.column("mid.uy").at(row), -right.sag, 1e-3 * right.sag);
    EXPECT_NEAR(history.column("right.rx").at(row),
                right.pull,
                1e-3 * right.pull);
  }
} // namespace

TEST(SlackCable, HangsUnderItsOwnWeight)
{
  const Catenary right = catenary(cable_weight);
  EXPECT_NEAR(right.sag, 0.28460, 1e-5);
  EXPECT_NEAR(right.pull, 2152.0, 0.1);
  const MemoryRecorder history = sound_history_of(
    cable().set("Gravity/Acceleration y", "-9.81").time(1, 0.25, "static"));
  for (const std::size_t row : {1, 4})
    expect_catenary(history, row, cable_weight);
}

TEST(SlackCable, WeightCanBeAFunctionOfTime)
{
  const MemoryRecorder history = sound_history_of(
    cable().set("Gravity/Acceleration y", "-9.81 * t").time(1, 0.05, "static"));
  for (const std::size_t row : {1, 5, 20})
    expect_catenary(history, row, row / 20. * cable_weight);
}

TEST(SlackCable, CarriesALineLoad)
{
  const SceneText scene =
    cable().add("Loads/line",
                "Type = line | Struts = all | Force per length y = -49.05 * t");
  // The same line load per unstretched length as the weight.
  const MemoryRecorder history =
    sound_history_of(SceneText(scene).time(1, 0.05, "static"));
  for (const std::size_t row : {1, 10, 20})
    expect_catenary(history, row, row / 20. * cable_weight);
  const MemoryRecorder light =
    sound_history_of(SceneText(scene)
                       .set("Loads/line/Force per length y", "-0.1 * t")
                       .time(1, 0.5, "static"));
  expect_catenary(light, 2, 0.1);
  const MemoryRecorder path = sound_history_of(
    SceneText(scene).set("Analysis", "static path").time(1, 1, "static"));
  expect_catenary(path, path.rows().size() - 1, cable_weight);
}

TEST(SlackCable, StartsMotionsFromItsEquilibrium)
{
  SceneRun       run(cable()
                 .set("Gravity/Acceleration y", "-9.81")
                 .set("Time/Start from", "static equilibrium")
                 .time(0.1, 0.01)
                 .str());
  const Catenary right = catenary(cable_weight);
  EXPECT_NEAR(run.motion(1, 1), -right.sag, 1e-3 * right.sag);
  run.run();
  EXPECT_NEAR(run.motion(1, 1), -right.sag, 1e-3 * right.sag);
}

TEST(GravityInTime, AMassFallsAccordingly)
{
  SceneText scene;
  scene.frame("0 0; 1 0", "0 1").circle("rod", 0.05, {1e9, 1000});
  scene.set("Gravity/Acceleration y", "-6 * t").probe("end", "1");
  const MemoryRecorder      history = sound_history_of(scene.time(1, 0.02));
  const std::vector<double> y       = history.column("end.uy");
  EXPECT_NEAR(y.back(), -1, 1e-3);
}
