#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/parameter_values.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <support/messages.h>

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

  const Parameters all = {length,
                          angle,
                          required,
                          with_word,
                          list,
                          integer,
                          boolean,
                          choice,
                          text,
                          course};

  TEST(Parameter, DefaultsAreAllowedAndComeInSI)
  {
    for (const Parameter &parameter : all)
      EXPECT_EQ(parameter.problem(parameter.default_value), "")
        << parameter.name;
    const ParameterValues values(all);
    EXPECT_DOUBLE_EQ(values[length], 0.01);
    EXPECT_DOUBLE_EQ(values[angle], dealii::numbers::PI / 3);
    EXPECT_TRUE(values.is_word(with_word));
    EXPECT_EQ(values[list], (std::vector<double>{1e-3, 2}));
    EXPECT_EQ(values[integer], 3u);
    EXPECT_TRUE(values[boolean]);
    EXPECT_EQ(values[choice], "b");
    EXPECT_EQ(values[text], "free text");
    EXPECT_EQ(values[course], "2*t");
  }



  TEST(Parameter, WordsMayStandForWholeNumbers)
  {
    const Integer order = {"Order", 3, 1, 6, "Number or word.", {"auto"}};
    EXPECT_EQ(order.problem("auto"), "");
    EXPECT_EQ(order.problem("4"), "");
    EXPECT_NE(order.problem("automatic"), "");
    EXPECT_NE(order.allowed().find("auto"), std::string::npos);
    EXPECT_NE(order.allowed().find("a whole number >= 1 and <= 6"),
              std::string::npos);
    EXPECT_EQ(integer.allowed(), "a whole number >= 1 and <= 6");
  }



  TEST(Parameter, MissingAndMisplacedValuesAreRefused)
  {
    ParameterValues values(all);
    EXPECT_TRUE(required.required);
    EXPECT_THROW(values[required], InputError);
    EXPECT_THROW(values[with_word], InputError);
    EXPECT_DOUBLE_EQ(values.value_or(with_word, 7), 7);
    values.set("Word", " 3 ");
    EXPECT_FALSE(values.is_word(with_word));
    EXPECT_DOUBLE_EQ(values[with_word], 3);
    EXPECT_DOUBLE_EQ(values.value_or(with_word, 7), 3);
  }



  TEST(Parameter, RefusalsNamePathAndValue)
  {
    SceneContext context;
    context.path = "Sections/beam";
    ParameterValues values(all, context);
    values.set("Length", "2 mm");
    EXPECT_EQ(values.name(), "beam");
    EXPECT_EQ(input_error_of([&] { values.refuse(length, "too short"); }),
              "Sections/beam/Length = 2 mm: too short");
    EXPECT_EQ(input_error_of([&] { values.refuse("bad"); }),
              "Sections/beam: bad");
  }



  TEST(Parameter, ListsMayBeAWord)
  {
    const QuantityList axes =
      {"Axes", "auto", "m", Range::any(), 2, 3, "Numbers.", {"auto"}};
    ParameterValues values({axes});
    EXPECT_TRUE(values.is_word(axes));
    EXPECT_THROW(values[axes], InputError);
    values.set("Axes", "1 2 mm");
    EXPECT_FALSE(values.is_word(axes));
    EXPECT_EQ(values[axes], (std::vector<double>{1, 2e-3}));
    EXPECT_NE(axes.problem("automatic"), "");
  }



  TEST(Parameter, FunctionsOfTimeMayHaveAUnitWord)
  {
    ParameterValues values(all);
    values.set("Course", "10 mm");
    EXPECT_DOUBLE_EQ(std::stod(values[course]), 0.01);
    for (const char *as_written :
         {"free", "0.5", "2e7*t^3", "3 * t", "3/2", "1/t", "table: a.csv, 2"})
      {
        values.set("Course", as_written);
        EXPECT_EQ(values[course], as_written);
      }
  }



  TEST(Parameter, InvalidValuesAreProblems)
  {
    const auto refuses = [](const Parameter &parameter, const char *value) {
      EXPECT_NE(parameter.problem(value), "")
        << parameter.name << " = " << value;
    };
    refuses(length, "0");
    refuses(length, "-1 mm");
    refuses(length, "1 kg");
    refuses(length, "long");
    refuses(length, "");
    refuses(angle, "0");
    refuses(angle, "91 deg");
    refuses(angle, "2 rad");
    refuses(with_word, "automatic");
    refuses(list, "1 2 3 4");
    refuses(list, "1, -2");
    refuses(integer, "0");
    refuses(integer, "7");
    refuses(integer, "2.5");
    refuses(boolean, "maybe");
    refuses(choice, "c");
    refuses(course, "10 kg");
    EXPECT_EQ(angle.problem("90"), "");
    EXPECT_EQ(integer.problem("6"), "");
  }



  TEST(Parameter, RangesAsText)
  {
    EXPECT_EQ(Range::any().text(), "");
    EXPECT_EQ(Range::positive().text(), "> 0");
    EXPECT_EQ(Range::non_negative().text(), ">= 0");
    EXPECT_EQ(Range::closed(1, 6).text(), ">= 1 and <= 6");
    EXPECT_EQ(Range::open(-1, 0.5).text(), "> -1 and < 0.5");
  }



  TEST(Parameter, ProblemsNameValueAndConversion)
  {
    Parameter rule = {"A", "", "Something.", Parameter::Kind::quantity, "m"};
    rule.range     = Range::positive();
    EXPECT_EQ(rule.problem("2 mm"), "");
    EXPECT_EQ(rule.problem("-3 mm"), "\"-3 mm\" (-0.003 m) is out of range");
    EXPECT_EQ(rule.problem("3 kg"), "unit word \"kg\" does not fit");
    EXPECT_EQ(rule.problem("thin"), "\"thin\" is not a number");
    EXPECT_EQ(rule.allowed(), "a number > 0 in m");
    rule.kind           = Parameter::Kind::quantity_list;
    rule.words          = {"auto"};
    rule.minimum_length = 2;
    rule.maximum_length = 3;
    EXPECT_EQ(rule.allowed(), "auto, or 2 or 3 numbers > 0 in m");
    rule.maximum_length = 4;
    rule.words.clear();
    EXPECT_EQ(rule.allowed(), "2 to 4 numbers > 0 in m");
    rule.kind = Parameter::Kind::quantity;
    EXPECT_EQ(rule.allowed_with_units(),
              "a number > 0 in m; unit words allowed: m, mm, cm, um, km, in, "
              "ft");
  }



  TEST(Parameter, NumbersMayBeExpressionsOfConstants)
  {
    const std::vector<std::pair<std::string, double>> constants = {{"h", 0.002},
                                                                   {"n", 3}};
    const Quantity height("Height", "1", "mm", Range::positive(), "");
    const auto     value = [&](const std::string &text) {
      return height.value(height.with_constants(text, constants));
    };
    EXPECT_DOUBLE_EQ(value("h"), 0.002);
    EXPECT_DOUBLE_EQ(value("2*h + 0.001"), 0.005);
    // Numbers stay in the unit of the parameter or their own.
    EXPECT_DOUBLE_EQ(value("4"), 0.004);
    EXPECT_DOUBLE_EQ(value("1 cm"), 0.01);
    EXPECT_EQ(height.with_constants("thick", constants), "thick");
    EXPECT_NE(height.problem(height.with_constants("-h", constants)), "");
    EXPECT_EQ(height.with_constants("h", {}), "h");

    const QuantityList list("List", "0", "mm", Range::any(), 0, 4, "");
    EXPECT_EQ(list.value(list.with_constants("h, 1 mm, n*h", constants)),
              (std::vector<double>{0.002, 0.001, 0.006}));
    EXPECT_EQ(list.with_constants("1 2 mm", constants), "1 2 mm");
    const Integer number("Number", 1, 1, 6, "");
    EXPECT_EQ(number.value(number.with_constants("2*n", constants)), 6u);
    EXPECT_NE(number.problem(number.with_constants("n/2", constants)), "");
  }
} // namespace
