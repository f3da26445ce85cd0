#include <auxfem/loads/effects/prescribed_motion.h>
#include <auxfem/time/newton.h>
#include <auxfem/time/schemes/alpha_family.h>
#include <auxfem/time/schemes/static.h>

#include <equations/equations_on_ranks.h>
#include <gtest/gtest.h>
#include <mesh/cell_from_text.h>

#include <cmath>
#include <cstdio>

#include <support/pi.h>

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  const std::string in_statics = "Scheme = static";

  /** One static step of a scene from rest. */
  struct StaticStep
  {
    StaticStep(const std::string              &text,
               const NewtonParameters         &parameters,
               const std::vector<std::string> &overrides = {})
      : setup(text, overrides, MPI_COMM_SELF)
      , solver(setup.equations, setup.scene.solver, work)
      , newton(solver, parameters)
      , from(setup.equations.initial_state())
      , to(from)
    {}

    Newton::Result solve()
    {
      to.time               = from.time + 1.;
      const Evaluation step = Evaluation::static_step(from, to, 1.);
      scheme.predict(step.from, step.dt, step.to);
      return newton.solve(scheme, step, setup.results);
    }

    double tip(const unsigned int component) const
    {
      return to.displacement[setup.dofs().joint_unknown(1, component)];
    }

    EquationsOnRanks setup;
    Work             work;
    TangentSolver    solver;
    Newton           newton;
    QuasiStatic      scheme;
    State            from, to;
  };

  NewtonParameters full_newton()
  {
    NewtonParameters parameters;
    parameters.keep_factorization = false;
    return parameters;
  }
} // namespace

TEST(Newton, ConvergesQuadraticallyWithAFreshFactorization)
{
  std::vector<double> residuals;
  for (unsigned int n = 0; n <= 12; ++n)
    {
      NewtonParameters parameters   = full_newton();
      parameters.maximum_iterations = n;
      parameters.tolerance          = 1e-11;
      StaticStep           step(cantilever("0.5", in_statics), parameters);
      const Newton::Result result_at_n = step.solve();
      residuals.push_back(result_at_n.relative_residual);
      EXPECT_EQ(step.work.factorizations, result_at_n.iterations);
      if (result_at_n.converged)
        break;
    }
  std::printf("iteration  relative residual  over square of the last\n");
  unsigned int n_checked = 0;
  // The first residual has no reference force.
  for (unsigned int n = 2; n < residuals.size(); ++n)
    {
      const double ratio = residuals[n] / (residuals[n - 1] * residuals[n - 1]);
      std::printf("%9u  %17.3e  %23.2f\n", n, residuals[n], ratio);
      // Only where convergence has begun and round-off (1e-15) is far. A wrong
      // tangent leaves a fixed fraction of each residual.
      if (residuals[n - 1] < 0.1 && residuals[n] > 1e-14)
        {
          EXPECT_LT(ratio, 5.);
          ++n_checked;
        }
    }
  EXPECT_LT(residuals.back(), 1e-11);
  EXPECT_GE(n_checked, 2u);
}

namespace
{
  /** Lee's frame, whose beam is pushed down by @p v (cm) in one step. */
  SceneText pushed_frame(const double v)
  {
    SceneText scene =
      static_frame("0 0; 0 120; 24 120; 120 120", "0 1; 1 2; 2 3");
    scene.section({4.32e7, 4.32e10, 1.44e7})
      .support("hinges", "0, 3", "pin")
      .prescribe("load", "2", {"free", text(-v) + " * t", "free"})
      .mesh(4, 3)
      .time(1, 1);
    return scene;
  }

  /** Whether Newton's method converges with full increments. */
  bool converges_with_whole_increments(StaticStep &step)
  {
    step.to.time             = 1;
    const Evaluation instant = Evaluation::static_step(step.from, step.to, 1.);
    EvaluationResults &results = step.setup.results;
    Vector             increment(step.to.displacement.size());
    step.scheme.predict(instant.from, instant.dt, step.to);
    step.solver.residual(instant, results);
    for (unsigned int i = 0; i < 30; ++i)
      {
        step.solver.assemble(instant,
                             results,
                             step.scheme.factors(step.from, 1.));
        if (!step.solver.factorize())
          return false;
        find_right_side(step.setup.model, instant, increment.data());
        if (!step.solver.solve(increment) ||
            !(largest_motion(step.setup.model, increment).second <= pi))
          return false;
        step.scheme.correct(step.from, increment, 1., step.to);
        step.solver.residual(instant, results);
        // Far above round-off, within quadratic convergence.
        if (results.force <= 1e-6 * results.force_scale)
          return true;
      }
    return false;
  }
} // namespace

