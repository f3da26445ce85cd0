#include <auxfem/mesh/cells/separate_process.h>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

using namespace auxfem;

namespace
{
  std::string how_ended(const std::function<void()> &action)
  {
    try
      {
        run_in_separate_process([&]() {
          action();
          return std::string("at its end");
        });
      }
    catch (const CrashedProcess &crash)
      {
        return crash.how;
      }
    return "";
  }
} // namespace

TEST(SeparateProcess, ReturnsWhatTheActionReturns)
{
  EXPECT_EQ(run_in_separate_process([]() { return std::string(); }), "");
  const std::string large(10000000, 'x');
  EXPECT_EQ(run_in_separate_process([&]() { return large; }), large);

  int value = 1;
  run_in_separate_process([&]() {
    value = 2;
    return std::string();
  });
  EXPECT_EQ(value, 1);
}

TEST(SeparateProcess, CrashesEndItAlone)
{
  testing::internal::CaptureStderr();
  EXPECT_EQ(how_ended([]() { std::raise(SIGSEGV); }), "Segmentation fault");
  EXPECT_EQ(how_ended([]() {
              std::cerr << "out of order";
              std::abort();
            }),
            "Aborted");
  EXPECT_EQ(how_ended([]() { std::exit(0); }), "exit code 1");
  EXPECT_EQ(how_ended([]() {}), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}
