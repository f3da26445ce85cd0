#include <gtest/gtest.h>
#include <study/report_cells.h>
#include <study/swinging_beam.h>
#include <support/cell_scene.h>
#include <support/scene_text.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** F L^3 / (3 E I) + F L / (G A) = 1 / 12 + 1 / 50 at small displacements. */
  SceneText cantilever()
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1").section({1000, 50, 4});
    scene.support("clamp", "0", "clamp").load("push", "1", {"0", "t", "0"});
    scene.set("Newton/Tolerance", "1e-12").linear();
    return scene.set("Time/Scheme", "static").probe("tip", "1");
  }
} // namespace

TEST(ConvergenceStudy, ErrorsAgainstExactValueAreTrueErrors)
{
  const StudyReport report =
    study_of(cantilever().set("Quantities/deflection",
                              "tip.uy at end = 1/12 + 1/50"),
             {"Study/Orders=1", "Study/Refinements=1, 2, 3"});
  const auto   values = cells_where(report, "deflection.value", "role", "run");
  const auto   errors = cells_where(report, "deflection.error", "role", "run");
  const double exact  = 1. / 12 + 1. / 50;
  ASSERT_EQ(values.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      // One point per linear element acts like an EI larger by h^2 / 4.
      const double h         = std::ldexp(1, -int(i) - 1);
      const double too_stiff = (1 - h * h / 4) / 12 + 1. / 50;
      EXPECT_NEAR(std::stod(values[i]), too_stiff, 1e-10) << i;
      EXPECT_NEAR(std::stod(errors[i]), 1 - too_stiff / exact, 1e-9) << i;
    }
  EXPECT_NEAR(
    last_number_where(report, "deflection.observed_order", "role", "run"),
    2,
    1e-6);
  // All quantities are exact, so no reference is computed.
  EXPECT_EQ(report.rows.size(), 3u);
  EXPECT_TRUE(contains(report.text, "Reference: exact values."));
}

TEST(ConvergenceStudy, OneExactValueOfTwoKeepsReference)
{
  const StudyReport report =
    study_of(cantilever()
               .set("Quantities/deflection", "tip.uy at end = 1/12 + 1/50")
               .set("Quantities/turn", "tip.phi at end"),
             {"Study/Orders=1", "Study/Refinements=1, 2"});
  EXPECT_EQ(report.rows.size(), 4u);
  EXPECT_TRUE(contains(report.text, "deflection 0 (exact value), turn "));
}

TEST(ConvergenceStudy, ConvergenceIndexBoundsTheTrueError)
{
  const StudyReport report =
    study_of(cantilever().set("Quantities/deflection",
                              "tip.uy at end = 1/12 + 1/50"),
             {"Study/Orders=1", "Study/Refinements=1, 2, 3"});
  const double error =
    last_number_where(report, "deflection.error", "role", "run");
  const double index =
    last_number_where(report, "deflection.convergence_index", "role", "run");
  // In the asymptotic range the index is the error times its safety factor.
  EXPECT_NEAR(index / error, 1.25, 0.01);
}

TEST(ConvergenceStudy, ExtrapolationFindsTheLimit)
{
  // The error at order 1 is known; the limit of three such runs is exact.
  const StudyReport report =
    study_of(cantilever().set("Quantities/deflection", "tip.uy at end"),
             {"Study/Orders=1",
              "Study/Reference=extrapolation",
              "Study/Refinements=1, 2, 3"});
  const double exact = 1. / 12 + 1. / 50;
  EXPECT_NEAR(last_number_where(report, "deflection.error", "role", "run"),
              1. / 64 / 4 / 12 / exact,
              1e-8);
}

// Bending moments of linear elements are constant and exact at midpoints. Their
// squared error against M = F (L - s) integrates to F^2 L^3 / (12 n^2), M^2 to
// F^2 L^3 / 3. Shear has no error.
TEST(ConvergenceStudy, EnergyNormErrorIsTrueError)
{
  const StudyReport report =
    study_of(cantilever().set("Quantities/field", "energy norm at end"),
             {"Study/Orders=1", "Study/Refinements=1, 2, 3"});
  const auto errors = cells_where(report, "field.error", "role", "run");
  ASSERT_EQ(errors.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double n = std::ldexp(1, i + 1), bending = 1. / 12, shear = 1. / 50;
      // Order 2, the reference, has the exact moments.
      EXPECT_NEAR(std::stod(errors[i]),
                  std::sqrt(bending / (bending + shear)) / (2 * n),
                  1e-9)
        << i;
    }
  EXPECT_EQ(cells_where(report, "field.value", "role", "run")[0], "");
  EXPECT_NEAR(last_number_where(report, "field.observed_order", "role", "run"),
              1,
              1e-6);
}

