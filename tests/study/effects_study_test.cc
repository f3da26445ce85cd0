#include <gtest/gtest.h>
#include <study/report_cells.h>
#include <support/cell_scene.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A cantilever of soft or stiff material under its own weight. */
  SceneText heavy_cantilever(const std::string &youngs_modulus,
                             const std::string &load)
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1");
    scene.circle("rod", 0.02, {youngs_modulus, 1000, 0.3});
    scene.support("clamp", "0", "clamp");
    scene.load("push", "1", {"0", load, "0"});
    scene.set("Gravity/Acceleration y", -9.81);
    return scene.time(1, 0.2, "static").probe("tip", "1");
  }

  StudyReport effects_of(const std::string &scene, const std::string &tolerance)
  {
    return study_of(scene,
                    {"Study/Kind=effects",
                     "Study/Repetitions=1",
                     "Study/Tolerance=" + tolerance});
  }

  std::string verdict_on(const StudyReport &report, const std::string &effect)
  {
    return cells_where(report, "verdict", "left_out", effect).at(0);
  }
} // namespace

TEST(EffectsStudy, LargeRotationsAreCalledForWhereTheyAreLarge)
{
  // 1000 N bend a rod of 125 N m2 by a radian or more, 0.01 N by 1e-5.
  EXPECT_EQ(verdict_on(effects_of(heavy_cantilever("1e9", "-1000 * t"), "1 %"),
                       "Large rotation"),
            "called for");
  SceneText small = heavy_cantilever("1e9", "-0.01 * t");
  small.remove("Gravity");
  EXPECT_EQ(verdict_on(effects_of(small, "1 %"), "Large rotation"),
            "not called for");
}

TEST(EffectsStudy, ChangeByTheWeightIsThatOfTheFormula)
{
  // Small displacements: w L^4 / (8 EI) over F L^3 / (3 EI) + w L^4 / (8 EI).
  const StudyReport report = effects_of(
    heavy_cantilever("1e12", "-100 * t").set("Effects/Large rotation", "off"),
    "1 %");
  const double weight   = 1000 * 9.81 * dealii::numbers::PI * 4e-4;
  const double expected = weight / 8 / (weight / 8 + 100. / 3);
  EXPECT_NEAR(last_number_where(report, "tip.change", "left_out", "Gravity"),
              expected,
              // shear contributes to both loads
              0.01 * expected);
}

TEST(EffectsStudy, OmitsAllUnneededEffectsTogether)
{
  const StudyReport report =
    effects_of(heavy_cantilever("1e12", "-100 * t"), "20 %");
  const std::string both =
    "Large rotation, Shear flexibility, Gravity, Contact";
  EXPECT_EQ(verdict_on(report, both), "not called for");
  EXPECT_TRUE(contains(report.text,
                       "--set \"Effects/Large rotation=off\" --set "
                       "\"Effects/Shear flexibility=off\" --set "
                       "\"Effects/Gravity=off\" --set "
                       "\"Effects/Contact=off\""));
}

TEST(EffectsStudy, JointOmissionWithLargeChangeIsNotRecommended)
{
  // Load and weight contribute equally: without either, half remains.
  const StudyReport report =
    effects_of(heavy_cantilever("1e12", "-100 * t")
                 .set("Effects/Shear flexibility", "off"),
               "0.0001 %");
  EXPECT_EQ(verdict_on(report, "Gravity"), "called for");
  EXPECT_FALSE(contains(report.text, "Effects/Gravity=off"));
}

TEST(EffectsStudy, InertiaIsLeftOutByStatics)
{
  SceneText scene = heavy_cantilever("1e9", "-10 * t^3");
  scene.remove("Gravity");
  scene.time(0.2, 0.01, "newmark");
  const StudyReport report = effects_of(scene, "1 %");
  EXPECT_EQ(verdict_on(report, "Inertia"), "called for");
  scene.set("Quantities/speed", "history tip.vy");
  const StudyReport speed_report = effects_of(scene, "1 %");
  EXPECT_EQ(verdict_on(speed_report, "Inertia"), "cannot be left out");
  EXPECT_TRUE(
    contains(speed_report.text, "Without Inertia: there is no tip.vy"));
}

TEST(EffectsStudy, ReducedCellHasNone)
{
  expect_parts(input_error_of(
                 []() { effects_of(cell_text(CellCase()), "1 %"); }),
               {"Kind = effects", "Model = lattice"});
}
