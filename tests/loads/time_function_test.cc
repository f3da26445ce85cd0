#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include <support/messages.h>
#include <unistd.h>

using namespace auxfem;

namespace
{
  SceneContext context()
  {
    SceneContext context;
    context.path      = "Loads/top";
    context.constants = {{"F0", 2.5}, {"t0", 0.01}};
    return context;
  }

  TimeFunction parse(const std::string &text)
  {
    return TimeFunction(text, "Force y", context());
  }

  /** Message of the InputError that @p text causes. */
  std::string error_of(const std::string  &text,
                       const SceneContext &scene = context())
  {
    try
      {
        TimeFunction(text, "Force y", scene);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  }

  void expect_mentions(const std::string              &message,
                       const std::vector<std::string> &parts)
  {
    for (const std::string &part : parts)
      EXPECT_NE(message.find(part), std::string::npos)
        << "'" << part << "' is not in:\n"
        << message;
  }

  /** A folder for tables, gone with the test. */
  class TableFolder : public testing::Test
  {
  protected:
    TableFolder()
      : folder(std::filesystem::temp_directory_path() /
               ("auxfem-time-function-" + std::to_string(getpid())))
    {
      std::filesystem::create_directories(folder);
      scene           = context();
      scene.directory = folder.string();
    }

    ~TableFolder() override
    {
      std::filesystem::remove_all(folder);
    }

    /** The function of a table with the text @p content. */
    TimeFunction table(const std::string &content,
                       const std::string &column = "")
    {
      write(content);
      return TimeFunction("table: force.csv" + column, "Force y", scene);
    }

    std::string table_error(const std::string &content,
                            const std::string &column = "")
    {
      write(content);
      return error_of("table: force.csv" + column, scene);
    }

    void write(const std::string &content)
    {
      std::ofstream(folder / "force.csv", std::ios::binary) << content;
    }

    const std::filesystem::path folder;
    SceneContext                scene;
  };
} // namespace

TEST(TimeExpression, Values)
{
  EXPECT_DOUBLE_EQ(parse("2e7*t^3").value(0.05), 2500);
  EXPECT_DOUBLE_EQ(parse("-F0 * min(t/t0, 1)").value(0.004), -1);
  EXPECT_DOUBLE_EQ(parse("-F0 * min(t/t0, 1)").value(1), -2.5);
  EXPECT_DOUBLE_EQ(parse("if(t < t0, 3, max(4, t))").value(0.005), 3);
  EXPECT_DOUBLE_EQ(parse("if(t < t0, 3, max(4, t))").value(5), 5);
  EXPECT_DOUBLE_EQ(parse("t < t0 ? 3 : 4").value(1), 4);
  EXPECT_DOUBLE_EQ(parse("sin(2*pi*t)").value(0.25), 1);
  EXPECT_DOUBLE_EQ(parse("-t^2").value(3), -9);
  EXPECT_DOUBLE_EQ(parse("log(exp(t))").value(3), 3);
  EXPECT_DOUBLE_EQ(parse("pow(t, 2) + floor(t) + ceil(t)").value(1.5), 5.25);
  EXPECT_DOUBLE_EQ(parse("t >= 1 && t <= 2 && t != 1.5 && t == 2").value(2), 1);
  EXPECT_DOUBLE_EQ(parse("  +1.5e-3 ").value(7), 1.5e-3);
}

TEST(TimeExpression, NotTakenBranchMayBeSingular)
{
  EXPECT_EQ(parse("if(t > 0, 1/t, 0)").value(0), 0);
}

TEST(TimeExpression, ZeroByConstruction)
{
  for (const std::string text : {"", "  ", "0", "0.0", " 0 ", "0e5", "0*F0"})
    {
      EXPECT_TRUE(parse(text).is_zero()) << text;
      EXPECT_EQ(parse(text).value(3), 0) << text;
    }
  for (const std::string text : {"1e-300", "0*t", "t-t"})
    EXPECT_FALSE(parse(text).is_zero()) << text;
  EXPECT_TRUE(TimeFunction().is_zero());
  EXPECT_EQ(TimeFunction().value(1), 0);
}

TEST(TimeExpression, CopiesOutliveTheOriginal)
{
  TimeFunction copy;
  {
    const TimeFunction original = parse("3*t");
    copy                        = original;
  }
  EXPECT_DOUBLE_EQ(copy.value(2), 6);
}

TEST(TimeExpression, MistakesAreNamed)
{
  expect_mentions(error_of("2e7*x^3"), {"Loads/top/Force y", "'2e7*x^3'", "x"});
  expect_mentions(error_of("2*t)"), {"Loads/top/Force y", "'2*t)'"});
  expect_mentions(error_of("sin(t"), {"Loads/top/Force y"});
  expect_mentions(error_of("min()"), {"Loads/top/Force y"});
  expect_mentions(error_of("foo(t)"), {"foo", "functions: ", "if", "sin"});
  expect_mentions(error_of("2*G"), {"G", "constants: ", "F0", "pi", "t0"});
  expect_mentions(error_of("0,5*t"), {"decimal point"});
  expect_mentions(error_of("if(t = 1, 2, 3)"), {"write \"==\""});
  expect_mentions(error_of("\"abc\""), {"Loads/top/Force y"});
  expect_mentions(error_of("force.csv"), {"table: force.csv"});
}

TEST(TimeExpression, NamesOfConstantsAreChecked)
{
  for (const std::string name : {"t", "2F", "F 0"})
    {
      SceneContext scene = context();
      scene.constants    = {{name, 1.}};
      expect_mentions(error_of("1+t", scene),
                      {"'" + name + "' cannot be the name"});
    }
}

TEST(TimeExpression, NotFiniteEndsTheRun)
{
  const TimeFunction function = parse("1/(t-2)");
  EXPECT_DOUBLE_EQ(function.value(3), 1);
  try
    {
      function.value(2);
      FAIL();
    }
  catch (const ComputationError &error)
    {
      expect_mentions(error.what(),
                      {"Loads/top/Force y", "1/(t-2)", "t = 2 s"});
    }
  EXPECT_THROW(parse("sqrt(t)").value(-1), ComputationError);
}

TEST(TimeJet, DerivativesAreThoseOfTheExpression)
{
  const TimeFunction polynomial = parse("1 + 2*t - 3*t^2 + 4*t^3 - 5*t^4"),
                     wave       = parse("F0*sin(3*t)");
  for (const double t : {-0.7, 0., 0.02, 1.3})
    {
      std::array<double, 3> jet = polynomial.jet(t);
      EXPECT_DOUBLE_EQ(jet[0], polynomial.value(t));
      EXPECT_NEAR(jet[1], 2 - 6 * t + 12 * t * t - 20 * t * t * t, 1e-11);
      EXPECT_NEAR(jet[2], -6 + 24 * t - 60 * t * t, 1e-10);
      jet = wave.jet(t);
      EXPECT_NEAR(jet[1], 7.5 * std::cos(3 * t), 7.5e-12);
      EXPECT_NEAR(jet[2], -22.5 * std::sin(3 * t), 22.5e-9);
    }
}

TEST(TimeJet, IsFiniteWhereADerivativePassesZero)
{
  const TimeFunction wave = parse("1e-3 * sin(12*t) * (1 - exp(-(t / 0.5)^2))");
  for (unsigned int n = 12; n < 24; ++n)
    {
      const double zero = n * std::acos(-1.) / 12;
      EXPECT_NEAR(wave.jet(zero)[2], 0, 1e-8) << n;
    }
}

TEST(TimeJet, OneSidedWhereAnOperationSwitches)
{
  const TimeFunction function = parse("if(t < 0.2, 5*t^2, 0.2 + 2*(t - 0.2))");
  EXPECT_NEAR(function.jet(0.2, TimeSide::before)[1], 2, 1e-12);
  EXPECT_NEAR(function.jet(0.2, TimeSide::before)[2], 10, 1e-10);
  EXPECT_NEAR(function.jet(0.2)[1], 2, 1e-13);
  EXPECT_EQ(function.jet(0.2)[2], 0);
  const TimeFunction late = parse("t^2*max(0, t - 0.1)");
  EXPECT_EQ(late.jet(0.1, TimeSide::before)[1], 0);
  EXPECT_NEAR(late.jet(0.1)[1], 0.01, 1e-12);
  // At the start the limit from after is used.
  EXPECT_NEAR(parse("if(t <= 0, 0, 4*t + 3*t^2)").jet(0)[1], 4, 1e-13);
}

TEST(TimeJet, ConstantsHaveNoRateAtAll)
{
  const std::array<double, 3> jet = parse("F0/3").jet(17.3);
  EXPECT_DOUBLE_EQ(jet[0], 2.5 / 3);
  EXPECT_EQ(jet[1], 0);
  EXPECT_EQ(jet[2], 0);
  EXPECT_EQ(TimeFunction().jet(1), (std::array<double, 3>{{0, 0, 0}}));
}

TEST(TimeJet, DerivativesThatAreNotFiniteEndTheRun)
{
  const TimeFunction function = parse("t^1.5");
  EXPECT_NEAR(function.jet(4)[2], 0.375, 1e-9);
  try
    {
      function.jet(0);
      FAIL();
    }
  catch (const ComputationError &error)
    {
      expect_mentions(error.what(),
                      {"Loads/top/Force y", "second derivative", "t = 0 s"});
    }
}

TEST_F(TableFolder, LinearBetweenRowsConstantOutside)
{
  const TimeFunction function = table("0 1\n0.5 2\n2 -1\n");
  EXPECT_DOUBLE_EQ(function.value(-1), 1);
  EXPECT_DOUBLE_EQ(function.value(0), 1);
  EXPECT_DOUBLE_EQ(function.value(0.25), 1.5);
  EXPECT_DOUBLE_EQ(function.value(0.5), 2);
  EXPECT_NEAR(function.value(1.5), 0, 1e-15);
  EXPECT_DOUBLE_EQ(function.value(2), -1);
  EXPECT_DOUBLE_EQ(function.value(100), -1);
  EXPECT_FALSE(function.is_zero());
}

TEST_F(TableFolder, SeparatorsHeaderCommentsAndLineEnds)
{
  for (const std::string content :
       {"0,1,7\n1,3,9\n",
        "0;1;7\n1;3;9\n",
        "0 1\t7\n 1  3 9",
        "\xEF\xBB\xBF"
        "0,1,7\r\n1,3,9\r\n",
        "time (s), force (N), other\n0, 1, 7\n1, 3, 9",
        "# measured\n\n\"t\";\"F\";\"G\" # names\n"
        "0; +1; 7 # first\n\n1; 3e0; 9.0\n"})
    {
      EXPECT_DOUBLE_EQ(table(content).value(0.5), 2) << content;
      EXPECT_DOUBLE_EQ(table(content, ", 3").value(0.5), 8) << content;
    }
}

TEST_F(TableFolder, MistakesNameFileLineAndParameter)
{
  const auto here = [](const std::string &line) {
    return std::vector<std::string>{"Loads/top/Force y", "force.csv", line};
  };
  expect_mentions(table_error("0,1\n1,2\n0.5,3\n"), here("line 3"));
  expect_mentions(table_error("0,1\n1,2\n0.5,3\n"), {"must not decrease"});
  expect_mentions(table_error("0,1\n0,2\n0,3\n"), {"line 3", "third", "jump"});
  expect_mentions(table_error("t,F\n0,1\n1,x2\n"), here("line 3"));
  expect_mentions(table_error("t,F\n0,1\n1,x2\n"), {"'x2' in column 2"});
  expect_mentions(table_error("# c\n0,1 N\n"), {"line 2", "'1 N'"});
  expect_mentions(table_error("0;0,5\n"), {"line 1", "'0,5'", "decimal point"});
  expect_mentions(table_error("0,1\n1\n"), here("line 2"));
  expect_mentions(table_error("0,1\n1\n"), {"1 column,", "column 2"});
  expect_mentions(table_error("0,1\n", ", 3"), {"2 columns", "column 3"});
  expect_mentions(table_error("0,1\n1,\n"), {"line 2"});
  expect_mentions(table_error("0,1\n1,nan\n"), {"line 2", "'nan'"});
  expect_mentions(table_error("a,b\nc,d\n0,1\n"), {"line 2", "'c'"});
  expect_mentions(table_error("t,F\n"), {"no row of numbers", "force.csv"});
  expect_mentions(table_error(""), {"no row of numbers"});
}

TEST_F(TableFolder, UnreadableFilesAndColumns)
{
  expect_mentions(error_of("table: nowhere.csv", scene),
                  {"Loads/top/Force y", "cannot read", "nowhere.csv"});
  expect_mentions(error_of("table: .", scene), {"cannot read"});
  expect_mentions(error_of("table:", scene), {"name of a file"});
  for (const std::string column : {"1", "0", "-2", "two", "2.5", ""})
    expect_mentions(table_error("0,1\n", ", " + column),
                    {"'" + column + "' is not a column"});
}

TEST_F(TableFolder, AbsoluteNames)
{
  write("0,1\n1,3\n");
  const TimeFunction function("table: " + (folder / "force.csv").string(),
                              "Force y",
                              context());
  EXPECT_DOUBLE_EQ(function.value(0.5), 2);
}

TEST_F(TableFolder, RatesAreThoseOfTheSegments)
{
  const TimeFunction function = table("0,1\n1,3\n2,3.5\n");
  for (const double t : {0., 0.4})
    EXPECT_EQ(function.jet(t)[1], 2);
  EXPECT_EQ(function.jet(0, TimeSide::before)[1], 0);
  EXPECT_EQ(function.jet(1, TimeSide::before)[1], 2);
  EXPECT_EQ(function.jet(1)[1], 0.5);
  EXPECT_EQ(function.jet(2)[1], 0);
  EXPECT_EQ(function.jet(1.5)[2], 0);
}

TEST_F(TableFolder, ASmoothTableIsACubicSpline)
{
  write("0,0\n1,1\n2,8\n3,27\n5,125\n");
  const TimeFunction smooth("smooth table: force.csv", "Force y", scene);
  EXPECT_NEAR(smooth.value(2.5), 15.625, 1e-13);
  EXPECT_NEAR(smooth.jet(2)[1], 12, 1e-13);
  EXPECT_NEAR(smooth.jet(2)[2], 12, 1e-12);
  EXPECT_EQ(smooth.value(7), 125);
  EXPECT_EQ(smooth.value(-1), 0);
  EXPECT_FALSE(smooth.overshoot());

  // It stands still outside: the slope is 0 and 75 at its ends.
  const std::vector<TimeEvent> events = smooth.events(-1, 6, 2);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].time, 5);
  EXPECT_EQ(events[0].kind, TimeEvent::Kind::kink);

  EXPECT_DOUBLE_EQ(
    TimeFunction("table: force.csv", "Force y", scene).value(2.5),
    17.5);
}

