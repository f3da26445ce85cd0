#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/out_of_memory.h>
#include <auxfem/system/linear_solver.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <new>

namespace auxfem
{
  namespace
  {
    /** Throws ComputationError on all ranks if one lacks memory. Collective. */
    void refuse_lack_of_memory(const bool          lacks_memory,
                               const DofNumbering &numbering)
    {
      namespace MPI = dealii::Utilities::MPI;

      const MPI_Comm     communicator = numbering.communicator().Comm();
      const unsigned int first =
        MPI::min(lacks_memory ? numbering.rank() : numbering.n_ranks(),
                 communicator);
      if (first < numbering.n_ranks())
        throw ComputationError(
          "The factorization ran " +
          MPI::broadcast(communicator, out_of_memory_text(), first));
    }
  } // namespace

  LinearSolver::LinearSolver(const SolverParameters &parameters,
                             TangentMatrix          &matrix,
                             const System           &system)
    : numbering(system.numbering())
    , rhs(numbering.owned_map())
    , solution(numbering.owned_map())
    , method(parameters.type == "gmres"
               ? make_gmres_method(parameters, matrix, system)
               : make_direct_method(parameters, matrix, numbering))
  {}

  bool LinearSolver::factorize()
  {
    // KLU and MUMPS, by Amesos, tell lack of memory and singular matrices by
    // the same code; what has failed for want of memory is malloc(), which says
    // so here.
    errno                 = 0;
    bool is_factorized    = false;
    bool is_out_of_memory = false;
    try
      {
        is_factorized    = method->factorize();
        is_out_of_memory = !is_factorized && errno == ENOMEM;
      }
    catch (const std::bad_alloc &)
      {
        // The other ranks are still at work on it, and cannot be told here.
        if (numbering.n_ranks() > 1)
          throw;
        is_out_of_memory = true;
      }
    if (!is_factorized)
      refuse_lack_of_memory(is_out_of_memory, numbering);
    return is_factorized;
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
