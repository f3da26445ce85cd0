#include <auxfem/study/measured_run.h>
#include <auxfem/study/settings.h>
#include <auxfem/study/study_runs.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>
#include <study/swinging_beam.h>
#include <support/text_file.h>

#include <filesystem>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  namespace fs  = std::filesystem;
  namespace mpi = dealii::Utilities::MPI;

  /** Every rank needs a strut. */
  SceneText beam_of_struts()
  {
    return swinging_beam(0.1, 10).frame("0 0; 0.5 0; 1 0", "0 1; 1 2");
  }

  PlannedRun planned(const std::string &name, const std::string &step)
  {
    return {name,
            read_scene_from_text(beam_of_struts(),
                                 "test.prm",
                                 {"Time/Time step=" + step}),
            1};
  }

  std::vector<PlannedRun> plan()
  {
    return {planned("coarse", "0.02"),
            planned("middle", "0.01"),
            planned("fine", "0.005")};
  }

  /** An empty folder of the test. Collective. */
  std::string fresh_folder(const std::string &name)
  {
    const std::string folder = std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) +
      "/study_runs_" + name +
      std::to_string(mpi::n_mpi_processes(MPI_COMM_WORLD));
    if (mpi::this_mpi_process(MPI_COMM_WORLD) == 0)
      fs::remove_all(folder);
    MPI_Barrier(MPI_COMM_WORLD);
    return folder;
  }

  /** Counts computed and loaded runs on the first rank. */
  struct Counts
  {
    unsigned int computed = 0, reused = 0;

    StudyRuns runs(const std::string &folder, std::set<std::string> columns)
    {
      return StudyRuns(MPI_COMM_WORLD,
                       folder,
                       {std::move(columns), {}},
                       [this](const StudyProgress &progress) {
                         if (progress.result)
                           ++(progress.is_reused ? reused : computed);
                         EXPECT_LE(progress.fraction, 1 + 1e-12);
                       });
    }
  };

  void expect_counts(const Counts      &counts,
                     const unsigned int computed,
                     const unsigned int reused)
  {
    if (mpi::this_mpi_process(MPI_COMM_WORLD) > 0)
      return;
    EXPECT_EQ(counts.computed, computed);
    EXPECT_EQ(counts.reused, reused);
  }
} // namespace

// With two ranks these three runs are computed side by side.
TEST(StudyRuns, ResultsComeInTheOrderOfThePlan)
{
  Counts     counts;
  const auto runs = counts.runs("", {"tip.uy"}).compute(plan());
  ASSERT_EQ(runs.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_TRUE(runs[i].completed());
      EXPECT_EQ(runs[i].steps, 5u << i);
      EXPECT_EQ(runs[i].columns.at("tip.uy").size(), (5u << i) + 1);
      EXPECT_EQ(runs[i].columns.at("time").front(), 0);
      EXPECT_DOUBLE_EQ(runs[i].columns.at("time").back(), 0.1);
      EXPECT_GT(runs[i].unknowns, 0u);
      EXPECT_GT(runs[i].memory, 0u);
    }
  expect_counts(counts, 3, 0);
}

TEST(StudyRuns, SingleRunIsDoneByAllRanks)
{
  Counts     counts;
  const auto runs =
    counts.runs("", {"tip.uy"}).compute({planned("only", "0.01")});
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_TRUE(runs[0].completed());
}

TEST(StudyRuns, StoredRunsAreNotRepeated)
{
  const std::string folder = fresh_folder("kept");
  Counts            first, second;
  const auto        before = first.runs(folder, {"tip.uy"}).compute(plan());
  const auto        after  = second.runs(folder, {"tip.uy"}).compute(plan());
  expect_counts(first, 3, 0);
  expect_counts(second, 0, 3);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(before[i].columns, after[i].columns);
      EXPECT_EQ(before[i].cpu_seconds, after[i].cpu_seconds);
    }
}

TEST(StudyRuns, OtherColumnsOrMoreRepetitionsAreComputedAnew)
{
  const std::string folder = fresh_folder("columns");
  Counts            first, second, third;
  first.runs(folder, {"tip.uy"}).compute(plan());
  second.runs(folder, {"tip.ux"}).compute(plan());
  expect_counts(second, 3, 0);
  std::vector<PlannedRun> repeated = plan();
  repeated[0].repetitions          = 2;
  const auto runs = third.runs(folder, {"tip.ux"}).compute(repeated);
  EXPECT_EQ(runs[0].repetitions, 2u);
  EXPECT_TRUE(runs[0].spread().has_value());
}

TEST(StudyRuns, DamagedFilesAreComputedAnew)
{
  const std::string folder = fresh_folder("damaged");
  Counts            first, second;
  first.runs(folder, {"tip.uy"}).compute(plan());
  if (mpi::this_mpi_process(MPI_COMM_WORLD) == 0)
    for (const auto &file : fs::directory_iterator(folder))
      write_text(file.path(), read_text(file.path()).substr(0, 100));
  MPI_Barrier(MPI_COMM_WORLD);
  const auto runs = second.runs(folder, {"tip.uy"}).compute(plan());
  EXPECT_TRUE(runs[2].completed());
  expect_counts(second, 3, 0);
}

TEST(StudyRuns, KeysDependOnRelevantParametersOnly)
{
  const auto key = [](const std::vector<std::string> &overrides) {
    return key_of(read_scene_from_text(beam_of_struts(), "test.prm", overrides),
                  1);
  };
  const std::string plain = key({});
  EXPECT_EQ(key({"Output/Directory=elsewhere"}), plain);
  EXPECT_EQ(key({"Study/Kind=effects"}), plain);
  EXPECT_NE(key({"Time/Time step=0.005"}), plain);
  EXPECT_NE(key({"Newton/Tolerance=1e-9"}), plain);
  EXPECT_NE(key_of(read_scene_from_text(beam_of_struts(), "test.prm"), 2),
            plain);
}

TEST(StudyRuns, KeysFollowTheContentsOfTables)
{
  const std::string folder = fresh_folder("tables") +
    std::to_string(mpi::this_mpi_process(MPI_COMM_WORLD));
  fs::create_directories(folder);
  const auto key = [&folder](const std::string &table) {
    write_text(folder + "/force.csv", table);
    return key_of(
      read_scene_from_text(beam_of_struts().set("Loads/push/Force y",
                                                "table: force.csv"),
                           folder + "/test.prm"),
      1);
  };
  EXPECT_EQ(key("0,0\n1,1\n"), key("0,0\n1,1\n"));
  EXPECT_NE(key("0,0\n1,1\n"), key("0,0\n1,2\n"));
}

TEST(Settings, OverridesContainDifferencesOnly)
{
  const Scene    scene = read_scene_from_text(beam_of_struts(), "test.prm");
  const Settings own   = settings_of(scene);
  EXPECT_TRUE(overrides(own, own).empty());
  Settings other         = own;
  other.order            = 2;
  other.time_step        = 2.5e-3;
  const auto assignments = overrides(own, other);
  EXPECT_EQ(assignments,
            (std::vector<std::string>{"Discretization/Order=2",
                                      "Time/Time step=0.0025"}));
  EXPECT_TRUE(settings_of(scene_with(scene, assignments)) == other);
  EXPECT_EQ(
    command_line_text(assignments),
    " --set \"Discretization/Order=2\" --set \"Time/Time step=0.0025\"");
}
