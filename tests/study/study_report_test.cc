#include <auxfem/study/refinement.h>
#include <auxfem/study/study_report.h>

#include <gtest/gtest.h>

#include <cmath>

#include <support/messages.h>

using namespace auxfem;

TEST(StudyReport, TablesAreAlignedMarkdown)
{
  const TextTable table{{"step", "error"},
                        {{"0.1", "1.00e-02"}, {"0.05", "-"}}};
  EXPECT_EQ(table.markdown(),
            "| step |    error |\n"
            "| ---: | -------: |\n"
            "|  0.1 | 1.00e-02 |\n"
            "| 0.05 |        - |\n");
}

TEST(StudyReport, NumbersAreReadable)
{
  EXPECT_EQ(error_text(1.234e-5), "1.23e-05");
  EXPECT_EQ(error_text({}), "-");
  EXPECT_EQ(decimal_text(2.005, 1), "2.0");
  EXPECT_EQ(percent_text(0.066), "7 %");
  EXPECT_EQ(number_text(4.9999999999999996e-05), "5e-05");
  EXPECT_EQ(number_text(0.25), "0.25");
}

TEST(StudyReport, ScriptsOfPicturesAreThoseOfGnuplot)
{
  LogPicture picture{"error-mesh", "Error by mesh", "h", "it's", {}};
  picture.curves.push_back({"order 1", {{1, 0.5}, {0.5, 0.125}}});
  const std::string script = gnuplot_script(picture);
  expect_parts(script,
               {"$curve0 << end_of_data\n1 0.5\n0.5 0.125\nend_of_data\n",
                "set logscale xy",
                "set ylabel 'it''s'",
                "set output 'error-mesh.svg'",
                "set output 'error-mesh.png'",
                "title 'order 1'"});
}

TEST(StudyReport, MethodsKeepTheirColours)
{
  LogPicture picture{"error-mesh", "Error by mesh", "h", "error", {}};
  picture.curves.push_back(
    {"of one order", {{1, 1}}, {colour_of_order(2), 0, 0}});
  picture.curves.push_back({"the same", {{1, 2}}, {colour_of_order(2), 1, 1}});
  picture.curves.push_back({"another", {{1, 3}}, {colour_of_order(3), 0, 0}});
  const std::string script = gnuplot_script(picture);
  expect_parts(
    script,
    {"linecolor '#D55E00' dashtype 1 pointtype 4 title 'of one order'",
     "linecolor '#D55E00' dashtype 2 pointtype 5 title 'the same'",
     "linecolor '#009E73' dashtype 1 pointtype 4 title 'another'"});
  EXPECT_EQ(colour_of_scheme("newmark"), 0u);
  EXPECT_NE(colour_of_scheme("hht"), colour_of_scheme("newmark"));
}

TEST(StudyReport, SlopesOfWholeNumbersAreMarkedOnce)
{
  LogPicture picture{"error-mesh", "Error by mesh", "h", "error", {}};
  const auto add = [&picture](const std::string &name, const double slope) {
    Curve curve{name, {}};
    for (const double h : {1., 0.5, 0.25})
      curve.points.emplace_back(h, 0.1 * std::pow(h, slope));
    picture.curves.push_back(curve);
  };
  add("a", 2);
  add("b", 2.05);
  add("c", 3.9);
  add("d", 2.5);
  EXPECT_FALSE(contains(gnuplot_script(picture), "slope"));
  picture.marks_slopes     = true;
  const std::string script = gnuplot_script(picture);
  expect_parts(script, {"set label 'slope 2'", "set label 'slope 4'"});
  EXPECT_EQ(script.find("slope 2"), script.rfind("slope 2"));
  EXPECT_FALSE(contains(script, "slope 3"));
}

TEST(StudyReport, ReferencesThatFailMakeResultsUseless)
{
  MeasuredRun run;
  run.exit_state = "no convergence";
  std::vector<Finding> findings;
  add_finding_on_reference(run, "The reference", findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].verdict, Verdict::not_to_be_used);
  expect_parts(findings[0].text, {"The reference failed", "no convergence"});

  run.exit_state = "completed";
  add_finding_on_reference(run, "The reference", findings);
  EXPECT_EQ(findings.size(), 1u);
  run.verdict = Verdict::doubtful;
  add_finding_on_reference(run, "The reference", findings);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[1].verdict, Verdict::doubtful);
}
