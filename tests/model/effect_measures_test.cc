#include <auxfem/model/build_lattice.h>
#include <auxfem/model/effect_decisions.h>
#include <auxfem/model/load_history.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>
#include <optional>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A strut of 1 m, EI = 2 N m2, kGA = 600 N, rho A = 3 kg/m, with a moving
   * load at its tip. */
  SceneText strut_with(const std::string &force)
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .given("strut", {10, 600, 2}, {1, 0.3, -0.5})
      .set("Sections/strut/Struts", "all")
      .support("clamp", "0", "clamp")
      .load("tip", "1", {"0", force, "0"})
      .set("Time/End time", 1)
      .set("Time/Time step", 1e-3);
    return scene;
  }

  std::optional<EffectMeasure>
  measure_of(const std::string              &name,
             const SceneText                &text,
             const std::vector<std::string> &overrides = {})
  {
    const Scene scene = read_scene_from_text(text, "test.prm", overrides);
    for (const EffectDecision &decision :
         decide_effects(scene, build_lattice(scene)).decisions)
      if (decision.name == name)
        return decision.measure;
    throw std::logic_error("no decision on " + name);
  }

  LoadHistory course_of(const std::string              &force,
                        const std::vector<std::string> &overrides = {})
  {
    return load_history(
      read_scene_from_text(strut_with(force), "test.prm", overrides));
  }

  const double half_turn = std::acos(-1.);
} // namespace

TEST(LoadHistory, RateIsTheLargestSlopeOverTheLargestValue)
{
  // Differences of 1000 values miss second order at most, (40 * 1e-3)^2 / 24.
  EXPECT_NEAR(course_of("3 * sin(40 * t)").rate, 40, 40 * 1e-3);
  EXPECT_NEAR(course_of("7 * min(t / 0.2, 1)").rate, 5, 1e-9);
  EXPECT_FALSE(course_of("7 * min(t / 0.2, 1)").is_sudden);
  EXPECT_EQ(course_of("0").rate, 0);
}

TEST(LoadHistory, JumpsAreAsFastAsStepsResolve)
{
  const double resolved = 2 * half_turn / (20 * 1e-3);
  for (const std::string force : {"1", "t < 0.5 ? 0 : 1", "1 / (t - 0.5)"})
    {
      EXPECT_TRUE(course_of(force).is_sudden) << force;
      EXPECT_NEAR(course_of(force).rate, resolved, 1e-9) << force;
    }
  EXPECT_FALSE(
    course_of("1", {"Time/Start from=static equilibrium"}).is_sudden);
}

TEST(LoadHistory, OscillationsLoseInEveryRadian)
{
  const Scene scene = read_scene_from_text(strut_with("1"), "test.prm");
  // Half of the energy loss, at 100 pi rad/s.
  EXPECT_NEAR(load_history(scene).lost(scene, 1e-5),
              1e-5 * 50 * half_turn,
              1e-12);
  EXPECT_EQ(load_history(scene).lost(scene, 1), 1);
}

TEST(EffectMeasures, ShearIsItsPartInTheBendingCompliance)
{
  const auto found = measure_of("shear flexibility", strut_with("t"));
  // 12 EI / (kGA L^2)
  EXPECT_NEAR(found->change, 12 * 2. / 600, 1e-12);
}

TEST(EffectMeasures, RotaryInertiaIsThatOfTheHighestFrequency)
{
  const auto found = measure_of("rotary inertia",
                                strut_with("t"),
                                {"Sections/strut/Rotary inertia=0 0 1e-3"});
  // J / (rho A) omega sqrt(rho A / EI) / 2, with 20 steps a period
  EXPECT_NEAR(found->change,
              1e-3 / 3 * (2 * half_turn / 20e-3) * std::sqrt(3. / 2) / 2,
              1e-9);
  EXPECT_FALSE(
    measure_of("rotary inertia", strut_with("t"), {"Time/Scheme=static"}));
}

