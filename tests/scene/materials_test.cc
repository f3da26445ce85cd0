#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A strut of a viscoelastic material. */
  SceneText polymer_strut()
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .add("Materials/polymer",
           "Law = viscoelastic | Young's modulus = 2 MPa | "
           "Poisson's ratio = 0.25 | Density = 1100 kg/m3 | "
           "Relaxing parts = 0.3, 0.2 | Relaxation times = 1 ms, 1 s")
      .add("Sections/bar",
           "Material = polymer | Shape = rectangle | Width = 1 cm | "
           "Height = 1 cm")
      .support("clamp", "0", "clamp")
      .time(1, 0.1, "newmark");
  }

  std::string refusal_of(const SceneText &scene)
  {
    return input_error_of([&] { read_scene_from_text(scene, "test.prm"); });
  }
} // namespace

TEST(Materials, AreThoseOfTheSectionsThatNameThem)
{
  const Scene    scene   = read_scene_from_text(polymer_strut(), "test.prm");
  const Section &section = scene.sections.front().section;
  EXPECT_EQ(section.youngs_modulus, 2e6);
  EXPECT_EQ(section.shear_modulus, 0.8e6);
  EXPECT_EQ(section.density, 1100);
  ASSERT_TRUE(section.law);
  EXPECT_DOUBLE_EQ(section.relaxed().youngs_modulus, 1e6);
  EXPECT_DOUBLE_EQ(section.relaxed().shear_modulus, 0.4e6);
  EXPECT_FALSE(section.relaxed().law);
}

TEST(Materials, MayBeElasticByName)
{
  SceneText scene = polymer_strut();
  scene.remove("Materials/polymer/Relaxing parts")
    .remove("Materials/polymer/Relaxation times")
    .set("Materials/polymer/Law", "elastic");
  EXPECT_FALSE(
    read_scene_from_text(scene, "test.prm").sections.front().section.law);
}

TEST(Materials, RefuseWhatContradictsThem)
{
  expect_parts(refusal_of(polymer_strut().set("Sections/bar/Density", 1000)),
               {"Sections/bar/Density", "Materials/polymer"});
  expect_parts(refusal_of(
                 polymer_strut().set("Sections/bar/Material", "steel")),
               {"no such material", "polymer"});
  expect_parts(refusal_of(polymer_strut().remove("Materials")),
               {"the file has no Materials"});
  expect_parts(refusal_of(polymer_strut().remove("Sections/bar/Material")),
               {"Sections/bar/Young's modulus", "must be given", "Material"});
  expect_parts(refusal_of(polymer_strut().set(
                 "Materials/polymer/Stiffness-proportional damping",
                 "1 ms")),
               {"Materials/polymer", "losses of its own"});
  expect_parts(refusal_of(polymer_strut().remove("Materials/polymer/Density")),
               {"Materials/polymer/Density must be given"});
}

TEST(Materials, WithWrongValuesAreOneMistake)
{
  const std::string message = refusal_of(
    polymer_strut().set("Materials/polymer/Relaxing parts", "0.9, 0.2"));
  expect_parts(message, {"Materials/polymer/Relaxing parts", "add up to 1.1"});
  EXPECT_FALSE(contains(message, "Sections"));
}

TEST(Materials, FlowOnlyWhereNothingLasts)
{
  SceneText liquid = polymer_strut();
  liquid.set("Materials/polymer/Relaxing parts", "0.7, 0.3");
  EXPECT_EQ(refusal_of(liquid), "");
  for (const auto &[parameter, value] :
       std::vector<std::pair<std::string, std::string>>{
         {"Time/Scheme", "static"},
         {"Time/Start from", "static equilibrium"},
         {"Effects/Strut relaxation", "off"},
         {"Analysis", "modes"}})
    {
      SceneText scene = liquid;
      expect_parts(refusal_of(scene.set(parameter, value)), {"add up to 1"});
    }
}
