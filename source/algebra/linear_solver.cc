#include <auxfem/algebra/linear_solver.h>

#include <algorithm>
#include <limits>

namespace auxfem
{
  LinearSolver::LinearSolver(const SolverParameters &parameters,
                             TangentMatrix          &matrix,
                             const LatticeModel     &model)
    : numbering(model.numbering)
    , rhs(numbering.owned_map())
    , solution(numbering.owned_map())
    , method(parameters.type == "gmres"
               ? make_gmres_method(parameters, matrix, model)
               : make_direct_method(parameters, matrix, numbering))
  {}

  bool LinearSolver::factorize()
  {
    return method->factorize();
  }

  const Epetra_Vector &LinearSolver::solve()
  {
    why_failed = method->solve(rhs, solution);
    return solution;
  }

  void LinearSolver::solve(Epetra_Vector &at_local_unknowns)
  {
    solve();
    // A failed solution must show: the next residual is then not finite.
    if (!why_failed.empty())
      solution.PutScalar(std::numeric_limits<double>::quiet_NaN());
    if (numbering.n_ranks() == 1)
      std::copy(solution.Values(),
                solution.Values() + numbering.n_owned(),
                at_local_unknowns.Values());
    else
      at_local_unknowns.Import(solution, numbering.importer(), Insert);
  }

  const std::string &LinearSolver::failure() const
  {
    return why_failed;
  }

  unsigned long LinearSolver::n_iterations() const
  {
    return method->n_iterations();
  }

  Epetra_Vector &LinearSolver::right_side()
  {
    return rhs;
  }
} // namespace auxfem
