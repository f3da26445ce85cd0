#include <auxfem/start_up.h>

#include <mpi.h>
#include <support/run_program.h>

#include <limits>
#include <thread>

#include <stdlib.h>

namespace
{
  using namespace auxfem;
  using namespace auxfem::testing_support;

  /** An environment variable, as it was again at the end of the scope. */
  class Variable
  {
  public:
    /** @param value nullptr: not set. */
    Variable(const std::string &name, const char *value) : name(name)
    {
      if (const char *former_value = std::getenv(name.c_str()))
        former = former_value;
      set(value);
    }

    ~Variable()
    {
      set(former ? former->c_str() : nullptr);
    }

  private:
    void set(const char *value) const
    {
      if (value)
        setenv(name.c_str(), value, /*overwrite=*/1);
      else
        unsetenv(name.c_str());
    }

    std::string                name;
    std::optional<std::string> former;
  };

  TEST(StartUp, FindsTheLaunchersOfMpi)
  {
    std::vector<std::unique_ptr<Variable>> none;
    const Words                            launchers = {"OMPI_COMM_WORLD_SIZE",
                                                        "PMIX_RANK",
                                                        "PMI_RANK",
                                                        "SLURM_PROCID",
                                                        "ALPS_APP_PE"};
    for (const std::string &name : launchers)
      none.push_back(std::make_unique<Variable>(name, nullptr));
    EXPECT_FALSE(has_mpi_launcher());
    for (const std::string &name : launchers)
      {
        const Variable variable(name, "0");
        EXPECT_TRUE(has_mpi_launcher()) << name;
      }
  }

  TEST(StartUp, LeavesTheUsersChoiceOfTransport)
  {
    const Variable isolated("OMPI_MCA_ess_singleton_isolated", nullptr);
    const Variable session("OMPI_MCA_orte_create_session_dirs", nullptr);
    const Variable pml("OMPI_MCA_pml", "mine");
    const Variable btl("OMPI_MCA_btl", nullptr);
    prepare_mpi_for_one_process();
    EXPECT_STREQ(std::getenv("OMPI_MCA_ess_singleton_isolated"), "1");
    EXPECT_STREQ(std::getenv("OMPI_MCA_orte_create_session_dirs"), "0");
    EXPECT_STREQ(std::getenv("OMPI_MCA_pml"), "mine");
    EXPECT_STREQ(std::getenv("OMPI_MCA_btl"), "self,vader");
  }

  TEST(StartUp, KnowsTheAgeOfTheProcess)
  {
    const double before = seconds_since_process_start();
    EXPECT_GT(before, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const double slept = seconds_since_process_start() - before;
    EXPECT_GE(slept, 0.049);
    // A machine that pauses for ten minutes has other troubles.
    EXPECT_LT(slept, 600);
  }

  TEST(StartUp, DenormalNumbersCountAsZero)
  {
    double      halved = 1;
    std::thread calculation([&halved]() {
      flush_denormals_to_zero();
      volatile double smallest = std::numeric_limits<double>::min();
      halved                   = smallest / 2;
    });
    calculation.join();
    EXPECT_EQ(halved, 0);

    volatile double denormal = std::numeric_limits<double>::denorm_min();
    double          doubled  = 1;
    std::thread     reading([&]() {
      flush_denormals_to_zero();
      doubled = denormal * 2;
    });
    reading.join();
    EXPECT_EQ(doubled, 0);
  }

  class StartOfProgram : public ProgramTest
  {};

  TEST_F(StartOfProgram, WhatComputesNothingNeedsNoMpi)
  {
    // With a transport that does not exist MPI_Init fails.
    const Variable pml("OMPI_MCA_pml", "none_of_this_name");
    for (const char *option : {"--version", "--help", "--print-parameters"})
      {
        const ProgramRun run = start_auxfem({option});
        EXPECT_EQ(run.exit_code, 0) << option;
        EXPECT_NE(run.output, "") << option;
        EXPECT_EQ(run.errors, "") << option;
      }
    const ProgramRun mistyped = start_auxfem({"--versoin"});
    EXPECT_EQ(mistyped.exit_code, 1);
    expect_contains(mistyped.errors, {"Unknown option '--versoin'"});
  }

  TEST_F(StartOfProgram, OneProcessSharesNoTemporaryFolderWithOthers)
  {
    if (OMPI_MAJOR_VERSION >= 5)
      GTEST_SKIP() << "Open MPI 5 makes a folder for one process too.";
    // A folder that cannot be made must not be needed.
    write("a-file", "");
    const Variable   temporary("TMPDIR", path("a-file").c_str());
    const ProgramRun run =
      start_auxfem({"--check", AUXFEM_PRM_DIRECTORY "/cantilever.prm"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
  }

  TEST_F(StartOfProgram, TwoRanksAnswerOnce)
  {
    const ProgramRun run = run_auxfem_on(2, {"--version"});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(count_lines(run.output), 1u) << run.output;
  }

  TEST_F(StartOfProgram, TheSummaryTellsItApart)
  {
    write("scene.prm", data_text("star.prm"));
    const Words arguments = {"scene.prm",
                             "--set",
                             "Time/End time=20 us",
                             "--output"};
    const auto  run_into  = [&](const char *folder) {
      Words words = arguments;
      words.push_back(folder);
      return words;
    };
    ASSERT_EQ(start_auxfem(run_into("one")).exit_code, 0);
    ASSERT_EQ(run_auxfem_on(2, run_into("two")).exit_code, 0);
    EXPECT_EQ(summary("ranks", "two"), "2");
    for (const char *folder : {"one", "two"})
      {
        EXPECT_GT(std::stod(summary("program_start", folder)), 0);
        EXPECT_GT(std::stod(summary("mpi_start", folder)), 0);
        const double cpu = std::stod(summary("cpu_seconds_of_start", folder));
        EXPECT_GT(cpu, 0);
        EXPECT_GT(std::stod(summary("cpu_seconds", folder)), cpu);
      }
  }
} // namespace
