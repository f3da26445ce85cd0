#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/model/build_lattice.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/output/recorder.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>
#include <verification/result_table.h>

#include <cmath>
#include <functional>

// Families of scenes in which one number makes an effect grow: the measure that
// decides on the effect against the change of the answer without it.

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr double tolerance = 1e-3;

  /** The scenes by the number that is varied, from little of the effect to
   * much of it. */
  struct Family
  {
    std::string                      effect;   ///< as its parameter
    std::string                      variable; ///< what is varied
    std::vector<double>              values;
    std::function<SceneText(double)> scene;
  };

  /** Measure and change of a family at one value of its parameter. */
  struct Sample
  {
    double value, measure, change;
  };

  /** Displacements of the probe `top`, from t = 0 on. */
  std::vector<std::array<double, 2>> motion_of(const Scene &scene)
  {
    MemoryRecorder recorder(scene, MPI_COMM_WORLD);
    const auto     result = run_lattice(scene, MPI_COMM_WORLD, recorder);
    EXPECT_TRUE(result.completed());
    const auto x = recorder.column("top.ux"), y = recorder.column("top.uy");
    std::vector<std::array<double, 2>> motion;
    for (std::size_t i = 0; i < x.size(); ++i)
      motion.push_back({{x[i], y[i]}});
    return motion;
  }

  /** The largest change of the motion, of the largest motion. */
  double change_without(const Family &family, const double value)
  {
    const auto motion = [&](const std::string &choice) {
      return motion_of(
        read_scene_from_text(family.scene(value).probe("top", "top").str(),
                             "test.prm",
                             {family.effect == "Inertia" && choice == "off"
                                ? "Time/Scheme=static"
                                : "Effects/" + family.effect + "=" + choice}));
    };
    const auto with = motion("on"), without = motion("off");
    double     largest = 0, change = 0;
    for (std::size_t i = 0; i < with.size(); ++i)
      {
        largest = std::max(largest, std::hypot(with[i][0], with[i][1]));
        change  = std::max(change,
                          std::hypot(with[i][0] - without[i][0],
                                     with[i][1] - without[i][1]));
      }
    return change / largest;
  }

  double measure_of(const Family &family, const double value)
  {
    const Scene scene =
      read_scene_from_text(family.scene(value).str(), "test.prm");
    if (family.effect == "Inertia")
      return LatticeRun(scene, MPI_COMM_WORLD).inertia_measure()->change;
    std::string name = family.effect;
    name[0]          = std::tolower(name[0]);
    for (const EffectDecision &decision :
         decide_effects(scene, build_lattice(scene)).decisions)
      if (decision.name == name && decision.measure)
        return decision.measure->change;
    throw std::logic_error("no measure of " + name);
  }

  /** The change where the measure goes through the tolerance, between powers
   * of the value. */
  double change_at_the_turn(const std::vector<Sample> &samples)
  {
    for (std::size_t i = 1; i < samples.size(); ++i)
      {
        const Sample &low = samples[i - 1], &high = samples[i];
        if (low.measure > tolerance || high.measure <= tolerance)
          continue;
        const double part = std::log(tolerance / low.measure) /
          std::log(high.measure / low.measure);
        return low.change * std::pow(high.change / low.change, part);
      }
    ADD_FAILURE() << "The decision does not turn.";
    return 0;
  }

  void expect_turn_at_tolerance(const Family &family)
  {
    ResultTable         table(family.effect + ": " + family.variable,
                      {"value", "measure", "change", "verdict"});
    std::vector<Sample> samples;
    for (const double value : family.values)
      {
        const Sample sample{value,
                            measure_of(family, value),
                            change_without(family, value)};
        samples.push_back(sample);
        table.row(
          {formatted("%.3g", value),
           formatted("%.2e", sample.measure),
           formatted("%.2e", sample.change),
           sample.measure > tolerance ? "called for" : "not called for"});
      }
    const double change = change_at_the_turn(samples);
    EXPECT_GT(change, tolerance / 3);
    EXPECT_LT(change, tolerance * 3);
  }

  /** Star cells of 10 mm aluminium struts on a foundation. */
  SceneText star(const double height)
  {
    SceneText scene;
    scene.cells("star", 2, 2)
      .set("Lattice/Strut length", "10 mm")
      .set("Lattice/Opening angle", "60 deg")
      .rectangle("aluminium", "1 mm", height, {"70 GPa", "2700 kg/m3", 0.33})
      .set("Sections/aluminium/Struts", "all")
      .support("foundation", "bottom", "clamp")
      .mesh(3);
    return scene;
  }

  /** The same pressed down evenly during @p duration (s). */
  SceneText pressed_star(const double height, const double duration)
  {
    const std::string force = "-0.01 * t / " + text(duration);
    return star(height)
      .set("Effects/Large rotation", "on")
      .load("press", "top", {"0", force, "0"})
      .time(duration, duration / 200, "newmark");
  }

  SceneText damped_star(const double relaxation_time, const double duration)
  {
    SceneText scene = pressed_star(0.4e-3, duration);
    scene.set("Connectors/damper/Law", "kelvin-voigt")
      .set("Connectors/damper/Between", "in-cell")
      .set("Connectors/damper/Spring stiffness", 1000)
      .set("Connectors/damper/Damping coefficient", 1000 * relaxation_time);
    return scene;
  }

  const std::vector<double> five_decades = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1};
} // namespace

