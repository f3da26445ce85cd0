#ifndef auxfem_algebra_gmres_h
#define auxfem_algebra_gmres_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A x = b as operators on the rows that each rank owns. What they compute is
   * collective. */
  struct OperatorEquations
  {
    MPI_Comm     communicator;
    unsigned int n_owned;
    /** y = A x. */
    std::function<void(const double *x, double *y)> multiply;
    /** Makes x what nearly solves A y = x; returns whether that succeeded. */
    std::function<bool(double *x)> precondition;
  };

  /**
   * Solves @p equations for @p b, owned rows, into @p x, whose values are the
   * first guess, by GMRES (Saad & Schultz 1986; deal.II), until the
   * preconditioned residual is below @p tolerance times that of b. Returns an
   * empty text or why that was not reached. Collective.
   */
  std::string solve_by_gmres(const OperatorEquations   &equations,
                             const std::vector<double> &b,
                             double                     tolerance,
                             std::vector<double>       &x);
} // namespace auxfem

#endif
