#include <auxfem/parameters/errors.h>
#include <auxfem/system/linear_solver_method.h>

#include <Amesos_BaseSolver.h>
#include <Epetra_LinearProblem.h>
#include <Teuchos_ParameterList.hpp>

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

    class DirectMethod : public LinearSolverMethod
    {
    public:
      DirectMethod(const std::string &type, TangentMatrix &matrix)
        : problem(&matrix.matrix(), nullptr, nullptr)
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

      ~DirectMethod() override
      {
        // What Amesos_Mumps could not begin, for want of memory, it cannot end:
        // MUMPS would abort the program.
        if (!has_symbolic)
          solver.release();
      }

      bool factorize() override
      {
        if (!has_symbolic && solver->SymbolicFactorization() != 0)
          return false;
        has_symbolic = true;
        return solver->NumericFactorization() == 0;
      }

      std::string solve(const Epetra_Vector &b, Epetra_Vector &x) override
      {
        // Amesos reads the right-hand side only, but asks for one it may write.
        problem.SetRHS(const_cast<Epetra_Vector *>(&b));
        problem.SetLHS(&x);
        if (solver->Solve() == 0)
          return "";
        x.PutScalar(std::numeric_limits<double>::quiet_NaN());
        return "the direct solver has failed";
      }

      unsigned long n_iterations() const override
      {
        return 0;
      }

    private:
      Epetra_LinearProblem               problem;
      std::unique_ptr<Amesos_BaseSolver> solver;
      bool                               has_symbolic = false;
    };
  } // namespace

  std::unique_ptr<LinearSolverMethod>
  make_direct_method(const SolverParameters &parameters,
                     TangentMatrix          &matrix,
                     const DofNumbering     &numbering)
  {
    return std::make_unique<DirectMethod>(choose(parameters, numbering),
                                          matrix);
  }
} // namespace auxfem