TEST(EffectFamilies, ShearFromSlenderToStocky)
{
  const std::vector<double> heights =
    {0.03e-3, 0.1e-3, 0.3e-3, 1e-3, 2e-3, 3e-3};
  expect_turn_at_tolerance({"Shear flexibility",
                            "height of the struts of a star lattice (m)",
                            heights,
                            [](const double height) {
                              return star(height)
                                .load("press", "top", {"0", "-1e-3", "0"})
                                .set("Time/Scheme", "static")
                                .linear();
                            }});
}

TEST(EffectFamilies, ShearInSpaceFromSlenderToStocky)
{
  expect_turn_at_tolerance(
    {"Shear flexibility",
     "radius of the struts of a star lattice in space (m)",
     {0.01e-3, 0.03e-3, 0.1e-3, 0.3e-3, 1e-3},
     [](const double radius) {
       SceneText scene;
       scene.dimension(3)
         .cells("space star", 1, 2)
         .set("Lattice/Strut length", "10 mm")
         .set("Lattice/Opening angle", "65 deg")
         .circle("rod", radius, {2e9, 1140, 0.4})
         .set("Sections/rod/Struts", "all")
         .support("foundation", "bottom", "clamp")
         .load("press", "top", {"0", "-1e-3", "0"}, {"0", "0", "0"})
         .set("Time/Scheme", "static")
         .mesh(3)
         .linear();
       return scene;
     }});
}

TEST(EffectFamilies, RotaryInertiaFromSlowToFast)
{
  // A beam of 1 m, omega_1 = 3.516 sqrt(EI / (rho A L^4)), swings under a load
  // of frequency f.
  expect_turn_at_tolerance(
    {"Rotary inertia",
     "frequency of the load on a cantilever (Hz)",
     {5, 10, 20, 50, 100, 200, 400, 800},
     [](const double frequency) {
       SceneText scene;
       scene.frame("0 0; 0 1", "0 1")
         .rectangle("bar", 0.04, 0.04, {70e9, 2700, 0.33})
         .set("Sections/bar/Struts", "all")
         .support("wall", "0", "clamp")
         .load("tip",
               "1",
               {"1 - cos(2 * pi * " + text(frequency) + " * t)", "0", "0"})
         .mesh(4, 2)
         .linear()
         .time(1 / frequency, 1 / (20 * frequency), "newmark");
       return scene;
     }});
}

TEST(EffectFamilies, ViscosityFromShortToLongRelaxationTimes)
{
  expect_turn_at_tolerance({"Connector viscosity",
                            "relaxation time of connectors pressed in 1 s (s)",
                            five_decades,
                            [](const double relaxation_time) {
                              return damped_star(relaxation_time, 1);
                            }});
}