TEST_F(TableFolder, ASmoothTableSaysWhereItOvershoots)
{
  write("0,0\n1,1\n2,11\n");
  const auto overshoot =
    TimeFunction("smooth table: force.csv", "Force y", scene).overshoot();
  ASSERT_TRUE(overshoot);
  EXPECT_EQ(overshoot->begin, 0);
  EXPECT_EQ(overshoot->end, 1);
  // 4.5 t^2 - 3.5 t is least at 7/18.
  EXPECT_NEAR(overshoot->amount, 49. / 72, 1e-2);
  EXPECT_FALSE(TimeFunction("table: force.csv", "Force y", scene).overshoot());
}

TEST_F(TableFolder, ASmoothTableDoesNotJump)
{
  write("0,0\n1,1\n1,8\n3,27\n");
  const std::string message = input_error_of(
    [&] { TimeFunction("smooth table: force.csv", "Force y", scene); });
  expect_mentions(message, {"Loads/top/Force y", "t = 1 s", "table: FILE"});
}

TEST_F(TableFolder, AScaleMultipliesTheValues)
{
  write("0,0\n1,3\n2,3\n");
  SceneContext with_constants = scene;
  with_constants.constants    = {{"m", 4.}};
  const auto value            = [&](const std::string &scale) {
    return TimeFunction(scale + " table: force.csv", "Force y", with_constants)
      .value(1);
  };
  EXPECT_DOUBLE_EQ(value("-2 kg *"), -6);
  EXPECT_DOUBLE_EQ(value("2 kN*"), 6000);
  EXPECT_DOUBLE_EQ(value("0.001 *"), 0.003);
  EXPECT_DOUBLE_EQ(value("-m/2 * "), -6);
  EXPECT_DOUBLE_EQ(value("2 * m * smooth"), 24);
  for (const std::string scale :
       {"2 elephants *", "2", "t *", "*", "linear", "unsmooth"})
    {
      const std::string message = input_error_of([&] { value(scale); });
      EXPECT_NE(message.find("Loads/top/Force y"), std::string::npos)
        << message;
    }
}