TEST(Newton, LineSearchConvergesWhereFullIncrementsFail)
{
  unsigned int n_whole = 0, n_shortened = 0, n_found_by_them = 0;
  for (double v = 0.25; v <= 3; v += 0.125)
    {
      StaticStep step(pushed_frame(v), full_newton());
      StaticStep plain(pushed_frame(v), full_newton());
      const bool is_found = step.solve().converged;
      const bool by_whole = converges_with_whole_increments(plain);
      n_whole += by_whole;
      n_shortened += is_found;
      n_found_by_them += is_found && step.work.shortened > 0;
      // Without line search both methods are equal.
      if (step.work.shortened == 0)
        {
          EXPECT_EQ(is_found, by_whole) << v;
        }
    }
  EXPECT_GE(n_shortened, n_whole + 5);
  EXPECT_GE(n_found_by_them, 5u);
}

TEST(Newton, JacobianReuseSavesFactorizations)
{
  NewtonParameters kept;
  StaticStep       with_reuse(cantilever("0.1", in_statics), kept),
    with_fresh(cantilever("0.1", in_statics), full_newton());
  const Newton::Result result = with_reuse.solve(), fresh = with_fresh.solve();
  ASSERT_TRUE(result.converged);
  ASSERT_TRUE(fresh.converged);
  EXPECT_LT(with_reuse.work.factorizations, with_fresh.work.factorizations);
  for (const unsigned int c : {0u, 1u, rotation_z})
    // Both have residuals below 1e-8 of the force.
    EXPECT_NEAR(with_reuse.tip(c), with_fresh.tip(c), 1e-8);
}

TEST(Newton, ALinearSceneNeedsOneFactorizationInAll)
{
  StaticStep           linear(cantilever("0.5 * t", in_statics),
                    {},
                    {"Effects/Large rotation=off"});
  const Newton::Result first = linear.solve();
  EXPECT_TRUE(first.converged);
  EXPECT_EQ(first.iterations, 1u);
  EXPECT_EQ(linear.work.factorizations, 1u);
  // P L^3 / (3 EI) + P L / (kGA) with G = E / 2.5: exact at order 3.
  const double at_one = 0.5 * (1 / 2.1 + 1 / 2.);
  EXPECT_NEAR(linear.tip(1), at_one, 1e-13);

  linear.from                 = linear.to;
  const Newton::Result second = linear.solve();
  EXPECT_TRUE(second.converged);
  EXPECT_EQ(linear.work.factorizations, 1u);
  EXPECT_NEAR(linear.tip(1), 2 * at_one, 1e-13);
}

TEST(Newton, NoLoadNeedsNoForceScale)
{
  StaticStep           unloaded(cantilever("0", in_statics), {});
  const Newton::Result result = unloaded.solve();
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(unloaded.tip(1), 0.);
}

TEST(Newton, DenormalLoadsAreSolved)
{
  // As in the tails of a Gaussian; below 2e-308 numbers lose digits.
  for (int exponent = -315; exponent <= -295; ++exponent)
    {
      const std::string force = "1e" + std::to_string(exponent);
      StaticStep        step(cantilever(force, in_statics), NewtonParameters());
      EXPECT_TRUE(step.solve().converged) << force;
    }
}

TEST(Newton, PrescribedUnknownsMoveInOneIteration)
{
  StaticStep moved(
    frame_scene("0 0; 1 0", "0 1")
      .support("wall", "0", "clamp")
      .add("Supports/grip",
           "Joints = 1 | Type = prescribed | Displacement x = 0.01 | "
           "Displacement y = 0.2 | Rotation z = -0.3")
      .set("Time/Scheme", "static"),
    {});
  EXPECT_TRUE(moved.solve().converged);
  // Increments are exact except for the solution's round-off.
  EXPECT_NEAR(moved.tip(0), 0.01, 1e-15);
  EXPECT_NEAR(moved.tip(1), 0.2, 1e-15);
  EXPECT_NEAR(moved.tip(rotation_z), -0.3, 1e-15);
}

TEST(Newton, GivesUpAfterTheLargestNumberOfIterations)
{
  NewtonParameters parameters;
  parameters.maximum_iterations = 2;
  const Newton::Result result =
    StaticStep(cantilever("2", in_statics), parameters).solve();
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 2u);
  EXPECT_GT(result.relative_residual, parameters.tolerance);
  EXPECT_NE(result.reason.find("2 iterations"), std::string::npos)
    << result.reason;
}

