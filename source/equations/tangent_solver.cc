#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/state/step_report.h>

#include <utility>

namespace auxfem
{
  TangentSolver::TangentSolver(const Equations        &equations,
                               const SolverParameters &parameters,
                               Work                   &work)
    : equation_system(equations)
    , tangent(equations.pattern())
    , solver(parameters, tangent)
    , work(work)
  {}

  void TangentSolver::residual(const Evaluation  &evaluation,
                               EvaluationResults &results)
  {
    const Stopwatch watch(work.wall.residual);
    equation_system.residual(evaluation, results);
  }

  void TangentSolver::find_stage_results(const Evaluation  &stage,
                                         EvaluationResults &results)
  {
    const Stopwatch watch(work.wall.residual);
    equation_system.find_stage_results(stage, results);
  }

  void TangentSolver::assemble(const Evaluation        &evaluation,
                               const EvaluationResults &results,
                               const TangentFactors    &factors)
  {
    const Stopwatch watch(work.wall.tangent);
    equation_system.tangent(evaluation, results, factors, tangent);
  }

  bool TangentSolver::factorize(const Exactness exactness)
  {
    const Stopwatch watch(work.wall.factorize);
    ++work.factorizations;
    // A factorization of linear equations must depend on its matrix alone, so
    // restart() can keep it.
    if (equation_system.is_linear())
      solver.forget_pivots();
    const FactorizationOutcome outcome = solver.factorize(exactness);
    work.linear_solver                 = solver.method();
    if (outcome == FactorizationOutcome::out_of_memory ||
        outcome == FactorizationOutcome::too_large)
      throw ComputationError(
        "No solution could be computed: " + solver.last_failure() + '.');
    is_new_factorization = outcome == FactorizationOutcome::done;
    return is_new_factorization;
  }

  bool TangentSolver::solve(Vector &values)
  {
    const Stopwatch     watch(work.wall.solve);
    const unsigned long before = solver.n_iterations();
    ++work.linear_solutions;
    const bool is_solved = solver.solve(values);
    work.linear_iterations += solver.n_iterations() - before;
    return is_solved;
  }

  bool TangentSolver::solve_by_conjugate_gradients(Vector &values)
  {
    const Stopwatch watch(work.wall.solve);
    ++work.linear_solutions;
    return auxfem::solve_by_conjugate_gradients(tangent, values);
  }

  std::optional<Inertia> TangentSolver::new_inertia()
  {
    const Stopwatch watch(work.wall.factorize);
    return std::exchange(is_new_factorization, false) ? solver.inertia()
                                                      : std::nullopt;
  }

  std::optional<NegativeModes> TangentSolver::new_negative_modes()
  {
    const Stopwatch watch(work.wall.factorize);
    if (!std::exchange(is_new_factorization, false))
      return std::nullopt;
    const unsigned long                before = solver.n_iterations();
    const std::optional<NegativeModes> modes  = solver.negative_modes();
    work.linear_iterations += solver.n_iterations() - before;
    if (solver.n_iterations() > before)
      ++work.linear_solutions;
    return modes;
  }
} // namespace auxfem
