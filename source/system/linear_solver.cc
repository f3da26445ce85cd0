#include <auxfem/parameters/errors.h>
#include <auxfem/system/linear_solver.h>

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <limits>

#include <Amesos.h>

namespace auxfem
{
  namespace
  {
    /**
     * Unknowns up to which KLU on one rank, with the matrix sent there, is
     * quicker than MUMPS on all: on two ranks 6, 5 and 2 times quicker at
     * 10,000, 41,000 and 163,000 unknowns of the planar star lattice.
     */
    constexpr unsigned int klu_limit = 300000;

    std::string choose(const SolverParameters &parameters,
                       const DofNumbering     &numbering)
    {
      const bool wants_mumps = parameters.type == "mumps" ||
        (parameters.type == "auto" && numbering.n_ranks() > 1 &&
         numbering.n_unknowns() > klu_limit);
      const bool has_mumps = Amesos().Query("Amesos_Mumps");
      if (parameters.type == "mumps" && !has_mumps)
        throw InputError(
          "Solver/Type: this Trilinos has no MUMPS. Use `klu` or `auto`.");
      return wants_mumps && has_mumps ? "Amesos_Mumps" : "Amesos_Klu";
    }
  } // namespace

  LinearSolver::LinearSolver(const SolverParameters &parameters,
                             TangentMatrix          &matrix,
                             const DofNumbering     &numbering)
    : numbering(numbering)
    , type(choose(parameters, numbering))
    , rhs(numbering.owned_map())
    , solution(numbering.owned_map())
    , problem(&matrix.matrix(), &solution, &rhs)
    , solver(Amesos().Create(type, problem))
  {
    Teuchos::ParameterList list;
    // KLU then keeps its pivot order while that is numerically sound.
    list.set("Refactorize", true);
    list.set("OutputLevel", 0);
    list.set("PrintTiming", false);
    list.set("PrintStatus", false);
    solver->SetParameters(list);
  }

  bool LinearSolver::factorize()
  {
    if (!has_symbolic && solver->SymbolicFactorization() != 0)
      return false;
    has_symbolic = true;
    return solver->NumericFactorization() == 0;
  }

  const Epetra_Vector &LinearSolver::solve()
  {
    // A failed solution must show: the next residual is then not finite.
    if (solver->Solve() != 0)
      solution.PutScalar(std::numeric_limits<double>::quiet_NaN());
    return solution;
  }

  void LinearSolver::solve(Epetra_Vector &at_local_unknowns)
  {
    solve();
    if (numbering.n_ranks() == 1)
      std::copy(solution.Values(),
                solution.Values() + numbering.n_owned(),
                at_local_unknowns.Values());
    else
      at_local_unknowns.Import(solution, numbering.importer(), Insert);
  }

  Epetra_Vector &LinearSolver::right_side()
  {
    return rhs;
  }
} // namespace auxfem
