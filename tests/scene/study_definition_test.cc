#include <auxfem/scene/scene.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <support/messages.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  using Measure = QuantityDefinition::Measure;

  SceneText cantilever()
  {
    SceneText scene;
    scene.frame("0 0; 1 0", "0 1")
      .section({1, 1, 1})
      .support("clamp", "0", "clamp");
    return scene.time(1, 0.1, "static").probe("tip", "1");
  }

  StudyDefinition study_with(const std::string &parameter,
                             const std::string &value)
  {
    return read_scene_from_text(cantilever().set("Study/" + parameter, value),
                                "test.prm")
      .study;
  }

  QuantityDefinition quantity_from(const std::string &text)
  {
    return read_scene_from_text(cantilever().set("Quantities/deflection", text),
                                "test.prm")
      .study.quantities.at(0);
  }

  std::string refusal_of(const std::string &path, const std::string &value)
  {
    return input_error_of([&]() {
      read_scene_from_text(cantilever().set(path, value), "test.prm");
    });
  }
} // namespace

TEST(StudyDefinition, ScenesAreSimulationsUnlessTheyAskForMore)
{
  EXPECT_EQ(read_scene_from_text(cantilever(), "test.prm").analysis,
            Analysis::simulation);
  EXPECT_EQ(
    read_scene_from_text(cantilever(), "test.prm", {"Analysis=study"}).analysis,
    Analysis::study);
}

TEST(StudyDefinition, AutoLeavesTheChoiceToTheStudyAndNoneTakesTheScene)
{
  EXPECT_FALSE(study_with("Refinements", "auto").refinements.has_value());
  EXPECT_TRUE(study_with("Refinements", "none").refinements->empty());
  EXPECT_FALSE(study_with("Time steps", "auto").time_steps.has_value());
  EXPECT_TRUE(study_with("Time steps", "none").time_steps->empty());
  EXPECT_FALSE(study_with("Orders", "auto").orders.has_value());
  EXPECT_TRUE(study_with("Schemes", "none").schemes.empty());
}

TEST(StudyDefinition, ListsAreReadWithTheirUnits)
{
  using Whole = std::vector<unsigned int>;
  EXPECT_EQ(*study_with("Orders", "1, 3").orders, (Whole{1, 3}));
  EXPECT_EQ(*study_with("Refinements", "0 2 4").refinements, (Whole{0, 2, 4}));
  const auto steps = *study_with("Time steps", "2 ms, 0.5 ms").time_steps;
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_DOUBLE_EQ(steps[0], 2e-3);
  EXPECT_DOUBLE_EQ(steps[1], 5e-4);
  EXPECT_EQ(study_with("Schemes", "newmark, hht").schemes,
            (std::vector<std::string>{"newmark", "hht"}));
  EXPECT_DOUBLE_EQ(study_with("Tolerance", "0.1 %").tolerance, 1e-3);
}

TEST(StudyDefinition, WrongListsAreRefused)
{
  expect_parts(refusal_of("Study/Orders", "1.5, 2"),
               {"Study/Orders", "1.5", "whole numbers"});
  expect_parts(refusal_of("Study/Orders", "7"), {"Study/Orders", "7", "6"});
  expect_parts(refusal_of("Study/Schemes", "newmrk"),
               {"Study/Schemes", "newmrk", "did you mean \"newmark\""});
  // of the reduced cell alone
  expect_parts(refusal_of("Study/Schemes", "arkode"), {"arkode", "allowed"});
  expect_parts(refusal_of("Study/Refine together", "true"),
               {"Study/Refine together", "as many Refinements as Time steps"});
}

TEST(StudyDefinition, EveryFormOfAQuantityIsRead)
{
  const QuantityDefinition history = quantity_from("history tip.ux, tip.uy");
  EXPECT_EQ(history.name, "deflection");
  EXPECT_EQ(history.measure, Measure::history);
  EXPECT_EQ(history.columns, (std::vector<std::string>{"tip.ux", "tip.uy"}));
  EXPECT_FALSE(history.exact.has_value());

  const QuantityDefinition at_time = quantity_from("tip.uy at 5 ms");
  EXPECT_EQ(at_time.measure, Measure::at_time);
  EXPECT_EQ(at_time.columns, (std::vector<std::string>{"tip.uy"}));
  EXPECT_DOUBLE_EQ(*at_time.time, 5e-3);
  EXPECT_FALSE(quantity_from("tip.uy at end").time.has_value());

  EXPECT_EQ(quantity_from("maximum of tip.uy").measure, Measure::maximum);
  EXPECT_EQ(quantity_from("minimum of tip.uy").measure, Measure::minimum);
  EXPECT_EQ(quantity_from("time of maximum of tip.uy").measure,
            Measure::time_of_maximum);
  EXPECT_EQ(quantity_from("time of minimum of tip.uy").measure,
            Measure::time_of_minimum);
  EXPECT_EQ(quantity_from("integral of clamp.ry").measure, Measure::integral);
}

