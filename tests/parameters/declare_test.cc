#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/value_pattern.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

namespace
{
  using namespace auxfem;

  const Quantity length   = {"Length",
                             "10 mm",
                             "m",
                             Range::positive(),
                             "Length of something."};
  const Quantity angle    = {"Angle",
                             "60",
                             "deg",
                             {0, 90, true, false},
                             "Angle of something."};
  const Quantity required = {"Required", "", "1", Range::any(), "No default."};
  const Quantity with_word =
    {"Word", "auto", "1", Range::any(), "Number or word.", {"auto"}};
  const QuantityList list =
    {"List", "1, 2 m", "mm", Range::non_negative(), 1, 3, "Numbers."};
  const Integer        integer = {"Integer", 3, 1, 6, "Whole number."};
  const Boolean        boolean = {"Boolean", true, "Yes or no."};
  const Choice         choice  = {"Choice", "b", {"a", "b"}, "One of two."};
  const Text           text    = {"Text", "free text", "Anything."};
  const TimeExpression course  = {"Course",
                                  "2*t",
                                  "m",
                                  "Function of time.",
                                  {"free"}};

  void declare_all(dealii::ParameterHandler &prm)
  {
    declare(prm, length);
    declare(prm, angle);
    declare(prm, required);
    declare(prm, with_word);
    declare(prm, list);
    declare(prm, integer);
    declare(prm, boolean);
    declare(prm, choice);
    declare(prm, text);
    declare(prm, course);
  }

  TEST(Declare, DefaultsComeInSI)
  {
    dealii::ParameterHandler prm;
    declare_all(prm);
    EXPECT_DOUBLE_EQ(get(prm, length), 0.01);
    EXPECT_DOUBLE_EQ(get(prm, angle), dealii::numbers::PI / 3);
    EXPECT_TRUE(is_word(prm, with_word));
    EXPECT_EQ(get(prm, list), (std::vector<double>{1e-3, 2}));
    EXPECT_EQ(get(prm, integer), 3u);
    EXPECT_TRUE(get(prm, boolean));
    EXPECT_EQ(get(prm, choice), "b");
    EXPECT_EQ(get(prm, text), "free text");
    EXPECT_EQ(get(prm, course), "2*t");
  }



  TEST(Declare, MissingAndMisplacedValuesAreRefused)
  {
    dealii::ParameterHandler prm;
    declare_all(prm);
    EXPECT_THROW(get(prm, required), InputError);
    EXPECT_THROW(get(prm, with_word), InputError);
    prm.set("Word", "3");
    EXPECT_FALSE(is_word(prm, with_word));
    EXPECT_DOUBLE_EQ(get(prm, with_word), 3);
  }



  TEST(Declare, ListsMayBeAWord)
  {
    const QuantityList axes =
      {"Axes", "auto", "m", Range::any(), 2, 3, "Numbers.", {"auto"}};
    dealii::ParameterHandler prm;
    declare(prm, axes);
    EXPECT_TRUE(is_word(prm, axes));
    EXPECT_THROW(get(prm, axes), InputError);
    prm.set("Axes", std::string("1 2 mm"));
    EXPECT_FALSE(is_word(prm, axes));
    EXPECT_EQ(get(prm, axes), (std::vector<double>{1, 2e-3}));
    EXPECT_THROW(prm.set("Axes", std::string("automatic")),
                 dealii::ExceptionBase);
  }



  TEST(Declare, FunctionsOfTimeMayHaveAUnitWord)
  {
    dealii::ParameterHandler prm;
    declare_all(prm);
    prm.set("Course", "10 mm");
    EXPECT_DOUBLE_EQ(std::stod(get(prm, course)), 0.01);
    for (const char *as_written :
         {"free", "0.5", "2e7*t^3", "3 * t", "3/2", "1/t", "table: a.csv, 2"})
      {
        prm.set("Course", as_written);
        EXPECT_EQ(get(prm, course), as_written);
      }
  }