TEST(ConvergenceStudy, WithoutQuantitiesProbesAreComparedAsVectors)
{
  const StudyReport report = study_of(cantilever(), {"Study/Orders=1"});
  EXPECT_EQ(cells_where(report, "tip.error", "role", "run").size(), 3u);
  // Three runs and two references.
  EXPECT_EQ(report.rows.size(), 5u);
}

TEST(ConvergenceStudy, AutomaticListsSurroundSceneValues)
{
  const StudyReport report = study_of(swinging_beam(0.2, 20), {});
  EXPECT_EQ(cells_where(report, "elements", "refined", "mesh"),
            (std::vector<std::string>{"1", "2", "4", "4", "8"}));
  EXPECT_EQ(
    cells_where(report, "time_step", "refined", "time step"),
    (std::vector<std::string>{"0.04", "0.02", "0.01", "0.005", "0.0025"}));
  EXPECT_EQ(report.pictures.size(), 2u);
  EXPECT_TRUE(contains(report.text, "\n- for "));
}

TEST(ConvergenceStudy, NewtonToleranceHasItsOwnError)
{
  const StudyReport report =
    study_of(swinging_beam(0.2, 20),
             {"Study/Time steps=none",
              "Study/Refinements=none",
              "Study/Newton tolerances=1e-1, 1e-3, 1e-5"});
  const auto errors = cells_where(report, "tip.error", "role", "run");
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_GT(std::stod(errors[0]), 10 * std::stod(errors[2]));
  EXPECT_LT(std::stod(errors[2]), 1e-4);
}

TEST(ConvergenceStudy, JointRefinementHasOrderOfTimeStep)
{
  const StudyReport report =
    study_of(swinging_beam(0.2, 20).set("Newton/Tolerance", "1e-10"),
             {"Study/Refine together=true",
              "Study/Orders=1",
              "Study/Refinements=1, 2, 3",
              "Study/Time steps=4 ms, 2 ms, 1 ms"});
  EXPECT_NEAR(last_number_where(report, "tip.observed_order", "role", "run"),
              2,
              0.1);
}

TEST(ConvergenceStudy, SchemesOfTheReducedCellHaveSecondOrder)
{
  CellCase          cell;
  const StudyReport report =
    study_of(cell_text(cell),
             {"Study/Schemes=central difference, newmark",
              "Study/Reference=extrapolation",
              "Study/Time steps=0.2 ms, 0.1 ms, 0.05 ms"});
  for (const char *const scheme : {"central difference", "newmark"})
    EXPECT_NEAR(
      last_number_where(report, "theta.observed_order", "scheme", scheme),
      2,
      0.1)
      << scheme;
}

TEST(ConvergenceStudy, ReducedCellHasNeitherOrderNorElements)
{
  const StudyReport report = study_of(cell_text(CellCase()),
                                      {"Study/Time steps=0.2 ms, 0.1 ms",
                                       "Study/Newton tolerances=1e-4, 1e-6"});
  for (const Column &column : report.columns)
    EXPECT_TRUE(column.name != "order" && column.name != "elements");
  EXPECT_TRUE(contains(report.text, "## Error by Newton tolerance: arkode\n"))
    << report.text;
}

TEST(ConvergenceStudy, FailedRunsAreNamedAndDoNotEndTheStudy)
{
  // Only steps of 40 ms hit 0.12 s, where the load is NaN.
  const StudyReport report =
    study_of(swinging_beam(0.2, 20).set("Loads/push/Force x",
                                        "if(abs(t - 0.12) < 1e-9, 0 / 0, 0)"),
             {"Study/Refinements=none",
              "Study/Time steps=40 ms, 25 ms, 12.5 ms"});
  const auto exits = cells_where(report, "exit", "role", "run");
  ASSERT_EQ(exits.size(), 3u);
  EXPECT_TRUE(contains(exits[0], "0.12")) << exits[0];
  EXPECT_EQ(exits[1], "completed");
  EXPECT_EQ(exits[2], "completed");
  EXPECT_EQ(cells_where(report, "tip.error", "role", "run")[0], "");
  EXPECT_NE(cells_where(report, "tip.error", "role", "run")[2], "");
  EXPECT_TRUE(contains(report.text, "Failed at 0.04: "));
  EXPECT_TRUE(contains(report.text, "failed |"));
}

