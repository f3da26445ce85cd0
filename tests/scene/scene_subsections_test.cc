#include <auxfem/parameters/describe.h>
#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>

namespace
{
  using namespace auxfem;

  TEST(SceneSubsections, EveryParameterHasASentenceAndAnAllowedDefault)
  {
    const auto check = [](const Parameters &parameters) {
      for (const Parameter &parameter : parameters)
        {
          EXPECT_GT(parameter.sentence.size(), 3u) << parameter.name;
          EXPECT_EQ(parameter.sentence.back(), '.') << parameter.name;
          EXPECT_EQ(parameter.problem(parameter.default_value), "")
            << parameter.name;
        }
    };
    for (const SubsectionSchema &schema : scene_schemas())
      {
        check(schema.parameters);
        EXPECT_EQ(schema.choice.empty(), schema.variants.empty())
          << schema.name;
        for (const SubsectionVariant &variant : schema.variants)
          check(variant.parameters);
      }
  }



  TEST(SceneSubsections, TheReferenceNamesSetsOfCells)
  {
    const std::string page = describe_parameters_markdown(scene_schemas());
    for (const char *part :
         {"force: N, kN, MN, mN, lbf",
          "`table: FILE`",
          "- operators: `+ - * /",
          "Sets of joints: notches, tips. Sets of struts: edges, stubs. Pairs "
          "for connectors: in-cell, in-cell x, rod.",
          "bar AB, bar AF, bar CD, bar DE, bars, lower part, rod, upper part"})
      EXPECT_NE(page.find(part), std::string::npos) << part;
  }
} // namespace
