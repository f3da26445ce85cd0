#include <auxfem/scene/scene.h>

#include <deal.II/base/numbers.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  Scene tapered(const SceneText &further)
  {
    return read_scene_from_text(
      frame_scene("0 0; 1 0", "0 1")
        .rectangle("bar", "10 mm", "20 mm", {"1 GPa", 1000})
        .add(further)
        .str(),
      "test.prm");
  }

  SceneText taper(const std::string &text)
  {
    return SceneText().set("Sections/bar/Taper", text);
  }

  std::string message(const SceneText &further)
  {
    return input_error_of([&] { tapered(further); });
  }
} // namespace

TEST(Taper, MultipliesDimensionsAlongTheStrut)
{
  const Scene scene = tapered(
    taper("Height: 1 - a * s; Width: 1 + s").set("Constants", "a = 0.5"));
  const Section &section = scene.sections.back().section;
  const auto     area_at = [&](const double s) { return section.at(s).area; };
  EXPECT_NEAR(area_at(0), 2e-4, 1e-18);
  EXPECT_NEAR(area_at(1), 2e-4, 1e-18);
  EXPECT_NEAR(area_at(0.2), 0.9 * 1.2 * 2e-4, 1e-18);
  EXPECT_NEAR(section.at(1).second_moment_3, 0.02 * 1e-6 / 12, 1e-20);
  EXPECT_NEAR(section.at(1).half_thicknesses[1], 0.005, 1e-16);
  EXPECT_EQ(section.at(1).youngs_modulus, 1e9);
  // Constants of the section itself are those of its middle.
  EXPECT_EQ(section.area, area_at(0.5));
  EXPECT_NEAR(section.area, 0.75 * 1.5 * 2e-4, 1e-18);
}

TEST(Taper, MakesSixteenElementsAStrut)
{
  EXPECT_EQ(tapered(taper("Height: 1 - 0.5 * s")).discretization.refinements,
            4u);
  EXPECT_EQ(tapered({}).discretization.refinements, 0u);
  const Scene modes =
    tapered(taper("Height: 1 - 0.5 * s").set("Analysis", "modes"));
  EXPECT_FALSE(modes.discretization.tolerance);
  EXPECT_EQ(modes.discretization.order, 3u);
}

TEST(Taper, RefusesWhatItCannotRead)
{
  expect_parts(message(taper("1 - s")),
               {"Sections/bar/Taper", "no colon", "Height: 1 - 0.5 * s"});
  expect_parts(message(taper("Radius: 1 - s")),
               {"\"Radius\" is no number of this section that Taper can vary",
                "Width, Height"});
  expect_parts(message(taper("Height: 1 - x")), {"cannot understand"});
  expect_parts(message(taper("Height: 1 - s")),
               {"factor of Height", "at s = 1", "positive"});
}

TEST(Taper, RefusesShapesThatBecomeImpossible)
{
  const auto refusal = input_error_of([&] {
    read_scene_from_text(
      frame_scene("0 0; 1 0", "0 1")
        .add("Sections/pipe",
             "Shape = tube | Outer radius = 10 mm | Wall thickness = 2 mm | "
             "Young's modulus = 1 GPa | Density = 1 | "
             "Taper = Wall thickness: 1 + 9 * s")
        .str(),
      "test.prm");
  });
  expect_parts(refusal, {"Sections/pipe", "thickness"});
}

TEST(Taper, RefusesElementsChosenByTheirError)
{
  expect_parts(
    message(taper("Height: 1 - 0.5 * s").set("Discretization/Order", "auto")),
    {"Discretization/Order", "Taper", "Global refinements"});
}
