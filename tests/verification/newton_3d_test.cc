#include <auxfem/time/schemes/static.h>

#include <gtest/gtest.h>
#include <support/scene_text.h>
#include <verification/space_run.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <vector>

#include "result_table.h"

using namespace auxfem;
using namespace auxfem::testing_support;

namespace
{
  struct Iterate
  {
    double residual; ///< relative to the size of forces
    double error;    ///< largest displacement (m) or turn (rad) to the solution
  };

  double distance(const State &a, const State &b, const Unknowns &unknowns)
  {
    double largest = 0;
    // Rotations are not the sum of those of steps.
    for (unsigned int i = 0; i < a.displacement.size(); ++i)
      if (!unknowns.is_rotation[i])
        largest =
          std::max(largest, std::abs(a.displacement[i] - b.displacement[i]));
    for (unsigned int i = 0; i < a.rotations.size(); ++i)
      largest = std::max(
        largest,
        rotation_vector(conjugate(a.rotations[i]) * b.rotations[i]).norm());
    return largest;
  }

  /**
   * Iterates of full Newton's method for the step of @p run from @p before:
   * those of attempts that may take 1, 2, ... iterations.
   */
  std::vector<Iterate> iterates(SpaceRun &run, const State &before)
  {
    std::vector<Iterate> found;
    Newton::Result       result;
    while (!result.converged && found.size() < 20)
      {
        State             to = before;
        const QuasiStatic scheme;
        to.time = run.state.time;
        const Evaluation step =
          Evaluation::static_step(before, to, to.time - before.time);
        NewtonParameters parameters;
        parameters.tolerance          = 1e-10;
        parameters.maximum_iterations = found.size() + 1;
        parameters.keep_factorization = false;
        Work              work;
        TangentSolver     solver(run.equations, run.scene.solver, work);
        EvaluationResults results = run.equations.make_results();
        result = Newton(solver, parameters).solve(scheme, step, results);
        found.push_back(
          {result.relative_residual,
           distance(to, run.state, run.model.numbering.unknowns())});
      }
    EXPECT_TRUE(result.converged) << result.reason;
    return found;
  }
} // namespace

TEST(Newton3d, ConvergesQuadraticallyAtLargeRotations)
{
  // A knee of two struts, the first an arc out of the plane, under forces and
  // moments, dead and following, that turn its end by almost half a turn.
  SceneText scene =
    static_space_frame("0 0 0; 1 0 0; 1 1 0.3", "0 1 0.2 0 1 0.5; 1 2");
  scene.space_section({1e3, 1e3, 1e3, 0.8, 1, 2})
    .load("tip", "2", {{"t", "-t", "2 * t"}}, {{"t", "0.5 * t", "0"}})
    .load("knee", "1", {{"0", "t", "t"}}, {{"0", "t", "0.5 * t"}})
    .support("clamp", "0", "clamp")
    .mesh(3, 2)
    .time(2, 0.25)
    .set("Loads/knee/Direction", "follows the joint");
  SpaceRun run(scene.str());
  // The constant of quadratic convergence is at most about that of the problem:
  // axial over bending stiffness, by which stretching has to be undone after a
  // turn. Round-off ends the sequence.
  const double constant = 500, near = 1e-2, round_off = 1e-13;
  ResultTable  table("Full Newton's method, knee in space",
                    {"load",
                      "iteration",
                      "relative residual",
                      "error",
                      "error / previous error squared"});
  State        before = run.state;
  run.run([&] {
    const std::vector<Iterate> found = iterates(run, before);
    for (unsigned int i = 0; i < found.size(); ++i)
      {
        const bool is_round_off = i == 0 || found[i].error <= round_off;
        table.row(
          {formatted("%g", run.state.time),
           std::to_string(i + 1),
           formatted("%.2g", found[i].residual),
           formatted("%.2g", found[i].error),
           is_round_off
             ? ""
             : formatted("%.2g",
                         found[i].error / std::pow(found[i - 1].error, 2))});
        if (i > 0 && found[i - 1].error < near)
          {
            EXPECT_LT(found[i].error,
                      round_off + constant * std::pow(found[i - 1].error, 2))
              << "load " << run.state.time << ", iteration " << i + 1;
          }
      }
    before = run.state;
  });
  EXPECT_GT(rotation_vector(run.rotation(2)).norm(), 2.5) << "hardly turned";
}
