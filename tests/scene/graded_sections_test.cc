#include <auxfem/model/build_lattice.h>
#include <auxfem/scene/scene.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <cmath>
#include <set>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Four collinear struts of 1 m along x, 10 mm wide and 20 mm high. */
  SceneText chain(const std::string &grading)
  {
    return frame_scene("0 0; 1 0; 2 0; 3 0; 4 0", "0 1; 1 2; 2 3; 3 4")
      .rectangle("bar", "10 mm", "20 mm", {"1 GPa", 1000})
      .set("Sections/bar/Grading", grading);
  }

  Scene read(const SceneText &scene)
  {
    return read_scene_from_text(scene.str(), "test.prm");
  }

  /** The section of each strut. */
  std::vector<Section> sections_of(const SceneText &text)
  {
    const Scene          scene   = read(text);
    const Lattice        lattice = build_lattice(scene);
    std::vector<Section> sections;
    for (const Strut &strut : lattice.struts)
      sections.push_back(scene.sections[strut.section].section);
    return sections;
  }

  std::string message(const SceneText &scene)
  {
    return input_error_of([&] { sections_of(scene); });
  }
} // namespace

TEST(GradedSections, MultiplyDimensionsAndMaterialByPlace)
{
  const auto sections =
    sections_of(chain("Height: 1 + a * x / xmax; Width: 1 + strut; Young's "
                      "modulus: 2; Density: 1 + x")
                  .set("Constants", "a = 2"));
  for (unsigned int i = 0; i < 4; ++i)
    {
      const double x = i + 0.5, height = 0.02 * (1 + 2 * x / 4);
      EXPECT_NEAR(sections[i].area, 0.01 * (1 + i) * height, 1e-17);
      EXPECT_NEAR(sections[i].half_thicknesses[1], height / 2, 1e-16);
      EXPECT_DOUBLE_EQ(sections[i].youngs_modulus, 2e9);
      EXPECT_DOUBLE_EQ(sections[i].shear_modulus, 2e9 / 2.6);
      EXPECT_DOUBLE_EQ(sections[i].density, 1000 * (1 + x));
    }
}

TEST(GradedSections, EqualFactorsShareASection)
{
  const Scene            scene = read(chain("Height: if(x < 2, 1, 2)"));
  std::set<unsigned int> used;
  for (const Strut &strut : build_lattice(scene).struts)
    used.insert(strut.section);
  EXPECT_EQ(used.size(), 2u);
  for (const unsigned int i : used)
    EXPECT_EQ(scene.sections[i].path, "Sections/bar");
}

TEST(GradedSections, LaterSectionsStillCount)
{
  const auto sections =
    sections_of(chain("Height: 1 + x")
                  .add(SceneText()
                         .rectangle("late", 1, 1, {5, 1})
                         .set("Sections/late/Struts", "1, 2")));
  EXPECT_DOUBLE_EQ(sections[1].area, 1);
  EXPECT_DOUBLE_EQ(sections[2].area, 1);
  EXPECT_NEAR(sections[3].area, 2e-4 * 4.5, 1e-17);
}

TEST(GradedSections, TapersAndGradingsGoTogether)
{
  const auto sections = sections_of(
    chain("Height: 1 + x").set("Sections/bar/Taper", "Height: 1 - 0.5 * s"));
  EXPECT_NEAR(sections[0].at(0).area, 2e-4 * 1.5, 1e-17);
  EXPECT_NEAR(sections[3].at(1).area, 2e-4 * 4.5 / 2, 1e-17);
}

TEST(GradedSections, RandomNumbersDependOnSeedAndStrutAlone)
{
  SceneText one = SceneText()
                    .cells("triangular", 20, 20)
                    .rectangle("bar", "1 mm", "1 mm", {1, 1})
                    .set("Sections/bar/Grading",
                         "Height: 1 + random(1); Width: 3 + 0.1 * normal(1)");
  const auto sections = sections_of(one), again = sections_of(one),
             other =
               sections_of(one.set("Sections/bar/Grading",
                                   "Height: 1 + random(2); Width: 3 + 0.1 * "
                                   "normal(1)"));
  double       sum = 0, normal = 0, squares = 0;
  unsigned int different = 0;
  const double n         = sections.size();
  for (unsigned int i = 0; i < sections.size(); ++i)
    {
      const double height = 2e3 * sections[i].half_thicknesses[1],
                   width  = (2e3 * sections[i].half_thicknesses[0] - 3) / 0.1;
      EXPECT_EQ(sections[i].area, again[i].area);
      different += sections[i].half_thicknesses != other[i].half_thicknesses;
      EXPECT_GE(height, 1);
      EXPECT_LT(height, 2);
      sum += height;
      normal += width;
      squares += width * width;
    }
  EXPECT_EQ(different, sections.size());
  // Four standard deviations of the means.
  EXPECT_NEAR(sum / n, 1.5, 4 / std::sqrt(12 * n));
  EXPECT_NEAR(normal / n, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 4 * std::sqrt(2 / n));
}

TEST(GradedSections, RefuseWhatCannotBeGraded)
{
  EXPECT_TRUE(contains(message(chain("Depth: 1")), "Width, Height"));
  EXPECT_TRUE(contains(message(chain("Yield strain: 2")), "Allowed: "));
  EXPECT_TRUE(contains(message(chain("Height = 1")), "has no colon"));
  EXPECT_TRUE(contains(message(chain("Height: wrong")), "cannot understand"));
  EXPECT_TRUE(contains(message(chain("Height: 2 - x")),
                       "the factor of Height is -0.5 at strut 2 (middle 2.5"));
}

TEST(SectionBase, GivesValuesNotGiven)
{
  const auto sections =
    sections_of(chain("none").add(SceneText()
                                    .set("Sections/late/Base", "bar")
                                    .set("Sections/late/Struts", "3")
                                    .set("Sections/late/Height", "40 mm")
                                    .set("Sections/round/Base", "late")
                                    .set("Sections/round/Struts", "2")
                                    .set("Sections/round/Shape", "circle")
                                    .set("Sections/round/Radius", "1 mm")));
  EXPECT_NEAR(sections[0].area, 2e-4, 1e-17);
  EXPECT_NEAR(sections[3].area, 4e-4, 1e-17);
  EXPECT_NEAR(sections[2].area, 3.14159265e-6, 1e-12);
  EXPECT_EQ(sections[2].youngs_modulus, 1e9);
}

TEST(SectionBase, RefusesUnknownNamesAndCircles)
{
  const auto with = [](const std::string &base) {
    return message(chain("none")
                     .set("Sections/bar/Base", base)
                     .set("Sections/other/Base", "bar"));
  };
  EXPECT_TRUE(contains(with("baar"), "there is no such section"));
  EXPECT_TRUE(contains(with("other"), "inherits from itself"));
  EXPECT_TRUE(contains(with("bar"), "inherits from itself"));
}
