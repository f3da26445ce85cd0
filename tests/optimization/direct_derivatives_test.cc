#include <auxfem/optimization/direct_derivatives.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** Errors of the second order of it are below those allowed. */
  constexpr double difference_step = 1e-4;

  struct BothDerivatives
  {
    std::optional<Derivatives> direct;
    Derivatives                by_runs;
    GoalValues                 values;
  };

  /** Derivatives of the scene @p text at its own values, directly and by runs. */
  BothDerivatives derivatives_of(const SceneText &text)
  {
    const testing::TestInfo &test =
      *testing::UnitTest::GetInstance()->current_test_info();
    const std::string folder = std::string("direct-derivatives-") + test.name();
    std::filesystem::remove_all(folder);
    const Scene scene =
      read_scene_from_text(text, "test.prm", {"Output/Directory=" + folder});
    const DesignPoint point = first_design(scene);
    const FileRules   rules;
    std::filesystem::create_directories(folder);
    const SceneCase first = case_of_design(scene, point, folder + "/first");
    const CaseEnd   end   = run_cases(scene,
                                  {first},
                                  MPI_COMM_SELF,
                                  rules,
                                  [](std::size_t, const CaseEnd &, int) {})[0];
    EXPECT_EQ(end.failure, "");
    Goals           goals(scene, results_of(scene, first, end).results);
    DesignRuns      runs(scene,
                    goals,
                    MPI_COMM_SELF,
                    rules,
                    folder + "/differences",
                    {},
                    [](const Design &) {});
    BothDerivatives both;
    both.values  = goals.first();
    both.by_runs = derivatives_by_runs(runs, point, difference_step);
    const DifferenceFormulas formulas(point, direct_step);
    if (const auto values =
          nearby_goals(scene, point, formulas.points(), goals, MPI_COMM_SELF))
      both.direct = formulas.differences(*values);
    return both;
  }

  /** Expects that those of one kind of goal agree to 1e-6 of the goal or of its
   * largest derivative. */
  void expect_equal(const BothDerivatives &both,
                    std::vector<double> GoalDerivatives::*kind,
                    const std::vector<double>            &values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        double size = std::abs(values[i]);
        for (const auto &derivative : both.by_runs)
          size = std::max(size, std::abs(((*derivative).*kind)[i]));
        for (std::size_t v = 0; v < both.by_runs.size(); ++v)
          EXPECT_NEAR(((*both.direct->at(v)).*kind)[i],
                      ((*both.by_runs[v]).*kind)[i],
                      1e-6 * size)
            << "goal " << i << ", variable " << v;
      }
  }

  void expect_equal(const BothDerivatives &both)
  {
    ASSERT_TRUE(both.direct.has_value());
    ASSERT_EQ(both.direct->size(), both.by_runs.size());
    for (std::size_t v = 0; v < both.by_runs.size(); ++v)
      ASSERT_TRUE(both.direct->at(v) && both.by_runs[v]);
    EXPECT_NE(both.by_runs[0]->objectives[0], 0);
    expect_equal(both, &GoalDerivatives::objectives, both.values.objectives);
    expect_equal(both, &GoalDerivatives::limited, both.values.limited);
  }

  /** An elbow of two struts that bends by half a radian. */
  SceneText bent_elbow()
  {
    SceneText scene;
    scene.frame("0 0; 1 0; 1 1", "0 1; 1 2")
      .support("clamp", "0", "clamp")
      .probe("tip", "2")
      .add("Sections/lower",
           "Struts = 0 | Shape = rectangle | Width = 10 mm | Height = 10 mm | "
           "Young's modulus = 2 GPa | Density = 1000")
      .add("Sections/upper", "Base = lower | Struts = 1 | Height = 8 mm")
      .add("Loads/push", "Joints = 2 | Force x = -0.6 * t | Force y = -0.3 * t")
      .add("Connectors/stay",
           "Law = spring | Between = 0 2 | Spring stiffness = 0.2")
      .set("Newton/Tolerance", 1e-13)
      .set("Effects/Contact", "off")
      .set("Quantities/way", "tip.ux at end")
      .set("Quantities/deepest", "minimum of tip.uy")
      .set("Optimization/Objective", "minimize way; maximize deepest")
      .set("Optimization/Constraints",
           "mass_kilogram <= 1; clamp.y.peak_force <= 9")
      .set("Design variables/Sections/lower/Height", "5:20 mm")
      .set("Design variables/Sections/upper/Height", "5:20 mm logarithmic")
      .set("Design variables/Sections/lower/Young's modulus", "1:4 GPa")
      .set("Design variables/Connectors/stay/Spring stiffness", "0.1:1 N/m");
    return scene.time(1, 0.25, "static").mesh(4);
  }
} // namespace

