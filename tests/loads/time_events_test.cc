#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/errors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <support/messages.h>
#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  constexpr auto kink = TimeEvent::Kind::kink;
  constexpr auto jump = TimeEvent::Kind::jump;
  TimeFunction   function_of(const std::string &text)
  {
    SceneContext context;
    context.path      = "Loads/top";
    context.constants = {{"F0", 2.5}, {"t0", 0.01}, {"T", 0.003}};
    return TimeFunction(text, "Force y", context);
  }

  void expect_events(const std::string            &text,
                     const std::vector<TimeEvent> &expected,
                     const double                  begin = 0,
                     const double                  end   = 1)
  {
    SCOPED_TRACE(text);
    const std::vector<TimeEvent> events = function_of(text).events(begin, end);
    ASSERT_EQ(events.size(), expected.size());
    for (std::size_t i = 0; i < events.size(); ++i)
      {
        EXPECT_NEAR(events[i].time,
                    expected[i].time,
                    time_resolution(expected[i].time));
        EXPECT_EQ(events[i].kind, expected[i].kind);
      }
  }

  void expect_none(const std::string &text,
                   const double       begin = 0,
                   const double       end   = 1)
  {
    expect_events(text, {}, begin, end);
  }

  /** Multiples of @p period between 0 and 1, from @p first on. */
  std::vector<TimeEvent>
  periodic(const double first, const double period, const TimeEvent::Kind kind)
  {
    std::vector<TimeEvent> events;
    for (unsigned int i = 0; first + i * period < 1; ++i)
      events.push_back({first + i * period, kind});
    return events;
  }
} // namespace

TEST(TimeEvents, SmoothFunctionsHaveNone)
{
  for (const std::string text : {"sin(1000*t)",
                                 "exp(t)",
                                 "t^2",
                                 "t^3*cos(7*t)",
                                 "sqrt(t+1)",
                                 "t^2.5",
                                 "1/(1+t)",
                                 "tanh(t)*log(1+t)",
                                 "3",
                                 "0",
                                 "F0*t/t0"})
    expect_none(text);
  EXPECT_TRUE(TimeFunction().events(0, 1).empty());
}

TEST(TimeEvents, Ramps)
{
  expect_events("min(t/t0, 1)", {{0.01, kink}});
  expect_events("-F0*min(t/t0, 1)", {{0.01, kink}});
  expect_events("max(0, t-0.1)", {{0.1, kink}});
  expect_events("abs(t-1/3)", {{1. / 3, kink}});
  expect_events("F0*min(max(t-t0, 0)/T, 1)", {{0.01, kink}, {0.013, kink}});
  expect_events("max(t, 0.5, 1-t)", {{0.5, kink}});
  // For some neighbouring times the operands are equal up to round-off.
  expect_events("abs(t/64 + 10 - 10.0078125)", {{0.5, kink}});
}

TEST(TimeEvents, Steps)
{
  for (const std::string text : {"if(t<0.01, 0, 1)",
                                 "t<0.01 ? 0 : 1",
                                 "t<=0.01 ? 0 : 1",
                                 "t>0.01",
                                 "t>=t0",
                                 "1-(t<t0)",
                                 "sign(t-0.01)",
                                 "if(t-0.01 < 0, 3*t, 4*t)"})
    expect_events(text, {{0.01, jump}});
  expect_events("floor(10*t)", periodic(0.1, 0.1, jump));
  expect_events("ceil(10*t)", periodic(0.1, 0.1, jump));
  expect_events("rint(10*t)", periodic(0.05, 0.1, jump));
  expect_events("rint(t/64 - 2.5078125)", {{0.5, jump}});
  expect_events("t - floor(4*t)/4", periodic(0.25, 0.25, jump));
}

TEST(TimeEvents, Pulses)
{
  expect_events("(t>0.01)*(t<0.0101)", {{0.01, jump}, {0.0101, jump}});
  expect_events("if(t > 0.01 && t < 0.01+1e-9, F0, 0)",
                {{0.01, jump}, {0.01 + 1e-9, jump}});
  expect_events("(t<0.1 || t>0.2 ? 0 : 1)", {{0.1, jump}, {0.2, jump}});
  expect_events("if(t<T, sin(pi*t/T), 0)", {{0.003, kink}});
  expect_events("max(0, 1-abs(t-0.01)/0.001)",
                {{0.009, kink}, {0.01, kink}, {0.011, kink}});
  // In a run that is a million times as long.
  expect_events("1e7*max(0, 1-abs(t-0.3)/1e-6)",
                {{0.3 - 1e-6, kink}, {0.3, kink}, {0.3 + 1e-6, kink}});
  expect_events("if(t>0.3 && t<0.3+1e-6, sin(pi*(t-0.3)/1e-6), 0)",
                {{0.3, kink}, {0.3 + 1e-6, kink}});
}

TEST(TimeEvents, Periodic)
{
  expect_events("abs(sin(100*t))", periodic(pi / 100, pi / 100, kink));
  expect_events("max(0, sin(20*t))", periodic(pi / 20, pi / 20, kink));
  expect_events("atan(tan(10*t))", periodic(pi / 20, pi / 10, jump));
  expect_events("atan2(sin(10*t), cos(10*t))", periodic(pi / 10, pi / 5, jump));
}

