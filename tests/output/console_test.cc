#include <auxfem/output/console.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

using namespace auxfem;

namespace
{
  Progress step(const unsigned long number, const unsigned long n_steps)
  {
    Progress progress;
    progress.step              = number;
    progress.n_steps           = n_steps;
    progress.dt                = 2e-5;
    progress.time              = number * progress.dt;
    progress.end_time          = n_steps * progress.dt;
    progress.iterations        = 3;
    progress.relative_residual = 2e-11;
    progress.seconds           = 0.001 * number;
    return progress;
  }

  unsigned int count(const std::string &text, const char character)
  {
    return std::count(text.begin(), text.end(), character);
  }
} // namespace

TEST(Console, ProgressLine)
{
  Progress progress         = step(250, 1000);
  progress.seconds          = 30;
  progress.relative_balance = -3e-7;
  EXPECT_EQ(format_progress(progress),
            " 250/1000  t 0.005 s  dt 2e-05  it  3  res 2.0e-11"
            "  energy -3.0e-07  left 1:30");

  progress         = step(1000, 1000);
  progress.retries = 2;
  EXPECT_EQ(format_progress(progress),
            "1000/1000  t 0.02 s  dt 2e-05  it  3 (2 rejected)  res 2.0e-11"
            "  took 0:01");
}

TEST(Console, ResumedRunEstimatesTimeFromItsOwnSpeed)
{
  Progress progress   = step(500, 1000);
  progress.seconds    = 30;
  progress.begin_time = progress.time / 2;
  EXPECT_NE(format_progress(progress).find("left 1:00"), std::string::npos);
}

TEST(Console, ProgressLineWithoutEndTime)
{
  Progress progress = step(0, 0);
  EXPECT_EQ(progress.fraction(), 1);
  EXPECT_NE(format_progress(progress).find("0/0"), std::string::npos);
}

TEST(Console, Durations)
{
  EXPECT_EQ(format_duration(0.4), "0:00");
  EXPECT_EQ(format_duration(59.7), "1:00");
  EXPECT_EQ(format_duration(754), "12:34");
  EXPECT_EQ(format_duration(3 * 3600 + 5 * 60 + 7), "3:05:07");
  EXPECT_EQ(format_duration(-1), "0:00");
}

TEST(Console, PipeGetsFirstLastAndTwentieths)
{
  std::ostringstream screen, log;
  {
    Console console(screen, 0, log);
    for (unsigned int i = 1; i <= 1000; ++i)
      console.progress(step(i, 1000));
    console.end_progress();
  }
  // Step 1 and 20 twentieths, of which the last is the last step.
  EXPECT_EQ(count(screen.str(), '\n'), 21u);
  EXPECT_EQ(count(screen.str(), '\r'), 0u);
  EXPECT_EQ(screen.str(), log.str());
  EXPECT_EQ(screen.str().rfind("   1/1000", 0), 0u);
  EXPECT_NE(screen.str().find("1000/1000"), std::string::npos);
}

TEST(Console, RunThatStopsEarlyShowsItsLastStep)
{
  std::ostringstream screen, log;
  Console            console(screen, 0, log);
  for (unsigned int i = 1; i <= 77; ++i)
    console.progress(step(i, 1000));
  console.end_progress();
  EXPECT_NE(screen.str().find("\n  77/1000"), std::string::npos);
  EXPECT_EQ(screen.str(), log.str());

  const std::string before = screen.str();
  console.end_progress();
  EXPECT_EQ(screen.str(), before);
}

TEST(Console, TerminalRewritesOneLineTenTimesASecond)
{
  std::ostringstream screen, log;
  {
    Console console(screen, 120, log);
    for (unsigned int i = 1; i <= 1000; ++i)
      console.progress(step(i, 1000));
    console.end_progress();
    console.print("done");
  }
  // One second of wall time has the first line, one line per 0.1 s, the last.
  EXPECT_LE(count(screen.str(), '\r'), 12u);
  EXPECT_GE(count(screen.str(), '\r'), 10u);
  EXPECT_EQ(count(screen.str(), '\n'), 2u);
  EXPECT_NE(screen.str().find("\r1000/1000"), std::string::npos);
  EXPECT_NE(screen.str().find("\ndone\n"), std::string::npos);
  EXPECT_EQ(count(log.str(), '\n'), 22u);
}

TEST(Console, TerminalLineNeverWraps)
{
  std::ostringstream screen, log;
  {
    Console console(screen, 40, log);
    console.progress(step(1, 1000));
  }
  EXPECT_EQ(screen.str().size(), std::string("\r\n").size() + 39);
}

TEST(Console, ShorterLineCoversALongerOne)
{
  std::ostringstream screen, log;
  {
    Console  console(screen, 120, log);
    Progress progress = step(1, 1000);
    progress.retries  = 3;
    console.progress(progress);
    progress         = step(2, 1000);
    progress.seconds = 1;
    progress.retries = 0;
    console.progress(progress);
  }
  const std::string text   = screen.str();
  const std::size_t second = text.rfind('\r');
  EXPECT_GE(text.size() - 1 - second, second);
}

TEST(Console, LogHasEveryRepeatedStep)
{
  std::ostringstream screen, log;
  Console            console(screen, 0, log);
  for (unsigned int i = 1; i <= 40; ++i)
    {
      Progress progress = step(i, 1000);
      progress.retries  = i == 13 ? 1 : 0;
      console.progress(progress);
    }
  EXPECT_NE(log.str().find("  13/1000"), std::string::npos);
  EXPECT_EQ(screen.str().find("  13/1000"), std::string::npos);
}

TEST(Console, PrintToLogSkipsScreen)
{
  std::ostringstream screen, log;
  Console            console(screen, 0, log);
  console.print("both");
  console.print_to_log("log");
  EXPECT_EQ(screen.str(), "both\n");
  EXPECT_EQ(log.str(), "both\nlog\n");
}
