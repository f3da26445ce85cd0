#include <auxfem/analysis/tangent_solver.h>
#include <auxfem/time/stopwatch.h>

#include <cmath>

#include <AztecOO.h>

namespace auxfem
{
  TangentSolver::TangentSolver(const Equations        &equations,
                               const SolverParameters &parameters,
                               Work                   &work)
    : equation_system(equations)
    , tangent(equations.pattern())
    , linear_solver(parameters, tangent, equations.model())
    , work(work)
  {}

  const Equations &TangentSolver::equations() const
  {
    return equation_system;
  }

  const LatticeModel &TangentSolver::model() const
  {
    return equation_system.model();
  }

  void TangentSolver::residual(const Evaluation  &evaluation,
                               EvaluationResults &results)
  {
    const Stopwatch watch(work.wall.residual);
    equation_system.residual(evaluation, results);
  }

  void TangentSolver::assemble(const Evaluation        &evaluation,
                               const EvaluationResults &results,
                               const TangentFactors    &factors)
  {
    const Stopwatch watch(work.wall.tangent);
    equation_system.tangent(evaluation, results, factors, tangent);
  }

  bool TangentSolver::factorize()
  {
    const Stopwatch watch(work.wall.factorize);
    ++work.factorizations;
    return linear_solver.factorize();
  }

  void TangentSolver::solve(Vector &increment)
  {
    const Stopwatch     watch(work.wall.solve);
    const unsigned long before = linear_solver.n_iterations();
    linear_solver.solve(increment);
    work.linear_iterations += linear_solver.n_iterations() - before;
  }

  const Epetra_Vector &TangentSolver::solve()
  {
    const Stopwatch      watch(work.wall.solve);
    const unsigned long  before   = linear_solver.n_iterations();
    const Epetra_Vector &solution = linear_solver.solve();
    work.linear_iterations += linear_solver.n_iterations() - before;
    return solution;
  }

  bool TangentSolver::solve_by_conjugate_gradients(Vector &increment)
  {
    // A mass matrix needs some ten iterations; of round-off nothing is left
    // that would show beside the error of the first step.
    constexpr double       tolerance          = 1e-13;
    constexpr unsigned int maximum_iterations = 1000;
    const Stopwatch        watch(work.wall.solve);
    const DofNumbering    &numbering = model().numbering;
    Epetra_Vector          solution(numbering.owned_map()), b(right_side());
    double                 size = 0;
    b.Norm2(&size);
    if (!std::isfinite(size))
      return false;
    // Prescribed rows are those of the identity, but their columns stand in
    // free rows: from the values there on, the search stays in the free rows,
    // where the matrix is symmetric.
    for (unsigned int i = 0; i < numbering.layout().n_owned(); ++i)
      if (numbering.unknowns().kinds[i] == UnknownKind::prescribed)
        solution[i] = b[i];
    if (size > 0)
      {
        AztecOO solver(&tangent.matrix(), &solution, &b);
        solver.SetAztecOption(AZ_solver, AZ_cg);
        solver.SetAztecOption(AZ_precond, AZ_Jacobi);
        solver.SetAztecOption(AZ_conv, AZ_rhs);
        solver.SetAztecOption(AZ_output, AZ_none);
        solver.Iterate(maximum_iterations, tolerance);
        Epetra_Vector rest(b);
        tangent.matrix().Multiply(false, solution, rest);
        rest.Update(1., b, -1.);
        double error = 0;
        rest.Norm2(&error);
        // The solver may stop a little early where round-off rules.
        if (!(error <= 10 * tolerance * size))
          return false;
      }
    increment.Import(solution, numbering.importer(), Insert);
    return true;
  }

  Epetra_Vector &TangentSolver::right_side()
  {
    return linear_solver.right_side();
  }

  const std::string &TangentSolver::failure() const
  {
    return linear_solver.failure();
  }

  TangentMatrix &TangentSolver::matrix()
  {
    return tangent;
  }
} // namespace auxfem