TEST(Newton, AStructureWithoutResistanceIsReported)
{
  // The middle joint of two hinged struts in line has no transverse
  // resistance.
  StaticStep           hinged(frame_scene("0 0; 1 0; 2 0", "0 1; 1 2")
                      .hinge("all of them", "all")
                      .add("Loads/push", "Joints = 1 | Force y = 1")
                      .support("ends", "0, 2", "pin")
                      .set("Time/Scheme", "static"),
                    {});
  const Newton::Result result = hinged.solve();
  EXPECT_FALSE(result.converged);
  // Rounding decides which of the two occurs.
  EXPECT_TRUE(result.reason == "the matrix is singular" ||
              result.reason ==
                "an iteration turned a section by more than half a turn")
    << result.reason;
}

namespace
{
  /**
   * Stages of a moving cantilever under 0.1 t N, each solved from the previous
   * one, the first from rest.
   */
  struct ConsecutiveStages
  {
    explicit ConsecutiveStages(const SceneText &and_this = {})
      : setup(testing_support::cantilever("0.1 * t", "Scheme = esdirk")
                .add(and_this),
              {},
              MPI_COMM_SELF)
      , solver(setup.equations, setup.scene.solver, work)
      , newton(solver, estimating())
      , from(setup.equations.initial_state())
      , to(from)
    {}

    static NewtonParameters estimating()
    {
      NewtonParameters parameters;
      parameters.estimates_stages = true;
      return parameters;
    }

    Evaluation stage()
    {
      return Evaluation::stage(from, to, /*dt=*/1, /*weight=*/0);
    }

    Newton::Result solve(const double time, const bool ends_step = false)
    {
      to.time          = time;
      Evaluation asked = stage();
      asked.ends_step  = ends_step;
      prescribe_motion(setup.model, asked);
      return newton.solve(setup.scene.time.implicit_scheme(),
                          asked,
                          setup.results);
    }

    double relative_residual()
    {
      solver.residual(stage(), setup.results);
      return setup.results.force / setup.results.force_scale;
    }

    EquationsOnRanks setup;
    Work             work;
    TangentSolver    solver;
    Newton           newton;
    State            from, to;
  };

  const double tolerance_of_stages = NewtonParameters().tolerance;

  /**
   * Whether the result of one iteration has the residual before it, because
   * the one after it was not computed.
   */
  bool is_estimated(const Newton::Result &result)
  {
    EXPECT_TRUE(result.converged);
    EXPECT_EQ(result.iterations, 1u);
    return result.relative_residual > 10 * tolerance_of_stages;
  }

  SceneText large_rotation(const char *const is)
  {
    return SceneText().set("Effects/Large rotation", is);
  }
} // namespace

TEST(Newton, TheResidualOfAStageIsPredictedFromEarlierIterations)
{
  for (const SceneText &scene : {large_rotation("on"), large_rotation("off")})
    {
      ConsecutiveStages stages(scene);
      EXPECT_LT(stages.solve(1).relative_residual, tolerance_of_stages);
      // The reduction by a reused tangent is known after its second stage;
      // linear equations always have the same tangent.
      EXPECT_EQ(is_estimated(stages.solve(1.00001)),
                stages.setup.equations.is_linear());
      EXPECT_TRUE(is_estimated(stages.solve(1.00002)));
      EXPECT_LT(stages.relative_residual(), tolerance_of_stages);
    }
}

TEST(Newton, TheResidualAtTheEndOfAStepIsComputed)
{
  ConsecutiveStages stages;
  stages.solve(1);
  stages.solve(1.00001);
  EXPECT_FALSE(is_estimated(stages.solve(1.00002, /*ends_step=*/true)));
}

TEST(Newton, TheResidualOfADistantStageIsComputed)
{
  ConsecutiveStages stages;
  stages.solve(1);
  stages.solve(1.00001);
  const Newton::Result far = stages.solve(1.5);
  EXPECT_GT(far.iterations, 1u);
  EXPECT_LT(far.relative_residual, tolerance_of_stages);
  EXPECT_LT(stages.relative_residual(), tolerance_of_stages);
}

TEST(Newton, TheResidualOfAStageIsComputedWhereSupportsMoveAndPartsAreRigid)
{
  const SceneText lifted = large_rotation("off").add(
                    "Supports/lift",
                    "Joints = 1 | Type = prescribed | "
                    "Displacement x = 1e-3 * t"),
                  rigid = large_rotation("off")
                            .set("Lattice/Joints", "0 0; 1 0; 2 0")
                            .set("Lattice/Struts", "0 1; 1 2")
                            .rigid_part("end", "1", 1);
  for (const SceneText &scene : {lifted, rigid})
    {
      ConsecutiveStages stages(scene);
      for (const double time : {1., 1.00001, 1.00002, 1.00003})
        EXPECT_LT(stages.solve(time).relative_residual, tolerance_of_stages)
          << scene.str();
    }
}