TEST_F(TableFolder, TwoRowsAtOneTimeAreAJump)
{
  const TimeFunction function = table("0,0\n0,1\n1,2\n1,5\n2,5\n2,0\n");
  EXPECT_EQ(function.value(-1), 0);
  EXPECT_EQ(function.value_before(0), 0);
  EXPECT_EQ(function.value(0), 1);
  EXPECT_EQ(function.value_after(0), 1);
  EXPECT_DOUBLE_EQ(function.value(0.5), 1.5);
  EXPECT_EQ(function.value_before(1), 2);
  EXPECT_EQ(function.value(1), 5);
  EXPECT_EQ(function.value_before(2), 5);
  EXPECT_EQ(function.value(2), 0);
  EXPECT_EQ(function.value_before(0.5), function.value(0.5));

  const std::vector<TimeEvent> events = function.events(-1, 3);
  ASSERT_EQ(events.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(events[i].time, i);
      EXPECT_EQ(events[i].kind, TimeEvent::Kind::jump);
    }
  EXPECT_EQ(function.events(0, 2).size(), 1u);
}

TEST_F(TableFolder, EventsAreRowsWhereTheSlopeChanges)
{
  // The third row is on the line of its neighbours, up to round-off.
  const TimeFunction function =
    table("0,0\n0.1,0.3\n0.2,0.6\n0.3,0.9\n0.7,0\n");
  const std::vector<TimeEvent> events = function.events(-1, 1);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].time, 0);
  EXPECT_EQ(events[1].time, 0.3);
  EXPECT_EQ(events[2].time, 0.7);
  for (const TimeEvent &event : events)
    EXPECT_EQ(event.kind, TimeEvent::Kind::kink);
  EXPECT_EQ(function.events(0, 0.7).size(), 1u);
  EXPECT_TRUE(table("0,1\n1,1\n").events(-1, 2).empty());
  EXPECT_TRUE(table("0,1\n").events(-1, 2).empty());
}

// Messages show values in the unit of the text.
TEST(ScaledTimeFunction, HasValuesAndJumpsOfTheBase)
{
  const TimeFunction base   = parse("t < 0.5 ? t^2 : 3"),
                     scaled = base.scaled(4).scaled(0.5);
  EXPECT_DOUBLE_EQ(scaled.value(0.25), 2 * base.value(0.25));
  EXPECT_DOUBLE_EQ(scaled.value_before(0.5), 2 * base.value_before(0.5));
  EXPECT_DOUBLE_EQ(scaled.value_after(0.5), 6);
  EXPECT_DOUBLE_EQ(scaled.jet(0.25)[1], 2 * base.jet(0.25)[1]);
  ASSERT_EQ(scaled.events(0, 1).size(), 1u);
  EXPECT_DOUBLE_EQ(scaled.events(0, 1)[0].time, 0.5);
  EXPECT_EQ(scaled.origin(), base.origin());
  EXPECT_DOUBLE_EQ(scaled.as_written(scaled.value(1)), 3);
  EXPECT_TRUE(base.scaled(0).is_zero());
  EXPECT_TRUE(TimeFunction().scaled(2).is_zero());
}