  TEST(Declare, PatternRefusesWhatIsNotAllowed)
  {
    dealii::ParameterHandler prm;
    declare_all(prm);
    const auto refuses = [&prm](const char *name, const char *value) {
      EXPECT_THROW(prm.set(name, std::string(value)), dealii::ExceptionBase)
        << name << " = " << value;
    };
    refuses("Length", "0");
    refuses("Length", "-1 mm");
    refuses("Length", "1 kg");
    refuses("Length", "long");
    refuses("Angle", "0");
    refuses("Angle", "91 deg");
    refuses("Angle", "2 rad");
    refuses("Word", "automatic");
    refuses("List", "1 2 3 4");
    refuses("List", "1, -2");
    refuses("Integer", "0");
    refuses("Integer", "7");
    refuses("Integer", "2.5");
    refuses("Boolean", "maybe");
    refuses("Choice", "c");
    refuses("Course", "10 kg");
    prm.set("Angle", std::string("90"));
    prm.set("Integer", std::string("6"));
  }



  TEST(Declare, RangesAreShownAsTheyAre)
  {
    EXPECT_EQ(Range::any().text(), "");
    EXPECT_EQ(Range::positive().text(), "> 0");
    EXPECT_EQ(Range::non_negative().text(), ">= 0");
    EXPECT_EQ(Range::closed(1, 6).text(), ">= 1 and <= 6");
    EXPECT_EQ(Range::open(-1, 0.5).text(), "> -1 and < 0.5");
  }



  TEST(Declare, RuleSurvivesInThePatternsDescription)
  {
    ValueRule rule;
    rule.kind           = ValueRule::Kind::quantity_list;
    rule.unit           = "N s/m";
    rule.range          = {-1. / 3, 1e300, true, false};
    rule.words          = {"auto", "two words"};
    rule.minimum_length = 2;
    rule.maximum_length = 5;
    rule.required       = true;

    const auto restored =
      rule_from_description(ValuePattern(rule).description());
    ASSERT_TRUE(restored);
    EXPECT_EQ(restored->kind, rule.kind);
    EXPECT_EQ(restored->unit, rule.unit);
    EXPECT_EQ(restored->range.minimum, rule.range.minimum);
    EXPECT_EQ(restored->range.maximum, rule.range.maximum);
    EXPECT_EQ(restored->range.minimum_open, rule.range.minimum_open);
    EXPECT_EQ(restored->range.maximum_open, rule.range.maximum_open);
    EXPECT_EQ(restored->words, rule.words);
    EXPECT_EQ(restored->minimum_length, rule.minimum_length);
    EXPECT_EQ(restored->maximum_length, rule.maximum_length);
    EXPECT_EQ(restored->required, rule.required);

    const ValueRule unlimited;
    const auto      same =
      rule_from_description(ValuePattern(unlimited).description());
    ASSERT_TRUE(same);
    EXPECT_EQ(same->range.text(), "");
    EXPECT_TRUE(same->words.empty());
    EXPECT_FALSE(rule_from_description("[Anything]"));
  }



  TEST(Declare, ProblemsNameValueAndConversion)
  {
    ValueRule rule;
    rule.kind  = ValueRule::Kind::quantity;
    rule.unit  = "m";
    rule.range = Range::positive();
    EXPECT_EQ(rule.problem("2 mm"), "");
    EXPECT_EQ(rule.problem("-3 mm"), "\"-3 mm\" (-0.003 m) is out of range");
    EXPECT_EQ(rule.problem("3 kg"), "unit word \"kg\" does not fit");
    EXPECT_EQ(rule.problem("thin"), "\"thin\" is not a number");
    EXPECT_EQ(rule.allowed(), "a number > 0 in m");
    rule.kind           = ValueRule::Kind::quantity_list;
    rule.words          = {"auto"};
    rule.minimum_length = 2;
    rule.maximum_length = 3;
    EXPECT_EQ(rule.allowed(), "auto, or 2 or 3 numbers > 0 in m");
    rule.maximum_length = 4;
    rule.words.clear();
    EXPECT_EQ(rule.allowed(), "2 to 4 numbers > 0 in m");
    rule.kind = ValueRule::Kind::quantity;
    EXPECT_EQ(rule.allowed_with_units(),
              "a number > 0 in m; unit words allowed: m, mm, cm, um, km, in, "
              "ft");
  }
} // namespace
