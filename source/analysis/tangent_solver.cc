#include <auxfem/algebra/conjugate_gradients.h>
#include <auxfem/analysis/saved_matrix.h>
#include <auxfem/analysis/tangent_solver.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/time/stopwatch.h>

#include <utility>

namespace auxfem
{
  namespace
  {
    const std::string pivot_record         = ": entries of pivots",
                      factorization_record = ": factorization";
  } // namespace

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
    const FactorizationOutcome outcome = solver.factorize(exactness);
    work.linear_solver                 = solver.method();
    if (outcome == FactorizationOutcome::out_of_memory ||
        outcome == FactorizationOutcome::too_large)
      throw ComputationError("No solution could be computed: " + solver.why() +
                             '.');
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

  bool TangentSolver::factorize_again(const Exactness exactness)
  {
    const bool done = factorize(exactness);
    --work.factorizations;
    is_new_factorization = false;
    return done;
  }

  void TangentSolver::save(const std::string &name,
                           const bool         with_factorization,
                           Records           &records) const
  {
    const UnknownLayout &layout = equation_system.unknowns().layout;
    std::vector<double>  pivots = solver.pivot_entries();
    // Other numbers of ranks put the matrix together in another order.
    pivots.push_back(layout.n_ranks());
    records.keep(name + pivot_record, {layout.rank()}, pivots.size(), pivots);
    if (!with_factorization)
      return;
    save_matrix(name, tangent, model().numbering, records);
    records.keep(name + factorization_record,
                 {solver.is_exact() ? 1. : 0., is_new_factorization ? 1. : 0.});
  }

  bool TangentSolver::resume(const std::string &name, const Records &records)
  {
    const UnknownLayout &layout = equation_system.unknowns().layout;
    if (const std::string of_pivots = name + pivot_record;
        records.has(of_pivots))
      {
        std::vector<double> pivots =
          records.values(of_pivots,
                         records.items(of_pivots),
                         records.values_per_item(of_pivots));
        const bool serve = pivots.back() == layout.n_ranks();
        pivots.pop_back();
        if (serve)
          solver.take_pivots_of(pivots);
      }
    if (!records.has(name + factorization_record))
      return false;
    resume_matrix(name, model().numbering, records, tangent);
    const std::vector<double> flags =
      records.values(name + factorization_record, 2);
    const bool done      = factorize_again(flags[0] != 0 ? Exactness::exact
                                                    : Exactness::approximate);
    is_new_factorization = flags[1] != 0;
    return done;
  }
} // namespace auxfem