TEST(TimeEvents, Thousands)
{
  expect_events("floor(1e4*t + 0.5)", periodic(0.5e-4, 1e-4, jump));
  EXPECT_EQ(function_of("abs(sin(1e4*t))").events(0, 1).size(), 3183u);
  EXPECT_EQ(function_of("sin(1000*t) > 0.9").events(0, 1).size(), 318u);
}

TEST(TimeEvents, MoreJumpsThanStepsCanEndAtAreRefused)
{
  EXPECT_EQ(function_of("rint(1e4 * t)").events(0, 0.5).size(), 5000u);
  for (const std::string text : {"rint(1e8 * t)",
                                 "floor(1e7 * t^2)",
                                 "rint(1e6 * sin(1e3 * t))",
                                 "if(sin(1e6 * t) > 0, 1, -1)"})
    {
      SCOPED_TRACE(text);
      const std::string message =
        input_error_of([&] { function_of(text).events(0, 0.5); });
      EXPECT_NE(message.find("'" + text + "' jumps about"), std::string::npos)
        << message;
      EXPECT_NE(message.find("a step must end at each"), std::string::npos);
    }
}

TEST(TimeEvents, Nested)
{
  expect_events("abs(max(0, t-0.1) - 0.2)", {{0.1, kink}, {0.3, kink}});
  expect_events("if(max(t, 0.2) > 0.4, floor(4*t), min(t, 0.3))",
                {{0.3, kink}, {0.4, jump}, {0.5, jump}, {0.75, jump}});
  expect_events("t<0.1 ? 0 : t<0.2 ? 1 : t<0.3 ? 2 : t",
                {{0.1, jump}, {0.2, jump}, {0.3, jump}});
  expect_events("max(t<0.5 ? t : t-1, 0.25)", {{0.25, kink}, {0.5, jump}});
}

TEST(TimeEvents, SmoothJoinsAreNone)
{
  for (const std::string text : {"max(t, t)",
                                 "max(sin(t), sin(t))",
                                 "max(t^2, t*t)",
                                 "if(t<T, 1-cos(2*pi*t/T), 0)",
                                 "if(t<1/3, t, 3*t^2/2 + 1/6)",
                                 "max(0, t-0.1)^3",
                                 "max(0, t-0.1)^1.5",
                                 "abs(t-0.2)*(t-0.2)",
                                 "min(t, 2)",
                                 "0*floor(10*t)",
                                 "t == 0.5"})
    expect_none(text);
}

TEST(TimeEvents, SingularSlopes)
{
  expect_events("sqrt(max(0, t-0.1))", {{0.1, kink}});
  expect_events("max(0, t-1/3)^0.5", {{1. / 3, kink}});
  expect_events("if(t<0.25, sqrt(0.25-t), 5)", {{0.25, jump}});
  // The root of a function that is zero throughout has no infinite slope.
  expect_events("min(sin(12*t), sqrt(floor(t)))",
                {{pi / 12, kink}, {pi / 6, kink}, {pi / 4, kink}});
  expect_events("1/(t-0.5)", {{0.5, jump}});
  expect_events("atan(1/(t-1/3))", {{1. / 3, jump}});
}

TEST(TimeEvents, EndsAreExcluded)
{
  for (const std::string text : {"max(0, t-0.1)", "t<0.1", "floor(10*t)"})
    {
      expect_none(text, 0.1, 0.15);
      expect_none(text, 0.05, 0.1);
      // A time that was added up from steps.
      expect_none(text, 0.1 - 3e-17, 0.15);
      expect_none(text, 0.05, 0.1 + 3e-17);
      expect_none(text, 0.1, 0.1);
    }
  expect_events("t<0.1", {{0.1, jump}}, 0.1 - 1e-11, 0.1 + 1e-11);
  expect_events("abs(t)", {{0, kink}}, -1, 1);
}

TEST(TimeEvents, RestartAtAnEventDoesNotRepeatIt)
{
  const TimeFunction function      = function_of("abs(sin(37*t)) + floor(3*t)");
  const std::vector<TimeEvent> all = function.events(0, 2);
  ASSERT_EQ(all.size(), 23u + 5u);
  double begin = 0;
  for (const TimeEvent &event : all)
    {
      const TimeEvent next = function.events(begin, 2).at(0);
      EXPECT_DOUBLE_EQ(next.time, event.time);
      EXPECT_EQ(next.kind, event.kind);
      begin = next.time;
    }
  EXPECT_TRUE(function.events(begin, 2).empty());
}

// Neither many periods nor round-off look like kinks.
TEST(TimeEvents, FastSmoothFunctionsHaveNone)
{
  for (const std::string text : {"sin(2*pi*200*t)",
                                 "sin(1e6*t)",
                                 "exp(-((t-0.5137)/1e-5)^2)",
                                 "tanh(1e5*(t-0.3))",
                                 "1e6 + 1e-6*sin(1e3*t)"})
    expect_none(text);
}

