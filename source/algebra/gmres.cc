#include <auxfem/algebra/gmres.h>

#include <deal.II/base/index_set.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    using DistributedVector =
      dealii::LinearAlgebra::distributed::Vector<double>;

    /** Of each rank its own rows, one rank after the other. */
    DistributedVector make_vector(const OperatorEquations &equations)
    {
      namespace MPI                = dealii::Utilities::MPI;
      const dealii::IndexSet owned = MPI::create_ascending_partitioning(
        equations.communicator,
        equations.n_owned)[MPI::this_mpi_process(equations.communicator)];
      return DistributedVector(owned, equations.communicator);
    }

    struct Operator
    {
      const OperatorEquations &equations;

      void vmult(DistributedVector &y, const DistributedVector &x) const
      {
        equations.multiply(x.begin(), y.begin());
      }
    };

    struct Preconditioner
    {
      const OperatorEquations &equations;

      void vmult(DistributedVector &y, const DistributedVector &x) const
      {
        y = x;
        if (!equations.precondition(y.begin()))
          throw dealii::SolverControl::NoConvergence(0, 0.);
      }
    };
  } // namespace

  std::string solve_by_gmres(const OperatorEquations   &equations,
                             const std::vector<double> &b,
                             const double               tolerance,
                             std::vector<double>       &x)
  {
    constexpr unsigned int most_iterations = 400, n_kept = 120;
    DistributedVector right_side = make_vector(equations), solution(right_side),
                      preconditioned(right_side);
    std::copy(b.begin(), b.end(), right_side.begin());
    std::copy(x.begin(), x.end(), solution.begin());
    const Operator       matrix{equations};
    const Preconditioner preconditioner{equations};
    try
      {
        preconditioner.vmult(preconditioned, right_side);
        dealii::SolverControl                  control(most_iterations,
                                      tolerance * preconditioned.l2_norm());
        dealii::SolverGMRES<DistributedVector> solver(
          control,
          dealii::SolverGMRES<DistributedVector>::AdditionalData(n_kept + 2));
        solver.solve(matrix, solution, right_side, preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return "GMRES has not converged in " + std::to_string(most_iterations) +
          " iterations";
      }
    std::copy(solution.begin(), solution.end(), x.begin());
    return "";
  }
} // namespace auxfem
