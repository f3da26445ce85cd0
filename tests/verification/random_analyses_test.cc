#include <auxfem/output/recorder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/simulation.h>

#include <deal.II/base/mpi.h>

#include <support/followed_path.h>
#include <support/run_program.h>

#include <algorithm>
#include <cmath>

#include "random_structure.h"

using namespace auxfem;
using namespace auxfem::testing_support;

// Small random structures in the analyses that have no course in time, with
// properties that need no reference: values agree with those of a finer mesh as
// the reported error says, and the analyses agree with each other.

namespace
{
  constexpr unsigned int n_structures = 40, n_structures_on_ranks = 10;

  /** A scene with a load on its tip, which grows in proportion to time and
   * reaches its value at the end, 1 s. */
  class AnalysisScene : RandomStructure
  {
  public:
    explicit AnalysisScene(const unsigned int seed) : RandomStructure(seed)
    {
      add_frame();
      add_section();
      add_supports();
      const double part = number(0, 1);
      if (part < 0.3)
        add_joint();
      else if (part < 0.55)
        add_rigid_part(/*is_held=*/true);
      if (chance(0.5))
        add_connector({"spring", "kelvin-voigt"}, period);
      if (chance(0.3))
        add_mass();
      for (unsigned int c = 0; c < dimension; ++c)
        force.push_back(number(-0.5, 0.5) * force_scale);
      // With `auto` it depends on the mesh whether shear is left out.
      scene_text.set("Effects/Shear flexibility", "on");
      scene_text.time(1, 1).probe("tip", tip());
    }

    /** The scene under @p part of its load. */
    SceneText loaded(const double part = 1) const
    {
      return with_load(part, " * t");
    }

    /** The scene under a constant load. */
    SceneText with_constant_load(const double part) const
    {
      return with_load(part, "");
    }

    /** @p text on a mesh whose errors are negligible. */
    SceneText refined(SceneText text) const
    {
      return text.mesh(dimension == 2 ? 6 : 4, 3);
    }

    /** For messages. */
    const std::string &description() const
    {
      return features;
    }

  private:
    void add_supports()
    {
      scene_text.support("foot", "0", "clamp");
      if (points.size() == 2 || chance(0.7))
        return;
      scene_text.support("side", tip(), "roller x");
      note("roller");
    }

    std::string tip() const
    {
      return std::to_string(points.size() - 1);
    }

    SceneText with_load(const double part, const std::string &course) const
    {
      SceneText result = scene_text;
      result.set("Loads/push/Joints", tip());
      for (unsigned int c = 0; c < dimension; ++c)
        result.set(std::string("Loads/push/Force ") + "xyz"[c],
                   text(part * force[c]) + course);
      return result;
    }

    std::vector<double> force; ///< on the tip at the end (N)
  };

  /** Discards what is written to the screen while the object lives. */
  class MutedScreen
  {
  public:
    MutedScreen() : former(std::cout.rdbuf(discarded.rdbuf()))
    {}
    ~MutedScreen()
    {
      std::cout.rdbuf(former);
    }
    MutedScreen(const MutedScreen &)            = delete;
    MutedScreen &operator=(const MutedScreen &) = delete;

  private:
    std::ostringstream    discarded;
    std::streambuf *const former;
  };

  /** A folder for results that no other process writes to. */
  std::string folder_of(const MPI_Comm communicator)
  {
    using namespace dealii::Utilities::MPI;
    std::string name = std::string(AUXFEM_TEST_OUTPUT_DIRECTORY) +
      "/random_analyses_" + std::to_string(n_mpi_processes(MPI_COMM_WORLD));
    if (n_mpi_processes(communicator) < n_mpi_processes(MPI_COMM_WORLD))
      name += "_" + std::to_string(this_mpi_process(MPI_COMM_WORLD));
    return name;
  }

