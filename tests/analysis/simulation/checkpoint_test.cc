#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/recorder.h>
#include <auxfem/output/run_output.h>

#include <deal.II/base/mpi.h>

#include <analysis/simulation/expect_same.h>
#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <support/run_program.h>
#include <support/scene_text.h>

#include <array>
#include <cmath>
#include <map>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

// Interrupted runs: only a checkpoint passes from the first half to the
// second; model, equations, solvers and recorder are new.

namespace
{
  Scene scene_of(const std::string              &text,
                 const std::vector<std::string> &overrides)
  {
    return read_scene_from_text(text, "test.prm", overrides);
  }

  /** A run with its recorder, step by step. */
  template <typename RecorderType>
  struct Recorded
  {
    Recorded(const Scene &scene, std::unique_ptr<RecorderType> new_recorder)
      : run(scene, MPI_COMM_WORLD)
      , owned(std::move(new_recorder))
      , recorder(*owned)
    {
      recorder.begin(run.equations);
    }

    void start()
    {
      run.start();
      recorder.start(run.solution);
    }

    /** Returns the number of rejected steps. */
    unsigned int steps(const unsigned int n)
    {
      unsigned int retries = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          const StepReport report = run.advance(recorder);
          recorder.step(run.solution, report);
          retries += report.retries;
        }
      return retries;
    }

    void finish()
    {
      recorder.finish(run.solution,
                      {"completed", run.solution.state.time, run.work(), {}});
    }

    LatticeRun                          run;
    const std::unique_ptr<RecorderType> owned;
    RecorderType                       &recorder;
  };

  struct InMemory : Recorded<MemoryRecorder>
  {
    explicit InMemory(const Scene &scene)
      : Recorded(scene, std::make_unique<MemoryRecorder>(scene, MPI_COMM_WORLD))
    {}
  };

  struct InFolder : Recorded<Recorder>
  {
    explicit InFolder(const Scene                  &scene,
                      std::optional<CheckpointData> restart_checkpoint = {})
      : Recorded(scene,
                 make_run_output(scene,
                                 MPI_COMM_WORLD,
                                 {{}, {}, std::move(restart_checkpoint)}))
    {}
  };

  /** Values that tests check in a run. */
  struct RunValues
  {
    /** Values of columns at the checkpoint and at the end. */
    std::map<std::string, std::array<double, 2>> columns;
    /** Rejected steps before the checkpoint and after. */
    std::array<unsigned int, 2> retries;
  };

  /** Expects equality to the last digit. */
  void expect_same(const std::vector<Column>              &columns,
                   const std::vector<std::vector<double>> &rows,
                   const unsigned int                      first,
                   const std::vector<std::vector<double>> &later_rows)
  {
    ASSERT_EQ(rows.size(), first + later_rows.size());
    for (unsigned int c = 0; c < columns.size(); ++c)
      for (unsigned int i = 0; i < later_rows.size(); ++i)
        EXPECT_EQ(rows[first + i][c], later_rows[i][c])
          << columns[c].name << " at " << rows[first + i][0];
  }

  /**
   * Compares a whole run, one with a checkpoint in the middle, and the run
   * resumed from it. All values are equal to the last digit.
   */
  RunValues compare_halves(const std::string              &text,
                           const std::vector<std::string> &overrides)
  {
    const Scene        scene   = scene_of(text, overrides);
    const unsigned int n_steps = scene.time.n_steps(), n_first = n_steps / 2;

    InMemory whole(scene);
    whole.start();
    RunValues course;
    course.retries[0]               = whole.steps(n_first);
    const CheckpointData checkpoint = whole.run.checkpoint(whole.recorder);
    course.retries[1]               = whole.steps(n_steps - n_first);

    InMemory second(scene);
    second.run.resume(checkpoint, second.recorder);
    second.steps(n_steps - n_first);
    expect_same(whole.recorder.columns(),
                whole.recorder.rows(),
                n_first + 1,
                second.recorder.rows());
    expect_same_work(whole.run.work(), second.run.work());

    for (const Column &column : whole.recorder.columns())
      {
        const std::vector<double> values = whole.recorder.column(column.name);
        course.columns[column.name] = {{values.at(n_first), values.back()}};
      }
    return course;
  }
} // namespace

TEST(Checkpoint, ResumesAPlaneLatticeWithConnectors)
{
  for (const char *scheme :
       {"newmark", "generalized-alpha", "esdirk", "static"})
    {
      const RunValues course =
        compare_halves(star_with_everything(2, 2).probe("top", "top"),
                       {std::string("Time/Scheme=") + scheme,
                        "Solver/Type=klu",
                        "Output/Effective strains=true"});
      EXPECT_GT(course.columns.at("damper.dissipated")[0], 0) << scheme;
    }
}