// Both have the same differences of the goals; direct ones miss the second
// order of the distance, 1e-3 of the range.
TEST(DirectDerivatives, OfEquilibriaAgreeWithThoseOfRuns)
{
  expect_equal(derivatives_of(bent_elbow()));
}

TEST(DirectDerivatives, OfEffectivePropertiesAgreeWithThoseOfRuns)
{
  SceneText scene;
  scene.set("Analysis", "effective properties")
    .add("Lattice",
         "Cell = star | Strut length = 10 mm | Opening angle = 60 deg")
    .add(
      "Sections/edge",
      "Struts = edges | Shape = rectangle | Width = 10 mm | Height = 0.5 mm | "
      "Young's modulus = 2 GPa | Density = 1140")
    .add("Sections/stub", "Base = edge | Struts = stubs | Height = 0.4 mm")
    .set("Optimization/Objective", "minimize nu12; maximize E1")
    .set("Optimization/Constraints", "relative_density <= 0.1")
    .set("Design variables/Lattice/Opening angle", "50:70 deg")
    .set("Design variables/Sections/edge/Height", "0.2:1 mm")
    .set("Design variables/Sections/stub/Height", "0.2:1 mm logarithmic");
  expect_equal(derivatives_of(scene));
}

TEST(DirectDerivatives, OfBeamsInSpaceAgreeWithThoseOfRuns)
{
  SceneText scene = bent_elbow();
  scene.set("Dimension", 3)
    .set("Lattice/Joints", "0 0 0; 1 0 0; 1 1 0.5")
    .set("Loads/push/Force z", "0.4 * t")
    .set("Quantities/way", "tip.uz at end");
  expect_equal(derivatives_of(scene));
}

TEST(DirectDerivatives, OfFrequenciesAgreeWithThoseOfRuns)
{
  SceneText scene;
  scene.frame("0 0; 0 1; 1 1; 1 0", "0 1; 1 2; 2 3")
    .set("Analysis", "modes")
    .support("left", "0", "clamp")
    .support("right", "3", "clamp")
    .add("Sections/column",
         "Struts = 0 2 | Shape = rectangle | Width = 20 mm | Height = 20 mm | "
         "Young's modulus = 2 GPa | Density = 1000")
    .add("Sections/beam", "Base = column | Struts = 1 | Height = 30 mm")
    .set("Modes/Number", 3)
    .set("Optimization/Objective",
         "maximize modes.1.frequency_hertz; minimize modes.3.eigenvalue")
    .set("Optimization/Constraints",
         "mass_kilogram <= 2; modes.2.frequency_hertz >= 1")
    .set("Design variables/Sections/column/Height", "10:40 mm")
    .set("Design variables/Sections/beam/Height", "10:40 mm logarithmic");
  expect_equal(derivatives_of(scene.set("Discretization/Order", "auto")));
}

// A square column sways along both axes at one frequency; two frequencies part
// where it becomes flat.
TEST(DirectDerivatives, OfEqualFrequenciesAgreeWithThoseOfRuns)
{
  SceneText scene;
  scene.frame("0 0 0; 0 1 0", "0 1")
    .set("Analysis", "modes")
    .set("Dimension", 3)
    .support("base", "0", "clamp")
    .add("Sections/column",
         "Shape = rectangle | Width = 20 mm | Height = 20 mm | "
         "Young's modulus = 2 GPa | Density = 1000")
    .set("Modes/Number", 1)
    .set("Optimization/Objective", "maximize modes.1.frequency_hertz")
    .set("Design variables/Sections/column/Height", "10:40 mm");
  expect_equal(derivatives_of(scene.mesh(3)));
}

TEST(DirectDerivatives, OfFrequenciesAboutAnEquilibriumAgreeWithThoseOfRuns)
{
  SceneText scene;
  scene.frame("0 0; 0.5 0; 1 0", "0 1; 1 2")
    .set("Analysis", "modes")
    .support("left", "0", "clamp")
    .support("right", "2", "roller x")
    .add("Sections/bar",
         "Shape = rectangle | Width = 10 mm | Height = 10 mm | "
         "Young's modulus = 2 GPa | Density = 1000")
    .add("Loads/pull", "Joints = 2 | Force x = 300")
    .set("Modes/About", "static equilibrium")
    .set("Modes/Number", 2)
    .set("Newton/Tolerance", 1e-13)
    .set("Optimization/Objective", "maximize modes.1.frequency_hertz")
    .set("Design variables/Loads/pull/Force x", "100:500")
    .set("Design variables/Sections/bar/Height", "5:20 mm");
  expect_equal(derivatives_of(scene.mesh(4)));
}

// Inertia, plates and viscosity make states depend on the way to them.
TEST(DirectDerivatives, AreNotKnownInMotion)
{
  SceneText scene = bent_elbow();
  scene.set("Time/Scheme", "newmark").set("Optimization/Constraints", "none");
  EXPECT_FALSE(derivatives_of(scene).direct.has_value());
}