  /** The message of the error that @p compute throws, empty without one. */
  template <class Compute>
  std::string error_message_of(const Compute &compute)
  {
    try
      {
        compute();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    catch (const ComputationError &error)
      {
        return error.what();
      }
    return "";
  }

  /** The table that an analysis writes, or why there is none. */
  struct Tabulated
  {
    Tabulated(const SceneText   &text,
              const std::string &table_name,
              const MPI_Comm     communicator = MPI_COMM_SELF)
    {
      failure = error_message_of([&]() {
        const std::string folder = folder_of(communicator);
        const Scene       scene  = read_scene_from_text(text,
                                                 "random.prm",
                                                 {"Output/Directory=" + folder,
                                                         "Output/Graphics=false"});
        const MutedScreen muted;
        result = run(scene, communicator, FolderOptions());
        MPI_Barrier(communicator);
        table.emplace(folder + "/" + table_name);
      });
    }

    bool is_usable() const
    {
      return verdict_of(result.findings) != Verdict::not_to_be_used;
    }

    bool is_sound() const
    {
      return verdict_of(result.findings) == Verdict::sound;
    }

    std::optional<Table> table;
    RunResult            result;
    std::string          failure;
  };

  Tabulated modes_of(SceneText      text,
                     const MPI_Comm communicator = MPI_COMM_SELF)
  {
    return {text.set("Analysis", "modes").set("Time/Scheme", "newmark"),
            "modes.csv",
            communicator};
  }

  Tabulated buckling_of(SceneText text)
  {
    return {text.set("Analysis", "buckling")
              .set("Time/Scheme", "static")
              .set("Modes/Number", 3),
            "buckling.csv"};
  }

  /** The displacement of the tip at the end of a static run without rates;
   * empty if there is no result. */
  std::vector<double> static_tip(SceneText text)
  {
    std::vector<double> displacement;
    error_message_of([&]() {
      const Scene scene =
        read_scene_from_text(text.set("Time/Scheme", "static")
                               .set("Effects/Connector viscosity", "off")
                               .set("Effects/Strut damping", "off"),
                             "random.prm");
      MemoryRecorder recorder(scene, MPI_COMM_SELF);
      run(scene, MPI_COMM_SELF, recorder);
      for (unsigned int c = 0; c < scene.context.dimension; ++c)
        displacement.push_back(
          recorder.column(std::string("tip.u") + "xyz"[c]).back());
    });
    return displacement;
  }

  double norm(const std::vector<double> &vector)
  {
    double sum = 0;
    for (const double entry : vector)
      sum += entry * entry;
    return std::sqrt(sum);
  }

  /**
   * Expects ascending values that differ from those of a finer mesh by no more
   * than the errors that both report allow. A run without errors must not call
   * itself sound.
   * @param column of both tables
   */
  void expect_reported_errors(const Tabulated   &found,
                              const Tabulated   &refined,
                              const std::string &column)
  {
    ASSERT_TRUE(refined.table) << refined.failure;
    const Table &coarse = *found.table, &fine = *refined.table;
    // Estimates know errors to a factor.
    constexpr double factor = 3, round_off = 1e-6;
    ASSERT_EQ(coarse.n_rows, fine.n_rows);
    const std::vector<double> &values = coarse[column], &exact = fine[column];
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    for (unsigned int i = 0; i < coarse.n_rows; ++i)
      {
        const double error = coarse["mesh_error"][i] + fine["mesh_error"][i];
        if (!std::isfinite(error))
          {
            EXPECT_FALSE(found.is_sound() && refined.is_sound());
            continue;
          }
        EXPECT_NEAR(values[i],
                    exact[i],
                    (factor * error + round_off) * std::abs(exact[i]))
          << "mode " << i + 1 << ", reported error " << error;
      }
  }
} // namespace

/** One structure; the parameter is its seed. */
class RandomAnalyses : public testing::TestWithParam<unsigned int>
{
protected:
  RandomAnalyses() : scene(GetParam())
  {}

  /** Random scenes show something only if most of them can be computed. */
  static void TearDownTestSuite()
  {
    if (n_run < n_structures)
      return;
    EXPECT_GE(n_complete, n_run * 4 / 5);
  }

  /** Counts an analysis; returns whether it has a result. */
  static bool is_complete(const std::string &failure)
  {
    expect_message(failure);
    ++n_run;
    n_complete += failure.empty();
    return failure.empty();
  }

  void expect_modes(SceneText text, const unsigned int number) const
  {
    text.set("Modes/Number", number);
    const Tabulated found = modes_of(text);
    if (!is_complete(found.failure))
      return;
    EXPECT_EQ(found.table->n_rows, number);
    EXPECT_TRUE(found.is_usable());
    expect_reported_errors(found, modes_of(scene.refined(text)), "frequency");
  }

