#include <gtest/gtest.h>
#include <study/report_cells.h>
#include <study/swinging_beam.h>
#include <support/cell_scene.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  StudyReport small_study()
  {
    return study_of(swinging_beam(0.2, 20).set("Newton/Tolerance", "1e-10"),
                    {"Study/Kind=work-precision",
                     "Study/Repetitions=2",
                     "Study/Orders=1, 3",
                     "Study/Time steps=20 ms, 5 ms"});
  }

  double number(const StudyReport &report,
                const std::string &column,
                const std::string &order,
                const std::string &step)
  {
    for (const auto &row : report.rows)
      if (row[column_number(report, "order")] == order &&
          row[column_number(report, "time_step")] == step)
        return std::stod(row[column_number(report, column)]);
    throw std::runtime_error("no such run");
  }
} // namespace

TEST(WorkPrecisionStudy, ErrorsAreSplitIntoThoseOfMeshAndStep)
{
  const StudyReport report = small_study();
  ASSERT_EQ(report.rows.size(), 4u);
  // One linear element is far too stiff for any step length.
  EXPECT_GT(number(report, "error_by_mesh", "1", "0.005"), 0.05);
  EXPECT_NEAR(number(report, "error_by_mesh", "1", "0.005"),
              number(report, "error", "1", "0.005"),
              0.1 * number(report, "error", "1", "0.005"));
  // The finest mesh of the study has no mesh error by definition.
  EXPECT_EQ(number(report, "error_by_mesh", "3", "0.02"), 0);
  EXPECT_EQ(number(report, "error_by_step", "3", "0.02"),
            number(report, "error", "3", "0.02"));
  // Second order: a quarter of the step gives a sixteenth of the error. The
  // reference has another quarter.
  EXPECT_NEAR(number(report, "error_by_step", "3", "0.02") /
                number(report, "error_by_step", "3", "0.005"),
              16,
              3);
}

TEST(WorkPrecisionStudy, BestRunsHaveNoCheaperAndBetterOne)
{
  const StudyReport report = small_study();
  const auto        at     = [&report](const std::string &name) {
    return column_number(report, name);
  };
  unsigned int n_best = 0;
  for (const auto &one : report.rows)
    {
      bool is_beaten = false;
      for (const auto &other : report.rows)
        is_beaten |= std::stod(other[at("cpu")]) < std::stod(one[at("cpu")]) &&
          std::stod(other[at("error")]) <= std::stod(one[at("error")]);
      EXPECT_EQ(one[at("best")], is_beaten ? "0" : "1");
      n_best += !is_beaten;
    }
  EXPECT_GT(n_best, 0u);
  // Independently of times, one run has the smallest error.
  ASSERT_EQ(report.pictures.size(), 1u);
  EXPECT_EQ(report.pictures[0].curves.front().points.size(), n_best);
  EXPECT_TRUE(contains(report.text, "## What to take"));
}

TEST(WorkPrecisionStudy, ReducedCellHasNoMesh)
{
  const StudyReport report = study_of(cell_text(CellCase()),
                                      {"Study/Kind=work-precision",
                                       "Study/Repetitions=1",
                                       "Study/Schemes=newmark, hht",
                                       "Study/Time steps=0.2 ms, 0.1 ms"});
  EXPECT_EQ(report.rows.size(), 4u);
  for (const char *const heading : {"order", "elements a strut", "by mesh"})
    EXPECT_FALSE(contains(report.text, heading)) << report.text;
  for (const Column &column : report.columns)
    EXPECT_TRUE(column.name != "order" && column.name != "error_by_mesh");
  for (const auto &row : report.rows)
    EXPECT_EQ(row.size(), report.columns.size());
  EXPECT_EQ(report.pictures[0].curves[1].title.find(','), std::string::npos);
}

// F L^3 / (3 E I) at small displacements; shear is negligible.
TEST(WorkPrecisionStudy, ExactValuesTakeNoReference)
{
  SceneText scene;
  scene.frame("0 0; 1 0", "0 1").section({1000, 1e9, 4});
  scene.support("clamp", "0", "clamp").load("push", "1", {"0", "t", "0"});
  scene.linear().set("Time/Scheme", "static").probe("tip", "1");
  scene.set("Quantities/deflection", "tip.uy at end = 1/12");
  const StudyReport report = study_of(scene,
                                      {"Study/Kind=work-precision",
                                       "Study/Repetitions=1",
                                       "Study/Orders=1, 2"});
  EXPECT_TRUE(contains(report.text, "against exact values")) << report.text;
  EXPECT_NEAR(std::stod(cells_where(report, "error", "order", "1")[0]),
              0.25,
              1e-6);
  EXPECT_LT(std::stod(cells_where(report, "error", "order", "2")[0]), 1e-6);
}