TEST(EffectMeasures, ViscosityIsTheForceOfARampBeyondThatOfSprings)
{
  SceneText scene = strut_with("min(t / 0.5, 1)");
  scene.set("Connectors/damper/Law", "kelvin-voigt")
    .set("Connectors/damper/Between", "ground: 1")
    .set("Connectors/damper/Ground offset", "0, 1 m")
    .set("Connectors/damper/Spring stiffness", 4)
    .set("Connectors/damper/Damping coefficient", 3);
  // C / T over K + C / T + 3 EI / L^3
  EXPECT_NEAR(measure_of("connector viscosity", scene)->change,
              6. / (4 + 6 + 6),
              1e-9);
}

TEST(EffectMeasures, StrutDampingIsItsTimeOverThatOfLoading)
{
  SceneText scene = strut_with("min(t / 0.5, 1)");
  scene.set("Sections/strut/Stiffness-proportional damping", 1e-3);
  EXPECT_NEAR(measure_of("strut damping", scene)->change, 2e-3, 1e-9);
  scene.set("Sections/strut/Mass-proportional damping", 1e-2);
  EXPECT_NEAR(measure_of("strut damping", scene)->change, 7e-3, 1e-9);
}

TEST(EffectMeasures, RelaxationIsTheStiffnessLeftAtTheEndOfARamp)
{
  SceneText scene = strut_with("min(t / 0.5, 1)");
  scene.remove("Sections/strut/Young's modulus")
    .set("Sections/strut/Material", "polymer")
    .set("Materials/polymer/Law", "viscoelastic")
    .set("Materials/polymer/Young's modulus", 1)
    .set("Materials/polymer/Density", 3)
    .set("Materials/polymer/Relaxing parts", "0.4")
    .set("Materials/polymer/Relaxation times", "0.25");
  for (const std::string name : {"Poisson's ratio", "Density"})
    try
      {
        scene.remove("Sections/strut/" + name);
      }
    catch (const std::logic_error &)
      {}
  const double excess = 0.4 * (1 - std::exp(-2)) / 2;
  EXPECT_NEAR(measure_of("strut relaxation", scene)->change,
              excess / (excess + 0.6),
              1e-9);
  scene.set("Materials/polymer/State at start", "instantaneous")
    .set("Materials/polymer/Relaxation times", "1e-9")
    .set("Time/Start from", "static equilibrium");
  EXPECT_NEAR(measure_of("strut relaxation", scene)->change, 0.4, 1e-9);
  EXPECT_FALSE(measure_of("strut relaxation", strut_with("t")));
}

TEST(EffectMeasures, GravityIsWeightOverLoads)
{
  SceneText scene = strut_with("20 * t");
  scene.set("Gravity/Acceleration y", -2)
    .add("Masses/point", "Joints = 1 | Mass = 1 kg");
  EXPECT_NEAR(measure_of("gravity", scene)->change, 2 * (3 + 1) / 20., 1e-12);
  EXPECT_FALSE(measure_of("gravity", scene.set("Loads/tip/Force y", "0")));
}

TEST(EffectMeasures, SpringsAreTheirPartInTheBendingCompliance)
{
  SceneText scene = strut_with("t");
  scene.frame("0 0; 1 0; 2 0", "0 1; 1 2")
    .add("Joints/knee",
         "Joints = 1 | Struts = 1 | Type = rotational spring | "
         "Stiffness = 1000");
  EXPECT_NEAR(measure_of("hinges", scene)->change, 3 * 2. / 1000, 1e-12);
  // A single strut at its end rotates relative to the ground.
  EXPECT_FALSE(measure_of("hinges", scene.set("Joints/knee/Joints", "2")));
  EXPECT_FALSE(measure_of("hinges",
                          scene.set("Joints/knee/Joints", "1")
                            .set("Joints/knee/Type", "hinge")
                            .remove("Joints/knee/Stiffness")));
}
