#include <auxfem/analysis/discretization/order_choice.h>
#include <auxfem/analysis/simulation/lattice_run.h>
#include <auxfem/output/recorder.h>
#include <auxfem/parameters/errors.h>

#include <analysis/simulation/resumed_run.h>
#include <gtest/gtest.h>
#include <support/scene_text.h>

#include <algorithm>
#include <cmath>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  /** A bent knee of three struts of decreasing length, the last one an arc. */
  SceneText knee()
  {
    return static_frame("0 0; 0 0.4; 0.2 0.4; 0.25 0.4", "0 1; 1 2; 2 3 0.005")
      .section({100, 50, 0.05})
      .support("foot", "0", "clamp")
      .load("tip", "3", {"0.1 * t", "-0.3 * t", "0"})
      .time(1, 0.5)
      .probe("tip", "3");
  }

  /**
   * The knee with masses at its joints after an impact: struts act as springs.
   */
  SceneText hit_knee()
  {
    return knee()
      .set("Time/Scheme", "generalized-alpha")
      .set("Sections/section 0/Density", 1e-6)
      .set("Loads/tip/Force x", "0.1 * sin(40 * t)")
      .mass("bob", "1, 3", 0.05, 1e-4)
      .time(0.1, 0.001);
  }

  SceneText space_knee()
  {
    return static_space_frame("0 0 0; 0 0.4 0; 0.2 0.4 0; 0.2 0.4 0.1",
                              "0 1; 1 2; 2 3")
      .space_section({100, 50, 50, 0.05, 0.05, 0.05})
      .support("foot", "0", "clamp")
      .load("tip", "3", {"0.05 * t", "-0.1 * t", "0.1 * t"}, {"0", "0", "0"})
      .time(1, 0.5)
      .probe("tip", "3");
  }

  /**
   * A slender strut followed by two short ones, under @p load (N/m) along the
   * first.
   */
  SceneText pushed_strut(const double load)
  {
    return static_frame("0 0; 1 0; 1.1 0; 1.2 0", "0 1; 1 2; 2 3")
      .section({1.2e5, 4e4, 1})
      .support("foot", "0", "clamp")
      .set("Loads/push/Type", "line")
      .set("Loads/push/Struts", "0")
      .set("Loads/push/Force per length y", SceneValue(load).words + " * t")
      .time(1, 0.1)
      .probe("tip", "3");
  }

  /** The first strut is bent to three quarters of a circle. */
  SceneText wound_strut()
  {
    return pushed_strut(6).load("coil", "1", {"0", "0", "5 * t"});
  }

  SceneText wound_space_strut()
  {
    return static_space_frame("0 0 0; 1 0 0; 1.1 0 0; 1.2 0 0", "0 1; 1 2; 2 3")
      .space_section({100, 50, 50, 1, 1, 1})
      .support("foot", "0", "clamp")
      .load("coil", "1", {"0", "0", "0"}, {"t", "0", "4 * t"})
      .time(1, 0.1)
      .probe("tip", "3");
  }

  Scene scene_of(const SceneText &text, const double tolerance)
  {
    return read_scene_from_text(SceneText(text)
                                  .set("Discretization/Order", "auto")
                                  .set("Discretization/Tolerance", tolerance)
                                  .str(),
                                "test.prm");
  }

  ChosenElements elements_of(const Scene &scene, const MPI_Comm communicator)
  {
    Recorder nobody;
    return choose_elements(scene, communicator, nobody);
  }

  Scene scene_of_order(const SceneText   &text,
                       const unsigned int order,
                       const unsigned int refinements = 0)
  {
    return read_scene_from_text(SceneText(text).mesh(order, refinements).str(),
                                "test.prm");
  }

  /** Displacement of the tip by component, at all times. */
  std::vector<double> tip_motion(const MemoryRecorder &recorder)
  {
    std::vector<double> values;
    for (const Column &column : recorder.columns())
      if (column.name == "tip.ux" || column.name == "tip.uy" ||
          column.name == "tip.uz")
        for (const double value : recorder.column(column.name))
          values.push_back(value);
    return values;
  }

  double relative_difference(const std::vector<double> &values,
                             const std::vector<double> &exact)
  {
    double largest = 0, difference = 0;
    for (unsigned int i = 0; i < exact.size(); ++i)
      {
        largest    = std::max(largest, std::abs(exact[i]));
        difference = std::max(difference, std::abs(values.at(i) - exact[i]));
      }
    return difference / largest;
  }

  /** Motion of the tip on converged elements. */
  std::vector<double> exact_motion(const SceneText   &text,
                                   const unsigned int order,
                                   const unsigned int refinements = 2)
  {
    const Scene    scene = scene_of_order(text, order, refinements);
    MemoryRecorder recorder(scene, MPI_COMM_WORLD);
    LatticeRun(scene, MPI_COMM_WORLD).run(recorder);
    return tip_motion(recorder);
  }

  /** Also records the elements of the run. */
  class DivisionRecorder : public MemoryRecorder
  {
  public:
    using MemoryRecorder::MemoryRecorder;

    void begin(const Equations &equations) override
    {
      divisions = equations.model().numbering.divisions();
      MemoryRecorder::begin(equations);
    }

    std::vector<StrutDivision> divisions;
  };

  /**
   * Expects error and estimate below the tolerance. Returns the chosen
   * elements.
   */
  std::vector<StrutDivision> expect_met(const SceneText           &text,
                                        const double               tolerance,
                                        const std::vector<double> &exact,
                                        const double               factor = 1)
  {
    const Scene       scene = scene_of(text, tolerance);
    DivisionRecorder  recorder(scene, MPI_COMM_WORLD);
    const RunResult   result = run_lattice(scene, MPI_COMM_WORLD, recorder);
    const OrderReport report = result.orders.value();
    EXPECT_EQ(report.tolerance, tolerance);
    EXPECT_LE(report.predicted_error, tolerance);
    EXPECT_LE(report.estimated_error.value(), factor * tolerance);
    EXPECT_LE(relative_difference(tip_motion(recorder), exact),
              factor * tolerance)
      << tolerance;
    return recorder.divisions;
  }
} // namespace