  const AnalysisScene scene;
  static unsigned int n_run, n_complete;
};

unsigned int RandomAnalyses::n_run      = 0;
unsigned int RandomAnalyses::n_complete = 0;

TEST_P(RandomAnalyses, ModesAtRestAreThoseOfAFinerMesh)
{
  SCOPED_TRACE(scene.description());
  expect_modes(scene.loaded(), 2 + GetParam() % 7);
}

TEST_P(RandomAnalyses, ModesUnderALoadAreThoseOfAFinerMesh)
{
  SCOPED_TRACE(scene.description());
  expect_modes(scene.with_constant_load(0.02).set("Modes/About",
                                                  "static equilibrium"),
               4);
}

TEST_P(RandomAnalyses, SlowVibrationsAreStatic)
{
  SCOPED_TRACE(scene.description());
  constexpr double part_of_first_frequency = 1e-3, tolerance = 1e-3;
  const Tabulated  modes = modes_of(scene.loaded().set("Modes/Number", 1));
  if (!modes.table)
    return;
  const double frequency =
    part_of_first_frequency * (*modes.table)["frequency"][0];
  const bool is_held = frequency > 0;
  if (!is_held)
    return;
  const Tabulated found(scene.loaded()
                          .set("Analysis", "frequency response")
                          .set("Time/Scheme", "newmark")
                          .set("Frequency response/Lowest frequency", frequency)
                          .set("Frequency response/Highest frequency",
                               2 * frequency)
                          .set("Frequency response/Number", 2),
                        "frequency_response.csv");
  if (!is_complete(found.failure))
    return;
  const std::vector<double> displacement =
    static_tip(scene.loaded().set("Effects/Large rotation", "off"));
  ASSERT_FALSE(displacement.empty());
  for (unsigned int c = 0; c < displacement.size(); ++c)
    EXPECT_NEAR(
      (*found.table)[std::string("tip.u") + "xyz"[c] + ".amplitude"][0],
      std::abs(displacement[c]),
      tolerance * norm(displacement));
}

TEST_P(RandomAnalyses, BucklingFactorsAreInverseToTheLoad)
{
  SCOPED_TRACE(scene.description());
  constexpr double round_off = 1e-6;
  const Tabulated  found     = buckling_of(scene.loaded());
  if (!is_complete(found.failure))
    return;
  expect_reported_errors(found,
                         buckling_of(scene.refined(scene.loaded())),
                         "factor");
  const Tabulated twice = buckling_of(scene.loaded(2));
  ASSERT_TRUE(twice.table) << twice.failure;
  for (unsigned int i = 0; i < found.table->n_rows; ++i)
    EXPECT_NEAR(2 * (*twice.table)["factor"][i] / (*found.table)["factor"][i],
                1,
                round_off);
}

TEST_P(RandomAnalyses, StaticPathsPassThroughStaticEquilibria)
{
  SCOPED_TRACE(scene.description());
  constexpr double tolerance = 1e-6;
  const SceneText  text      = scene.loaded(0.05)
                           .mesh(3, 1)
                           .set("Effects/Large rotation", "on")
                           .set("Time/Scheme", "static");
  std::optional<FollowedPath> path;
  if (!is_complete(error_message_of([&]() { path.emplace(text.str()); })))
    return;
  EXPECT_NEAR(path->points.back().load_factor, 1, 1e-9);
  const std::vector<double> displacement = static_tip(text);
  ASSERT_FALSE(displacement.empty());
  for (unsigned int c = 0; c < displacement.size(); ++c)
    EXPECT_NEAR(path->points.back().motions.back()[c],
                displacement[c],
                tolerance * norm(displacement));
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         RandomAnalyses,
                         testing::Range(1u, n_structures + 1));

TEST(RandomAnalysesOnRanks, ModesAreThoseOfOneRank)
{
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    GTEST_SKIP() << "says something on several ranks only";
  for (unsigned int seed = 1; seed <= n_structures_on_ranks; ++seed)
    {
      const AnalysisScene scene(seed);
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " + scene.description());
      const SceneText text     = scene.loaded().set("Modes/Number", 4);
      const Tabulated alone    = modes_of(text),
                      together = modes_of(text, MPI_COMM_WORLD);
      ASSERT_EQ(alone.failure, together.failure);
      if (!alone.table)
        continue;
      ASSERT_EQ(alone.table->n_rows, together.table->n_rows);
      for (unsigned int i = 0; i < alone.table->n_rows; ++i)
        EXPECT_NEAR((*together.table)["frequency"][i],
                    (*alone.table)["frequency"][i],
                    1e-6 * (*alone.table)["frequency"].back());
    }
}
