#include <auxfem/contact/effects/contact.h>
#include <auxfem/output/recorder.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/simulation.h>
#include <auxfem/struts/effects/struts.h>

#include <deal.II/base/mpi.h>

#include <analysis/simulation/resumed_run.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_scene.h"
#include "random_structure.h"

using namespace auxfem;
using namespace auxfem::testing_support;

// Small scenes that combine features at random have properties that need no
// reference: forces and energies balance, no axis is inside a body, a resumed
// run and one on two ranks give the same, and a finer one gives about the same
// as a run that calls itself sound.

namespace
{
  constexpr unsigned int n_scenes = 200, n_scenes_on_ranks = 100;

  /** Errors from which on the watches call a run "not to be used". */
  constexpr double largest_error_of_sound_runs = 0.25;

  /** Keeps the history, and measures how near axes come to rigid bodies. */
  class ClearanceRecorder : public MemoryRecorder
  {
  public:
    ClearanceRecorder(const Scene &scene, const MPI_Comm communicator)
      : MemoryRecorder(scene, communicator)
      , scene(scene)
    {}

    void begin(const Equations &equations) override
    {
      MemoryRecorder::begin(equations);
      this->equations = &equations;
    }

    void step(const Solution &solution, const StepReport &report) override
    {
      MemoryRecorder::step(solution, report);
      const ReportingEffects &reporting = equations->reporting();
      if (reporting.plates == nullptr)
        return;
      const std::vector<PlateReport> plates =
        reporting.plates->reports(equations->plate_results(solution.results),
                                  solution.state);
      constexpr unsigned int n_points = 100;
      for (const StrutGroup &group : reporting.struts)
        for (unsigned int e = group.forces->elements().begin;
             e < group.forces->elements().end;
             ++e)
          for (const dealii::Point<3> &point :
               group.forces->axis(solution.state.displacement, e, n_points))
            for (std::size_t p = 0; p < plates.size(); ++p)
              clearance = std::min(clearance,
                                   scene.plates[p].surface->distance(
                                     point - scene.plates[p].position -
                                     plates[p].displacement));
    }

    /** Least distance of an axis from a body after a step (m), negative within
     * one. */
    double clearance = std::numeric_limits<double>::infinity();

  private:
    const Scene     &scene;
    const Equations *equations = nullptr;
  };

  /** A run of a scene and what it recorded, or why there is none. */
  struct Computed
  {
    explicit Computed(const std::string              &text,
                      const std::vector<std::string> &overrides = {},
                      const MPI_Comm communicator               = MPI_COMM_SELF)
    {
      try
        {
          scene.emplace(read_scene_from_text(text, "random.prm", overrides));
          recorder.emplace(*scene, communicator);
          result = run(*scene, communicator, *recorder);
        }
      catch (const InputError &error)
        {
          refusal = error.what();
        }
      catch (const ComputationError &error)
        {
          failure = error.what();
        }
    }

    bool is_complete() const
    {
      return refusal.empty() && failure.empty();
    }

    bool has(const std::string &column) const
    {
      const auto &columns = recorder->columns();
      return std::any_of(columns.begin(),
                         columns.end(),
                         [&](const Column &candidate) {
                           return candidate.name == column;
                         });
    }

    /** The last value of a column, 0 if there is none of this name. */
    double last(const std::string &column) const
    {
      return has(column) ? recorder->column(column).back() : 0.;
    }

    double largest(const std::string &column) const
    {
      double result = 0;
      for (const double value : recorder->column(column))
        result = std::max(result, std::abs(value));
      return result;
    }

    std::optional<Scene>             scene;
    std::optional<ClearanceRecorder> recorder;
    RunResult                        result;
    std::string                      refusal, failure;
  };

  void expect_equilibrium(const RandomScene &random, const Computed &computed)
  {
    const double scale =
      random.final_load->norm() + std::abs(computed.last("foot.ry"));
    for (unsigned int c = 0; c < computed.scene->context.dimension; ++c)
      {
        const std::string axis(1, "xyz"[c]);
        EXPECT_NEAR(computed.last("foot.r" + axis) +
                      computed.last("side.r" + axis) -
                      computed.last("body.f" + axis),
                    -(*random.final_load)[c],
                    1e-6 * scale)
          << "along " << axis;
      }
  }