TEST(OrderChoice, StaticsMeetTheTolerance)
{
  const std::vector<double> exact = exact_motion(knee(), 6);
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    expect_met(knee(), tolerance, exact);
}

TEST(OrderChoice, AStronglyBentStrutMeetsTheTolerance)
{
  // The low-order elements of the search run are far from the arc.
  const std::vector<double> exact = exact_motion(pushed_strut(6), 6);
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
    expect_met(pushed_strut(6), tolerance, exact);
}

TEST(OrderChoice, StrutsForWhichNoOrderIsEnoughGetMoreElements)
{
  for (const auto &[text, order] :
       {std::pair(wound_strut(), 6u), std::pair(wound_space_strut(), 4u)})
    {
      const std::vector<double> exact = exact_motion(text, order);
      for (const double tolerance : {1e-2, 1e-4, 1e-6})
        {
          const std::vector<StrutDivision> divisions =
            expect_met(text, tolerance, exact);
          EXPECT_EQ(divisions.back().n_elements, 1u) << tolerance;
          if (tolerance < 1e-5)
            {
              EXPECT_GT(divisions.front().n_elements, 1u) << tolerance;
            }
        }
    }
}

TEST(OrderChoice, ElementsAreMultiplesOfThoseThatAllStrutsHave)
{
  for (const StrutDivision &division :
       elements_of(
         scene_of(wound_strut().set("Discretization/Global refinements", 1),
                  1e-6),
         MPI_COMM_WORLD)
         .divisions)
    EXPECT_EQ(division.n_elements % 2, 0u);
}

TEST(OrderChoiceOnRanks, DynamicsMeetTheTolerance)
{
  // The search run has longer steps and a slightly different motion.
  const std::vector<double> exact = exact_motion(hit_knee(), 6);
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
    expect_met(hit_knee(), tolerance, exact, 3);
}

TEST(OrderChoice, SpaceMeetsTheTolerance)
{
  const std::vector<double> exact = exact_motion(space_knee(), 4);
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4})
    expect_met(space_knee(), tolerance, exact);
}

