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
  const std::string message_on_density =
    refusal_of(polymer_strut().set("Materials/polymer/Density", -1));
  expect_parts(message_on_density, {"Materials/polymer/Density"});
  EXPECT_EQ(message_on_density.find("Sections"), std::string::npos)
    << message_on_density;
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

namespace
{
  /** A strut of a material that yields. */
  SceneText metal_strut()
  {
    return SceneText()
      .frame("0 0; 1 0", "0 1")
      .add("Materials/metal",
           "Law = elastic-plastic | Young's modulus = 70 GPa | "
           "Poisson's ratio = 0.33 | Density = 2700 kg/m3 | "
           "Yield stress = 250 MPa")
      .add("Sections/bar",
           "Material = metal | Shape = rectangle | Width = 1 cm | "
           "Height = 1 cm")
      .support("clamp", "0", "clamp")
      .time(1, 0.1, "newmark");
  }
} // namespace

TEST(Materials, ThatYieldHaveTwoElementsOfOrderFourByDefault)
{
  const Scene scene = read_scene_from_text(metal_strut(), "test.prm");
  EXPECT_EQ(scene.discretization.order, 4u);
  EXPECT_EQ(scene.discretization.refinements, 1u);
  EXPECT_TRUE(scene.discretization.is_default);
  const Scene other =
    read_scene_from_text(metal_strut().mesh(2, 0), "test.prm");
  EXPECT_EQ(other.discretization.order, 2u);
  EXPECT_EQ(other.discretization.refinements, 0u);
  EXPECT_FALSE(other.discretization.is_default);
}

TEST(Materials, ThatYieldShareTheirLawAmongSectionsOfOneShape)
{
  SceneText text = metal_strut();
  text.frame("0 0; 1 0; 2 0; 3 0", "0 1; 1 2; 2 3")
    .add("Sections/thin",
         "Struts = 1 | Material = metal | Shape = rectangle | Width = 1 cm | "
         "Height = 2 mm")
    .add("Sections/rod",
         "Struts = 2 | Material = metal | Shape = circle | Radius = 2 mm");
  const auto sections = read_scene_from_text(text, "test.prm").sections;
  EXPECT_EQ(sections[0].section.law, sections[1].section.law);
  EXPECT_NE(sections[0].section.law, sections[2].section.law);
  // Torsion depends on the proportions.
  const auto twisted =
    read_scene_from_text(text.set("Materials/metal/Shear and torsion", "yield"),
                         "test.prm")
      .sections;
  EXPECT_NE(twisted[0].section.law, twisted[1].section.law);
}

TEST(Materials, ThatYieldRefuseWhatTheyCannotFollow)
{
  EXPECT_EQ(refusal_of(metal_strut()), "");
  for (const auto &[parameter, value] :
       std::vector<std::pair<std::string, std::string>>{
         {"Time/Scheme", "esdirk"},
         {"Analysis", "static path"},
         {"Analysis", "buckling"},
         {"Discretization/Order", "auto"},
         {"Effects/Shear flexibility", "off"}})
    {
      SceneText scene = metal_strut();
      expect_parts(refusal_of(scene.set(parameter, value)),
                   {"elastic-plastic", "Effects/Plasticity = off"});
      if (parameter == "Discretization/Order")
        continue;
      EXPECT_EQ(refusal_of(scene.set("Effects/Plasticity", "off")), "")
        << value;
    }
  expect_parts(refusal_of(
                 metal_strut().set("Materials/metal/Yield stress", "0 MPa")),
               {"Materials/metal/Yield stress"});
  expect_parts(refusal_of(
                 metal_strut().set("Materials/metal/Yield strain", "1 %")),
               {"Materials/metal/Yield strain", "Yield stress"});
  expect_parts(refusal_of(metal_strut().set(
                 "Materials/metal/Stiffness-proportional damping",
                 "1 us")),
               {"Mass-proportional damping"});
  expect_parts(refusal_of(
                 metal_strut().set("Materials/metal/Failure strain", "10 %")),
               {"Failure time", "ten time steps"});
  SceneText breaking = metal_strut();
  breaking.add("Materials/metal",
               "Failure strain = 10 % | Failure time = 1 ms");
  EXPECT_EQ(refusal_of(breaking), "");
  breaking.set("Effects/Rotary inertia", "off");
  expect_parts(refusal_of(breaking),
               {"Materials/metal/Failure time", "Effects/Rotary inertia"});
  EXPECT_EQ(refusal_of(SceneText(breaking).set("Time/Scheme", "static")), "");
  EXPECT_EQ(refusal_of(SceneText(breaking).set("Materials/metal/Density", 0)),
            "");
  SceneText given = metal_strut();
  given.remove("Sections/bar/Width")
    .remove("Sections/bar/Height")
    .add("Sections/bar",
         "Shape = given | Area = 1e-4 | Shear area = 1e-4 | "
         "Second moment of area = 1e-9");
  expect_parts(refusal_of(given), {"Sections/bar/Shape = given", "fibre"});
  SceneText ellipse = metal_strut();
  ellipse.set("Sections/bar/Shape", "ellipse");
  expect_parts(refusal_of(ellipse),
               {"Sections/bar/Shape = ellipse", "rectangle, circle or tube"});
}

TEST(Materials, MayBeGivenByMeasuredModuli)
{
  SceneText scene = polymer_strut();
  scene.remove("Materials/polymer/Relaxing parts")
    .remove("Materials/polymer/Relaxation times")
    .remove("Materials/polymer/Young's modulus")
    .add("Materials/polymer",
         "Measured frequencies = 0.1, 1, 10, 100 | "
         "Storage moduli = 1 MPa, 1.3 MPa, 1.7 MPa, 2 MPa | "
         "Loss moduli = 150 kPa, 200 kPa, 200 kPa, 150 kPa");
  const Scene read = read_scene_from_text(scene, "test.prm");
  EXPECT_GT(read.sections.front().section.youngs_modulus, 2e6);
  EXPECT_LT(read.sections.front().section.youngs_modulus, 3e6);
  EXPECT_TRUE(
    contains(read.materials.front().law->note(), "fits the measured moduli"));
  expect_parts(refusal_of(
                 SceneText(scene).set("Materials/polymer/Young's modulus",
                                      "2 MPa")),
               {"Young's modulus", "Measured frequencies"});
  expect_parts(refusal_of(
                 SceneText(scene).remove("Materials/polymer/Loss moduli")),
               {"Loss moduli has 0 values", "equal length"});
}
