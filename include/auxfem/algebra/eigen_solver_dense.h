#ifndef auxfem_algebra_eigen_solver_dense_h
#define auxfem_algebra_eigen_solver_dense_h

#include <auxfem/algebra/eigen_solver.h>

namespace auxfem
{
  /**
   * As nearest_eigenpairs(), by LAPACK on dense matrices of all unknowns that
   * every rank has: where so few eigenvalues are finite that Krylov's method
   * would run out of directions. Eigenvalues far above the lowest keep seven
   * digits or so on fine meshes, since solutions lose as many as the stiffness
   * has orders of magnitude. Does not scale vectors. Collective.
   */
  Eigenpairs dense_eigenpairs(const ShiftedEigenproblem &problem,
                              unsigned int               n);
} // namespace auxfem

#endif