  /** Root mean square of the difference of the tip's motion in two runs, over
   * the largest motion. */
  double difference(const Computed &coarse, const Computed &fine)
  {
    double            sum = 0, largest = 0;
    const std::size_t n     = coarse.recorder->rows().size(),
                      every = fine.recorder->rows().size() > n ? 2 : 1;
    for (const std::string axis : {"x", "y", "z"})
      {
        const std::string column = "tip.u" + axis;
        if (!coarse.has(column))
          continue;
        const std::vector<double> a = coarse.recorder->column(column),
                                  b = fine.recorder->column(column);
        for (std::size_t i = 0; i < n && every * i < b.size(); ++i)
          sum += std::pow(a[i] - b[every * i], 2);
        largest = std::max({largest, coarse.largest(column)});
      }
    return largest > 0 ? std::sqrt(sum / n) / largest : 0.;
  }

  std::vector<std::string> refined(const Scene &scene)
  {
    return {"Time/Time step=" + text(scene.time.step / 2),
            "Discretization/Global refinements=" +
              text(scene.discretization.refinements + 1)};
  }
} // namespace

/** One scene; the parameter is its seed. */
class RandomScenes : public testing::TestWithParam<unsigned int>
{
protected:
  /** Random scenes show something only if most of them can be computed. */
  static void TearDownTestSuite()
  {
    if (n_run < n_scenes)
      return;
    EXPECT_GE(n_complete, n_run * 4 / 5);
    EXPECT_GE(n_sound, n_run / 2);
    EXPECT_GE(n_touched, n_run / 4);
  }

  static unsigned int n_run, n_complete, n_sound, n_touched;
};

unsigned int RandomScenes::n_run      = 0;
unsigned int RandomScenes::n_complete = 0;
unsigned int RandomScenes::n_sound    = 0;
unsigned int RandomScenes::n_touched  = 0;

TEST_P(RandomScenes, KeepWhatNeedsNoReference)
{
  const RandomScene random = random_scene(GetParam());
  SCOPED_TRACE(random.features);
  const Computed computed(random.text);
  expect_message(computed.refusal + computed.failure);
  ++n_run;
  if (!computed.is_complete())
    return;
  ++n_complete;
  n_touched += computed.has("body.penetration") &&
    computed.largest("body.penetration") > 0;
  EXPECT_GT(computed.recorder->clearance, 0);
  if (random.is_static && random.final_load)
    expect_equilibrium(random, computed);
  if (GetParam() % 4 == 0)
    expect_same_when_resumed(random.text);
  if (verdict_of(computed.result.findings) != Verdict::sound)
    return;
  ++n_sound;
  const Computed fine(random.text, refined(*computed.scene));
  if (fine.is_complete())
    {
      EXPECT_LT(difference(computed, fine), largest_error_of_sound_runs);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomScenes, testing::Range(1u, n_scenes + 1));

TEST(RandomScenesOnRanks, AreThoseOfOneRank)
{
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    GTEST_SKIP() << "says something on several ranks only";
  for (unsigned int seed = 1; seed <= n_scenes_on_ranks; ++seed)
    {
      const RandomScene random = random_scene(seed);
      SCOPED_TRACE("seed " + std::to_string(seed) + ": " + random.features);
      const Computed alone(random.text),
        together(random.text, {}, MPI_COMM_WORLD);
      EXPECT_EQ(alone.refusal, together.refusal);
      EXPECT_EQ(alone.is_complete(), together.is_complete());
      if (!alone.is_complete() || !together.is_complete())
        continue;
      // Round-off grows with each impact. It may also decide which step is
      // halved, on which plastic strains depend.
      const bool has_impacts = !random.is_static && alone.has("body.ux"),
                 yields = random.features.find("yielding") != std::string::npos;
      const double tolerance = has_impacts ? 1e-3 : yields ? 1e-4 : 1e-6;
      for (const std::string axis : {"x", "y"})
        EXPECT_NEAR(alone.last("tip.u" + axis),
                    together.last("tip.u" + axis),
                    tolerance * alone.largest("tip.u" + axis));
    }
}