TEST(Checkpoint, ResumesConnectorsThatRubAndBreak)
{
  for (const char *scheme : {"newmark", "energy-momentum", "static"})
    {
      const RunValues course =
        compare_halves(star_with_nonlinear_connectors(2, 2),
                       {std::string("Time/Scheme=") + scheme,
                        "Solver/Type=klu"});
      for (const char *loss : {"friction.dissipated",
                               "springs.dissipated",
                               "viscous.dissipated",
                               "fuse.broken"})
        EXPECT_GT(course.columns.at(loss)[0], 0) << scheme << loss;
    }
}

TEST(Checkpoint, FactorizationsAreThoseOfTheWholeRun)
{
  // KLU reuses pivots of another matrix, and the symmetric part of a tangent
  // may have replaced it.
  for (const std::string solver : {"auto", "klu", "mumps", "gmres"})
    for (const char *scheme : {"newmark", "energy-momentum"})
      {
        SCOPED_TRACE(solver);
        compare_halves(star_with_everything(2, 2),
                       {std::string("Time/Scheme=") + scheme,
                        "Solver/Type=" + solver});
      }
}

TEST(Checkpoint, ResumesALatticeInSpaceWithEveryEffect)
{
  for (const char *scheme : {"generalized-alpha", "esdirk", "energy-momentum"})
    compare_halves(space_star_with_everything(),
                   {std::string("Time/Scheme=") + scheme,
                    "Time/End time=0.3",
                    "Solver/Type=klu"});
}

TEST(Checkpoint, ResumesDampedIncrementsOfStrains)
{
  for (const SceneText &scene :
       {star_with_everything(2, 2), space_star_with_everything()})
    for (const char *large_rotation : {"on", "off"})
      compare_halves(scene,
                     {"Time/Scheme=energy-momentum",
                      "Time/Damping of energy-momentum=0.1",
                      std::string("Effects/Large rotation=") + large_rotation,
                      "Solver/Type=klu"});
}

namespace
{
  /** Two free struts in space that rotate by 40 rad in 2 s. */
  const SceneText spinning_struts =
    frame_scene("0 0 0; 1 0 0; 2 0.5 0", "0 1; 1 2")
      .dimension(3)
      .add("Initial velocities/spin", "Joints = all | Angular velocity z = 20")
      .time(2, 0.01, "generalized-alpha")
      .probe("end", "2");
} // namespace

TEST(Checkpoint, ContinuesToCountTurnsInSpace)
{
  const RunValues course =
    compare_halves(spinning_struts,
                   {"Sections/band/Young's modulus=1e4", "Solver/Type=klu"});
  EXPECT_GT(std::abs(course.columns.at("end.phi_z")[0]), 2 * pi);
  EXPECT_GT(std::abs(course.columns.at("end.phi_z")[1]), 4 * pi);
}

namespace
{
  /** Two bars that rotate about a pivot at 12 rad/s. */
  const SceneText rigid_bars =
    SceneText()
      .frame("0 0; 1 0; 1.5 0", "0 1; 1 2")
      .add("Rigid parts/bars",
           "Struts = all | Parts = single struts | Mass = 0.5")
      .support("pivot", "0", "pin")
      .add("Initial velocities/throw", "Joints = 1 | Velocity y = 12")
      .add("Initial velocities/throw end", "Joints = 2 | Velocity y = 18")
      .set("Gravity/Acceleration y", -1)
      .time(1, 0.01)
      .probe("bar", "rigid: 0 @ 1");

  /** A body of three joints and a free bar in space, rotating about z. */
  const SceneText rigid_body_in_space =
    SceneText()
      .dimension(3)
      .frame("0 0 0; 1 0 0; 0 1 0; 1.2 0 0", "0 1; 0 2; 1 3")
      .rigid_part("body", "0, 1", 0.5)
      .rigid_part("bar", "2", 0.5)
      .add("Initial velocities/throw", "Joints = all | Angular velocity z = 20")
      .time(1, 0.01)
      .probe("body", "rigid: 0 @ 1");
} // namespace

TEST(Checkpoint, ContinuesToCountTurnsOfRigidParts)
{
  for (const char *scheme : {"newmark", "generalized-alpha", "esdirk"})
    {
      const std::string set_scheme = std::string("Time/Scheme=") + scheme;
      const RunValues   plane =
        compare_halves(rigid_bars, {set_scheme, "Solver/Type=klu"});
      EXPECT_GT(std::abs(plane.columns.at("bar.phi")[0]), pi);
      EXPECT_GT(std::abs(plane.columns.at("bar.phi")[1]), 2 * pi);
      const RunValues space =
        compare_halves(rigid_body_in_space, {set_scheme, "Solver/Type=klu"});
      EXPECT_GT(std::abs(space.columns.at("body.phi_z")[0]), pi);
      EXPECT_GT(std::abs(space.columns.at("body.phi_z")[1]), 2 * pi);
    }
}

