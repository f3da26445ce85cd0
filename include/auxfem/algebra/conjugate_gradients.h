#ifndef auxfem_algebra_conjugate_gradients_h
#define auxfem_algebra_conjugate_gradients_h

#include <auxfem/algebra/tangent_matrix.h>

namespace auxfem
{
  /**
   * Solves with a matrix that is symmetric and positive definite in free rows
   * and columns, as a mass matrix, by conjugate gradients with its diagonal;
   * needs no factorization.
   *
   * @param values the right-hand side in owned rows, replaced by the solution at
   *   all local unknowns, ghosts included
   * @return whether it has converged; @p values are undefined if it has not.
   * Collective.
   */
  bool solve_by_conjugate_gradients(const TangentMatrix &matrix,
                                    std::vector<double> &values);
} // namespace auxfem

#endif