TEST(EffectFamilies, ViscosityFromSlowToFastLoads)
{
  std::vector<double> rates;
  for (const double duration : {100., 10., 1., 0.1, 0.01})
    rates.push_back(1 / duration);
  expect_turn_at_tolerance(
    {"Connector viscosity",
     "rate of the load on connectors of 10 ms (1/s)",
     rates,
     [](const double rate) { return damped_star(1e-2, 1 / rate); }});
}

TEST(EffectFamilies, StrutDampingFromShortToLongTimes)
{
  expect_turn_at_tolerance(
    {"Strut damping",
     "time of the damping of struts pressed in 1 s (s)",
     five_decades,
     [](const double time) {
       return pressed_star(0.4e-3, 1)
         .set("Sections/aluminium/Stiffness-proportional damping", time);
     }});
}

TEST(EffectFamilies, InertiaFromSlowToFastRamps)
{
  expect_turn_at_tolerance(
    {"Inertia",
     "rate of a ramp that pushes a star lattice aside (1/s)",
     {0.3, 1, 3, 10, 30},
     [](const double rate) {
       return star(0.4e-3)
         .load("push", "top", {"1e-4 * t * " + text(rate), "0", "0"})
         .linear()
         .time(1 / rate, 2e-4, "newmark");
     }});
}

TEST(EffectFamilies, InertiaFromSlowToFastCurves)
{
  expect_turn_at_tolerance(
    {"Inertia",
     "rate of a cubic course that pushes a star lattice aside (1/s)",
     {1, 3, 10, 30, 100, 300},
     [](const double rate) {
       return star(0.4e-3)
         .load("push", "top", {"1e-4 * (t * " + text(rate) + ")^3", "0", "0"})
         .linear()
         .time(1 / rate, 1 / (400 * rate), "newmark");
     }});
}

TEST(EffectFamilies, GravityFromLittleToMuch)
{
  expect_turn_at_tolerance({"Gravity",
                            "acceleration (m/s2)",
                            {1e-3, 1e-2, 0.1, 1, 10, 100},
                            [](const double acceleration) {
                              return pressed_star(0.4e-3, 1)
                                .set("Gravity/Acceleration y", -acceleration)
                                .set("Time/Start from", "static equilibrium");
                            }});
}

TEST(EffectFamilies, SpringsInJointsFromStiffToSoft)
{
  expect_turn_at_tolerance({"Hinges",
                            "compliance of rotational springs (rad/(N m))",
                            {1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1},
                            [](const double compliance) {
                              return star(0.4e-3)
                                .load("press", "top", {"0", "-1e-3", "0"})
                                .add("Joints/soft",
                                     "Joints = tips | Struts = all | Type = "
                                     "rotational spring | Stiffness = " +
                                       text(1 / compliance))
                                .set("Time/Scheme", "static")
                                .linear();
                            }});
}

TEST(EffectFamilies, DampingIsKeptWhereStrutsSwing)
{
  // A beam of 1 m with omega_1 = 207/s: a load of that frequency, and one that
  // is put on in half a period and stays. Either leaves a swing for 50 periods.
  for (const std::string force : {"sin(206.7 * t)", "min(1, t / 0.015)"})
    {
      const Family
        family{"Strut damping", "", {}, [&force](const double damping) {
                 SceneText scene;
                 scene.frame("0 0; 0 1", "0 1")
                   .rectangle("bar", 0.04, 0.04, {70e9, 2700, 0.33})
                   .set("Sections/bar/Struts", "all")
                   .set("Sections/bar/Stiffness-proportional damping", damping)
                   .support("wall", "0", "clamp")
                   .load("tip", "1", {force, "0", "0"})
                   .mesh(4, 1)
                   .linear()
                   .time(1.5, 0.7e-3, "newmark");
                 return scene;
               }};
      constexpr double damping = 2.4e-6;
      EXPECT_LT(measure_of(family, damping), tolerance) << force;
      EXPECT_GT(change_without(family, damping), 10 * tolerance) << force;
      const Scene scene =
        read_scene_from_text(family.scene(damping).str(), "test.prm");
      EXPECT_TRUE(decide_effects(scene, build_lattice(scene)).strut_damping)
        << force;
    }
}
