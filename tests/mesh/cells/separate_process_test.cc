#include <auxfem/mesh/cells/gmsh_reader.h>

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <iostream>

#include <sys/wait.h>
#include <unistd.h>

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
        return crash.reason;
      }
    return "";
  }
} // namespace

TEST(SeparateProcess, ReturnsTheResultOfTheAction)
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

TEST(SeparateProcess, EndsAtItsLimits)
{
  const auto end_of = [](const std::function<void()> &action,
                         const ProcessLimits         &limits) {
    try
      {
        return run_in_separate_process(
          [&]() {
            action();
            return std::string("at its end");
          },
          limits);
      }
    catch (const CrashedProcess &crash)
      {
        return crash.reason + (crash.is_out_of_time ? " (limit)" : "");
      }
  };
  ProcessLimits limits;
  limits.seconds = 0.1;
  EXPECT_EQ(end_of([]() { pause(); }, limits), "no end after 0.1 s (limit)");
  EXPECT_EQ(end_of([]() {}, limits), "at its end");
  limits         = {};
  limits.memory  = 100000000;
  const auto use = [](const std::size_t size) {
    return [size]() {
      void *const memory = std::malloc(size);
      if (memory == nullptr)
        std::abort();
      std::free(memory);
    };
  };
  EXPECT_EQ(end_of(use(50000000), limits), "at its end");
  EXPECT_NE(end_of(use(200000000), limits), "at its end");
}

TEST(SeparateProcess, EndsItsChildren)
{
  // Only a child of the process keeps this pipe open.
  for (const bool is_in_time : {true, false})
    {
      std::array<int, 2> ends;
      ASSERT_EQ(pipe(ends.data()), 0);
      ProcessLimits limits;
      limits.seconds = is_in_time ? 60 : 0.1;
      const auto run = [&]() {
        run_in_separate_process(
          [&]() {
            if (fork() == 0)
              execlp("sleep", "sleep", "1000", nullptr);
            if (!is_in_time)
              pause();
            return std::string();
          },
          limits);
      };
      if (is_in_time)
        run();
      else
        EXPECT_THROW(run(), CrashedProcess);
      close(ends[1]);
      char byte;
      EXPECT_EQ(read(ends[0], &byte, 1), 0);
      close(ends[0]);
    }
}

TEST(SeparateProcess, EndsWithItsParent)
{
  std::array<int, 2> ends;
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t parent = fork();
  if (parent == 0)
    {
      run_in_separate_process([&]() {
        if (fork() > 0 && write(ends[1], "x", 1) == 1)
          while (true)
            pause();
        while (true)
          pause();
        return std::string();
      });
      _exit(0);
    }
  close(ends[1]);
  char byte;
  ASSERT_EQ(read(ends[0], &byte, 1), 1);
  kill(parent, SIGKILL);
  EXPECT_EQ(waitpid(parent, nullptr, 0), parent);
  EXPECT_EQ(read(ends[0], &byte, 1), 0);
  close(ends[0]);
}