TEST(ConvergenceStudy, ReferenceThatFailsIsAFindingNotAnError)
{
  // Only the finest steps hit 0.1975 s.
  const StudyReport report =
    study_of(swinging_beam(0.2, 20).set("Loads/push/Force x",
                                        "if(abs(t - 0.1975) < 1e-9, 0 / 0, 0)"),
             {"Study/Refinements=none"});
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].verdict, Verdict::not_to_be_used);
  EXPECT_TRUE(contains(report.findings[0].text, "reference"));
  EXPECT_EQ(cells_where(report, "tip.error", "role", "run"),
            (std::vector<std::string>{"", "", ""}));
}

TEST(ConvergenceStudy, FieldsAreComparedWhereNoStepEnds)
{
  const StudyReport report =
    study_of(swinging_beam(0.4, 160)
               .set("Discretization/Order", 2)
               .set("Quantities/field", "total energy norm at 0.3337 s"),
             {"Study/Orders=none",
              "Study/Refinements=none",
              "Study/Time steps=10 ms, 5 ms, 2.5 ms"});
  EXPECT_NEAR(last_number_where(report, "field.observed_order", "role", "run"),
              2,
              0.1);
}

TEST(ConvergenceStudy, ErrorsAreReportedBeforeTheFirstRun)
{
  const auto refusal = [](const SceneText                &scene,
                          const std::vector<std::string> &overrides) {
    return input_error_of([&]() { study_of(scene, overrides); });
  };
  expect_parts(
    refusal(cantilever().set("Quantities/q", "history tp.uy"), {}),
    {"Quantities/q", "tp.uy", "did you mean \"tip.uy\"", "clamp.ry"});
  expect_parts(refusal(cantilever().set("Quantities/q", "tip.uy at 2 s"), {}),
               {"Quantities/q", "not between 0 and the end time"});
  expect_parts(
    refusal(cantilever().set("Quantities/q", "total energy norm at end"), {}),
    {"Quantities/q", "no kinetic energy", "Allowed: energy norm"});
  expect_parts(
    refusal(cantilever().set("Quantities/q", "energy norm at end = 1"), {}),
    {"Quantities/q", "no exact value", "remove"});
  expect_parts(input_error_of([]() {
                 study_of(cell_text(CellCase()),
                          {"Quantities/q=energy norm at end"});
               }),
               {"Quantities/q", "Model = lattice"});
  expect_parts(refusal(cantilever(), {"Study/Refinements=none"}),
               {"refines nothing", "Refinements"});
}

TEST(ConvergenceStudy, StaticsAndDynamicsAreNotCompared)
{
  expect_parts(input_error_of([]() {
                 study_of(swinging_beam(0.2, 20),
                          {"Study/Schemes=newmark, static"});
               }),
               {"Study/Schemes", "static", "newmark", "Remove one"});
}

TEST(ConvergenceStudy, DetectsQuantitiesThatAreZeroBySymmetry)
{
  SceneText scene;
  scene.cells("star", 2, 2);
  scene.rectangle("strut", "1 mm", "1 mm", {"2 GPa", 1000, 0.3});
  scene.support("base", "bottom", "clamp");
  // The quantity is round-off, which may agree in both references by chance;
  // with this load the signs differ.
  scene.load("push", "top", {"0", "-0.15 * t", "0"});
  scene.time(1, 0.25, "static").probe("top", "top");
  scene.set("Quantities/sideways", "top.ux at end");
  scene.set("Quantities/down", "top.uy at end");
  const StudyReport report = study_of(scene, {"Study/Orders=1"});
  ASSERT_EQ(report.findings.size(), 1u) << report.text;
  EXPECT_EQ(report.findings[0].verdict, Verdict::doubtful);
  EXPECT_TRUE(contains(report.findings[0].text, "\"sideways\""));
  // Recommendations ignore it.
  EXPECT_TRUE(contains(report.text, "\n- for 10 %:")) << report.text;
}
