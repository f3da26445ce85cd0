#include <auxfem/model/effect_decisions.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  SimulatedEffects decide(const std::string              &text,
                          const std::vector<std::string> &overrides = {})
  {
    const Scene scene = read_scene_from_text(text, "test.prm", overrides);
    return decide_effects(scene, build_lattice(scene));
  }

  const SceneText plain = frame_scene("0 0; 1 0", "0 1");

  const EffectDecision &decision(const SimulatedEffects &effects,
                                 const std::string      &name)
  {
    for (const EffectDecision &candidate : effects.decisions)
      if (candidate.name == name)
        return candidate;
    throw std::logic_error("no decision on " + name);
  }
} // namespace

TEST(EffectDecisions, AutomaticEnablesEffectsWithACause)
{
  const SimulatedEffects everything = decide(star_with_everything(1, 1));
  for (const EffectDecision &one : everything.decisions)
    EXPECT_EQ(one.on,
              one.name != "rigid parts" && one.name != "contact" &&
                one.name != "plasticity")
      << one.name;
  EXPECT_EQ(everything.decisions.size(), 12u);
}

TEST(EffectDecisions, AutomaticDisablesEffectsWithoutACause)
{
  const SimulatedEffects effects = decide(plain);
  EXPECT_TRUE(effects.large_rotation);
  EXPECT_TRUE(effects.shear_flexibility);
  EXPECT_TRUE(effects.inertia);
  EXPECT_TRUE(effects.rotary_inertia);
  EXPECT_FALSE(effects.connector_viscosity);
  EXPECT_FALSE(effects.strut_damping);
  EXPECT_FALSE(effects.gravity);
  EXPECT_FALSE(effects.hinges);
}

TEST(EffectDecisions, StaticsHasNoInertia)
{
  const SimulatedEffects effects = decide(plain, {"Time/Scheme=static"});
  EXPECT_FALSE(effects.inertia);
  EXPECT_FALSE(effects.rotary_inertia);
  EXPECT_EQ(decision(effects, "inertia").reason, "time scheme static");
}

TEST(EffectDecisions, TheUserOverridesDecisions)
{
  const SimulatedEffects off = decide(star_with_everything(1, 1),
                                      {"Effects/Large rotation=off",
                                       "Effects/Shear flexibility=off",
                                       "Effects/Rotary inertia=off",
                                       "Effects/Connector viscosity=off",
                                       "Effects/Strut damping=off",
                                       "Effects/Gravity=off",
                                       "Effects/Hinges=off"});
  EXPECT_FALSE(off.large_rotation || off.shear_flexibility ||
               off.rotary_inertia || off.connector_viscosity ||
               off.strut_damping || off.gravity || off.hinges);
  EXPECT_TRUE(off.inertia);
  EXPECT_EQ(decision(off, "hinges").reason, "as set");
  EXPECT_TRUE(decide(plain, {"Effects/Large rotation=on"}).large_rotation);
}

TEST(EffectDecisions, EveryDecisionHasAReason)
{
  for (const SceneText &text : {plain, star_with_everything(1, 1)})
    for (const EffectDecision &one : decide(text).decisions)
      EXPECT_FALSE(one.reason.empty()) << one.name;
}

TEST(EffectDecisions, ListAgreesWithTheFlags)
{
  const SimulatedEffects effects =
    decide(plain, {"Effects/Inertia=off", "Time/Scheme=static"});
  EXPECT_FALSE(decision(effects, "inertia").on);
  EXPECT_FALSE(decision(effects, "rotary inertia").on);
  EXPECT_EQ(decision(effects, "large rotation").on, effects.large_rotation);
  EXPECT_EQ(decision(effects, "hinges").on, effects.hinges);
}