// Times with the same branches around them count as smooth: the user gives
// such kinks in Time/Events.
TEST(TimeEvents, KinksWithoutBranchesAreMissed)
{
  for (const std::string text :
       {"sqrt((t-0.1)^2)", "asin(sin(10*t))", "sin(1e3*t) > 1 - 1e-12"})
    expect_none(text);
}

// Only the size of a function near an event decides whether it counts.
TEST(TimeEvents, SmallNextToLarge)
{
  expect_events("if(t<0.001, 1e6*t, 1e3) + 1e-3*max(0, t-0.5)",
                {{0.001, kink}, {0.5, kink}});
}

TEST(TimeLimits, AtJumpsAndKinks)
{
  const TimeFunction step = function_of("if(t<T, sin(pi*t/T)+1, 0)");
  EXPECT_DOUBLE_EQ(step.value_before(0.003), 1);
  EXPECT_EQ(step.value(0.003), 0);
  EXPECT_EQ(step.value_after(0.003), 0);

  const TimeFunction included = function_of("t<=0.01 ? 3 : 4");
  EXPECT_EQ(included.value(0.01), 3);
  EXPECT_EQ(included.value_before(0.01), 3);
  EXPECT_EQ(included.value_after(0.01), 4);

  const TimeFunction point = function_of("(t == 0.5) + sign(t-0.5)");
  EXPECT_EQ(point.value(0.5), 1);
  EXPECT_EQ(point.value_before(0.5), -1);
  EXPECT_EQ(point.value_after(0.5), 1);

  EXPECT_EQ(function_of("t>0").value_after(0), 1);
  EXPECT_EQ(function_of("t>0").value_before(0), 0);
  EXPECT_DOUBLE_EQ(function_of("atan(1/(t-0.5))").value_before(0.5), -pi / 2);
  EXPECT_DOUBLE_EQ(function_of("atan(1/(t-0.5))").value_after(0.5), pi / 2);
  EXPECT_NEAR(function_of("if(t<1/3, sqrt(1/3-t), 5)").value_before(1. / 3),
              0,
              1e-7);
}

TEST(TimeLimits, AreTheLimitsAtAllEvents)
{
  for (const std::string text : {"floor(7*t)*t",
                                 "t - floor(t/0.1)*0.1",
                                 "min(sin(50*t), cos(50*t)) > 0.5 ? t : -t",
                                 "atan(tan(10*t))",
                                 "if(t>1/3 && t<2/3, exp(t), t)"})
    {
      const TimeFunction           function = function_of(text);
      const std::vector<TimeEvent> events   = function.events(0, 1);
      EXPECT_GE(events.size(), 2u) << text;
      for (const TimeEvent &event : events)
        {
          const double t = event.time;
          EXPECT_NEAR(function.value_before(t), function.value(t - 1e-9), 1e-7);
          EXPECT_NEAR(function.value_after(t), function.value(t + 1e-9), 1e-7);
        }
    }
}

TEST(TimeLimits, AreTheValueWhereNothingJumps)
{
  for (const std::string text :
       {"sin(3*t)", "min(t/t0, 1)", "abs(sin(100*t))", "log10(1+t^2)", "F0"})
    {
      const TimeFunction function = function_of(text);
      for (const double t : {0., 0.004, 0.01, pi / 100, 0.7})
        {
          EXPECT_EQ(function.value_before(t), function.value(t)) << text;
          EXPECT_EQ(function.value_after(t), function.value(t)) << text;
        }
    }
  EXPECT_EQ(TimeFunction().value_before(1), 0);
  EXPECT_EQ(TimeFunction().value_after(1), 0);
}

TEST(TimeLimits, InfiniteLimitsEndTheRun)
{
  EXPECT_THROW(function_of("1/(t-0.5)").value_before(0.5), ComputationError);
  EXPECT_THROW(function_of("if(t>0, 1/t, 0)").value_after(0), ComputationError);
  EXPECT_EQ(function_of("if(t>0, 1/t, 0)").value_before(0), 0);
}

TEST(TimeEvents, BendsOnRequest)
{
  for (const std::string text : {"if(t < 0.2, 5*t^2, 0.2 + 2*(t - 0.2))",
                                 "1 - cos(100*max(0, t - 0.2))"})
    {
      SCOPED_TRACE(text);
      expect_none(text);
      const std::vector<TimeEvent> events = function_of(text).events(0, 1, 2);
      ASSERT_EQ(events.size(), 1u);
      EXPECT_NEAR(events[0].time, 0.2, 1e-12);
      EXPECT_EQ(events[0].kind, TimeEvent::Kind::bend);
    }
  // Kinks remain what they are; a third derivative may jump.
  EXPECT_EQ(function_of("max(0, t - 0.2)").events(0, 1, 2).at(0).kind, kink);
  EXPECT_TRUE(function_of("max(0, t - 0.2)^3").events(0, 1, 2).empty());
  EXPECT_TRUE(function_of("sin(7*t)").events(0, 1, 2).empty());
}