TEST(OrderChoice, LongStrutsGetHigherOrders)
{
  const SceneText      straight = knee().set("Lattice/Struts", "0 1; 1 2; 2 3");
  const ChosenElements chosen =
    elements_of(scene_of(straight, 1e-4), MPI_COMM_WORLD);
  ASSERT_EQ(chosen.divisions.size(), 3u);
  EXPECT_GT(chosen.divisions[0].order, chosen.divisions[2].order);
  EXPECT_GE(chosen.divisions[0].order, chosen.divisions[1].order);
  EXPECT_GT(chosen.report.steps, 0u);
}

TEST(OrderChoice, EqualStrutsGetEqualElements)
{
  // A symmetric lattice would buckle to one side.
  const SceneText arcade =
    static_frame("0.1 0; 0.1 1; 0.8 1.2; 1.5 1; 1.5 0; 2.2 1.2; 2.9 1; 2.9 0",
                 "0 1; 1 2; 2 3; 3 4; 3 5; 5 6; 6 7")
      .section({100, 50, 0.05})
      .support("feet", "0, 4, 7", "clamp")
      .load("weight", "2, 5", {"0", "-0.3 * t", "0"})
      .time(1, 0.1);
  for (double tolerance = 0.3; tolerance > 1e-6; tolerance /= 1.3)
    {
      const std::vector<StrutDivision> divisions =
        elements_of(scene_of(arcade, tolerance), MPI_COMM_WORLD).divisions;
      for (const auto &[one, other] : {std::pair(0, 6), {1, 5}, {2, 4}})
        EXPECT_EQ(divisions[one], divisions[other]) << tolerance;
    }
}

TEST(OrderChoiceOnRanks, EstimateIsNoLessThanTheErrorOfTheJoints)
{
  const std::vector<double> exact = exact_motion(knee(), 6);
  for (unsigned int order = 2; order <= 5; ++order)
    {
      const Scene    scene = scene_of_order(knee(), order);
      MemoryRecorder memory(scene, MPI_COMM_WORLD);
      RunPlan        plan(scene);
      plan.elements = ChosenElements();
      LatticeRun run(plan, MPI_COMM_WORLD);
      run.run(memory);
      const double error    = relative_difference(tip_motion(memory), exact),
                   estimate = run.mesh_error()->relative();
      // The bound holds in the energy norm; a single displacement has about
      // the same error.
      EXPECT_GE(estimate, 0.5 * error) << order;
      EXPECT_LE(estimate, 100 * error) << order;
    }
}

TEST(OrderChoice, ReportsAMissedTolerance)
{
  // No order suffices; all struts that need more get 6.
  const Scene     scene = scene_of(knee(), 1e-14);
  MemoryRecorder  recorder(scene, MPI_COMM_WORLD);
  const RunResult result = run_lattice(scene, MPI_COMM_WORLD, recorder);
  EXPECT_TRUE(std::any_of(result.findings.begin(),
                          result.findings.end(),
                          [](const Finding &finding) {
                            return finding.text.find(
                                     "Discretization/Tolerance = 1e-14") !=
                              std::string::npos;
                          }));
}

TEST(OrderChoice, SearchReportsItsProgress)
{
  struct : public Recorder
  {
    void search_step(const RunPlan &search,
                     const State   &state,
                     const StepReport &) override
    {
      EXPECT_EQ(search.division.order, 2u);
      EXPECT_FALSE(has_begun);
      EXPECT_EQ(state.step, ++n_steps);
      time = state.time;
    }
    void begin(const Equations &) override
    {
      has_begun = true;
    }
    unsigned long n_steps   = 0;
    double        time      = 0;
    bool          has_begun = false;
  } recorder;
  run_lattice(scene_of(hit_knee(), 1e-3), MPI_COMM_WORLD, recorder);
  EXPECT_EQ(recorder.n_steps, 64u);
  EXPECT_DOUBLE_EQ(recorder.time, 0.1);
  EXPECT_TRUE(recorder.has_begun);
}

TEST(OrderChoice, MistypedProbeIsFoundBeforeTheSearch)
{
  struct : public Recorder
  {
    void
    search_step(const RunPlan &, const State &, const StepReport &) override
    {
      ADD_FAILURE();
    }
  } recorder;
  EXPECT_THROW(run_lattice(scene_of(knee().probe("nowhere", "x > 100"), 1e-3),
                           MPI_COMM_WORLD,
                           recorder),
               InputError);
}