TEST(StudyDefinition, ExactValuesAreFunctionsOfTimeWithConstants)
{
  const Scene scene =
    read_scene_from_text(cantilever()
                           .set("Constants", "F = 2")
                           .set("Quantities/deflection",
                                "history tip.uy = F * t^2 / 3"),
                         "test.prm");
  EXPECT_DOUBLE_EQ(scene.study.quantities[0].exact->value(3), 6);
  EXPECT_DOUBLE_EQ(quantity_from("tip.uy at end = -2.5 mm").exact->value(0),
                   -2.5e-3);
  EXPECT_DOUBLE_EQ(quantity_from("tip.uy at end = 1/12 + 1/50").exact->value(0),
                   1. / 12 + 1. / 50);
}

TEST(StudyDefinition, QuantitiesThatAreNotUnderstoodAreRefused)
{
  expect_parts(refusal_of("Quantities/q", "tip.uy"),
               {"Quantities/q", "tip.uy", "allowed", "maximum of COLUMN"});
  expect_parts(refusal_of("Quantities/q", "tip.uy at noon"),
               {"Quantities/q", "noon", "5 ms, or end"});
  expect_parts(refusal_of("Quantities/q", "maximum of tip.ux, tip.uy"),
               {"Quantities/q", "history only"});
  expect_parts(refusal_of("Quantities/q", "tip.uy at end = 3 *"),
               {"Quantities/q: ", "3 *"});
}

TEST(StudyDefinition, SurvivesBeingWrittenWithAllParameters)
{
  const Scene scene =
    read_scene_from_text(cantilever()
                           .set("Study/Time steps", "2 ms, 1 ms")
                           .set("Quantities/deflection",
                                "tip.uy at 5 ms = 0.25"),
                         "test.prm");
  const StudyDefinition again =
    read_scene_from_text(scene.all_parameters, "test.prm").study;
  EXPECT_EQ(again.time_steps, scene.study.time_steps);
  ASSERT_EQ(again.quantities.size(), 1u);
  EXPECT_DOUBLE_EQ(again.quantities[0].exact->value(0), 0.25);
}

TEST(StudyDefinition, NormsAreOfFieldsAndHaveNoColumns)
{
  const QuantityDefinition at_end = quantity_from("energy norm at end");
  EXPECT_EQ(at_end.measure, Measure::energy_norm);
  EXPECT_TRUE(at_end.is_field());
  EXPECT_FALSE(at_end.is_number());
  EXPECT_TRUE(at_end.columns.empty());
  EXPECT_FALSE(at_end.time.has_value());
  const QuantityDefinition total = quantity_from("total energy norm at 20 ms");
  EXPECT_EQ(total.measure, Measure::total_energy_norm);
  EXPECT_EQ(total.time, 0.02);
  expect_parts(refusal_of("Quantities/deflection", "energy norm"),
               {"Quantities/deflection", "energy norm at TIME"});
  expect_parts(refusal_of("Quantities/deflection", "energy norm at noon"),
               {"Quantities/deflection", "allowed after \"at\""});
  expect_parts(refusal_of("Quantities/deflection", "energy norm at end = 1"),
               {"Quantities/deflection", "no exact value", "remove"});
}

TEST(StudyDefinition, StudyIsExactIfAllItsQuantitiesAre)
{
  const auto is_exact = [](SceneText scene) {
    return read_scene_from_text(scene, "test.prm").study.is_exact();
  };
  SceneText scene = cantilever();
  EXPECT_FALSE(is_exact(scene));
  scene.set("Quantities/one", "tip.ux at end = 0");
  EXPECT_TRUE(is_exact(scene));
  scene.set("Quantities/other", "tip.uy at end");
  EXPECT_FALSE(is_exact(scene));
}
