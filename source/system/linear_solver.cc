#include <auxfem/parameters/errors.h>
#include <auxfem/system/linear_solver.h>

#include <Teuchos_ParameterList.hpp>

#include <Amesos.h>

namespace auxfem
{
  namespace
  {
    std::string choose(const SolverParameters &parameters, const int n_ranks)
    {
      Amesos factory;
      if (parameters.type == "klu" ||
          (parameters.type == "auto" && n_ranks == 1))
        return "Amesos_Klu";
      if (factory.Query("Amesos_Mumps"))
        return "Amesos_Mumps";
      if (parameters.type == "mumps")
        throw InputError(
          "Solver/Type: this Trilinos has no MUMPS. Use `klu` or `auto`.");
      return "Amesos_Klu";
    }
  } // namespace

  LinearSolver::LinearSolver(const SolverParameters &parameters,
                             TangentMatrix          &matrix,
                             const DofNumbering     &numbering)
    : type(choose(parameters, numbering.n_ranks()))
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
    solver->Solve();
    return solution;
  }

  Epetra_Vector &LinearSolver::right_side()
  {
    return rhs;
  }

  const std::string &LinearSolver::name() const
  {
    return type;
  }
} // namespace auxfem