TEST(Checkpoint, RepeatedStepsAreThoseOfTheWholeRun)
{
  // So few iterations divide every step.
  const RunValues course =
    compare_halves(frame_scene("0 0; 1 0; 2 0", "0 1; 1 2")
                     .support("wall", "0", "clamp")
                     .add("Loads/tip", "Joints = 2 | Force y = 0.5 * t")
                     .time(1, 0.25, "static")
                     .probe("tip", "2"),
                   {"Newton/Maximum iterations=3",
                    "Newton/Factorization=every iteration",
                    "Solver/Type=klu"});
  EXPECT_GT(course.retries[0], 0u);
  EXPECT_GT(course.retries[1], 0u);
}

TEST(Checkpoint, MayCoincideWithAJump)
{
  const SceneText text =
    frame_scene("0 0; 1 0; 2 0", "0 1; 1 2")
      .support("wall", "0", "clamp")
      .add("Loads/tip", "Joints = 2 | Force y = if(t < 0.5, 0.1, -0.2)")
      .time(1, 0.05)
      .probe("tip", "2");
  for (const char *scheme : {"newmark", "generalized-alpha", "esdirk"})
    compare_halves(text,
                   {std::string("Time/Scheme=") + scheme, "Solver/Type=klu"});
}

namespace
{
  /** Rows of history.csv, line by line. */
  std::vector<std::string> rows_in(const std::string &folder)
  {
    std::istringstream       text(read_text(folder + "/history.csv"));
    std::vector<std::string> rows;
    std::string              line;
    std::getline(text, line);
    while (std::getline(text, line))
      rows.push_back(line);
    return rows;
  }

  /** Times in solution.pvd with their files. */
  std::map<std::string, std::string> frames_in(const std::string &folder)
  {
    const std::string text = read_text(folder + "/solution.pvd");
    const std::regex  entry("timestep=\"([^\"]*)\".*file=\"([^\"]*)\"");
    std::map<std::string, std::string> frames;
    for (std::sregex_iterator match(text.begin(), text.end(), entry), end;
         match != end;
         ++match)
      {
        frames[(*match)[1]] = (*match)[2];
        EXPECT_TRUE(std::filesystem::exists(folder + "/" + (*match)[2].str()));
      }
    return frames;
  }

  /** The members of summary.json from @p begin to @p end. */
  std::string part_of_summary(const std::string &folder,
                              const std::string &begin,
                              const std::string &end = "")
  {
    const std::string text = read_text(folder + "/summary.json");
    const std::size_t from = text.find('"' + begin + '"');
    EXPECT_NE(from, std::string::npos);
    return text.substr(from,
                       end.empty() ? std::string::npos
                                   : text.find('"' + end + '"') - from);
  }
} // namespace

TEST(Checkpoint, AFolderIsContinuedByRowsFilesAndLargestValues)
{
  const std::string folder = std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) +
    "/checkpoint_" +
    std::to_string(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
  // No rows or frames coincide with the checkpoint after step 5.
  const std::vector<std::string> settings = {"Output/Effective strains=true",
                                             "Output/Time between rows=0.27",
                                             "Output/Graphics interval=0.13",
                                             "Solver/Type=klu"};
  const auto                     scene_in = [&](const std::string &name) {
    std::vector<std::string> overrides = settings;
    overrides.push_back("Output/Directory=" + folder + name);
    return scene_of(star_with_everything(2, 2), overrides);
  };
  const Scene whole_scene = scene_in("_whole"),
              first_scene = scene_in("_halves");

  testing::internal::CaptureStdout();
  InFolder whole(whole_scene);
  whole.start();
  whole.steps(5);
  whole.run.checkpoint(whole.recorder);
  whole.steps(5);
  whole.finish();
  CheckpointData checkpoint;
  {
    // Output after the checkpoint is lost.
    InFolder first(first_scene);
    first.start();
    first.steps(5);
    checkpoint = first.run.checkpoint(first.recorder);
    first.steps(4);
  }
  EXPECT_EQ(rows_in(folder + "_halves").size(), 2u); // at 0 and 0.27 s
  InFolder second(first_scene, checkpoint);
  second.run.resume(checkpoint, second.recorder);
  EXPECT_EQ(second.recorder.restart_checkpoint(), nullptr);
  second.steps(5);
  second.finish();
  testing::internal::GetCapturedStdout();

  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(rows_in(folder + "_halves"), rows_in(folder + "_whole"));
  EXPECT_EQ(frames_in(folder + "_halves"), frames_in(folder + "_whole"));
  for (const auto &[begin, end] :
       {std::pair("work", "wall_seconds"), std::pair("energies_joule", "")})
    EXPECT_EQ(part_of_summary(folder + "_halves", begin, end),
              part_of_summary(folder + "_whole", begin, end));
}