TEST(OrderChoice, ReportsVibratingStruts)
{
  const SceneText heavy = hit_knee().set("Sections/section 0/Density", 0.01);
  const auto      finds = [](const SceneText &text) {
    const Scene     scene = scene_of(text, 1e-2);
    MemoryRecorder  recorder(scene, MPI_COMM_WORLD);
    const RunResult result = run_lattice(scene, MPI_COMM_WORLD, recorder);
    return std::any_of(result.findings.begin(),
                       result.findings.end(),
                       [](const Finding &finding) {
                         return finding.text.find("resolve vibrations of") !=
                           std::string::npos;
                       });
  };
  EXPECT_TRUE(finds(heavy));
  // Shorter elements do not reveal the vibrations either.
  EXPECT_TRUE(
    finds(SceneText(heavy).set("Discretization/Global refinements", 1)));
  // Steps of the scene are too long for them, but not the parts of divided
  // steps.
  const SceneText long_steps = hit_knee();
  EXPECT_FALSE(finds(long_steps));
  EXPECT_TRUE(
    finds(SceneText(long_steps).set("Time/Relative tolerance", "1e-6")));
  // The same holds for stages.
  EXPECT_TRUE(finds(SceneText(long_steps).set("Time/Scheme", "esdirk")));
}

TEST(OrderChoiceOnRanks, IsTheSame)
{
  for (const SceneText &text :
       {knee(), space_knee(), wound_strut(), wound_space_strut()})
    EXPECT_EQ(elements_of(scene_of(text, 1e-4), MPI_COMM_WORLD).divisions,
              elements_of(scene_of(text, 1e-4), MPI_COMM_SELF).divisions);
}

TEST(OrderChoiceOnRanks, ResumesExactly)
{
  for (const SceneText &text : {hit_knee(), space_knee().time(1, 0.1)})
    {
      const Scene scene = scene_of(text, 1e-3);
      RunPlan     plan(scene);
      plan.elements     = elements_of(scene, MPI_COMM_WORLD);
      const auto end_of = [](MemoryRecorder &memory, LatticeRun &run) {
        run.advance_to_end(memory);
        return std::make_pair(memory.rows().back(),
                              run.mesh_error()->relative());
      };

      MemoryRecorder first(scene, MPI_COMM_WORLD);
      LatticeRun     run(plan, MPI_COMM_WORLD);
      first.begin(run.equations);
      run.start();
      first.start(run.solution);
      for (unsigned int step = 0; step < 5; ++step)
        {
          const StepReport report = run.advance(first);
          first.step(run.solution, report);
        }
      const CheckpointData checkpoint = run.checkpoint(first);
      const auto           whole      = end_of(first, run);

      MemoryRecorder second(scene, MPI_COMM_WORLD);
      LatticeRun     resumed(plan, MPI_COMM_WORLD);
      second.begin(resumed.equations);
      resumed.resume(checkpoint, second);
      const auto half = end_of(second, resumed);
      EXPECT_EQ(whole.first, half.first);
      EXPECT_EQ(whole.second, half.second);
    }
}

TEST(OrderChoice, ResumedRunsKeepTheirElements)
{
  const std::string text = SceneText(wound_strut())
                             .set("Discretization/Order", "auto")
                             .set("Discretization/Tolerance", 1e-6)
                             .str();
  const auto [whole, half] = runs_that_are_same(text);
  ASSERT_TRUE(whole.result.orders);
  EXPECT_EQ(half.result.orders->predicted_error,
            whole.result.orders->predicted_error);
  EXPECT_EQ(half.result.orders->estimated_error,
            whole.result.orders->estimated_error);
  EXPECT_EQ(half.result.orders->steps, whole.result.orders->steps);
}

TEST(OrderChoice, StudyOfOrdersIsRefused)
{
  const SceneText text = knee()
                           .set("Analysis", "study")
                           .set("Discretization/Order", "auto")
                           .set("Quantities/tip", "tip.uy at 1 s");
  try
    {
      read_scene_from_text(text.str(), "test.prm");
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("Discretization/Order = auto"),
                std::string::npos)
        << error.what();
    }
}
