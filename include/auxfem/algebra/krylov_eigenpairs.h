#ifndef auxfem_algebra_krylov_eigenpairs_h
#define auxfem_algebra_krylov_eigenpairs_h

#include <auxfem/algebra/eigen_solver.h>

namespace auxfem
{
  /** Directions that are kept for @p n eigenpairs. */
  constexpr unsigned int n_krylov_directions(const unsigned int n)
  {
    return 2 * n + 20;
  }

  /**
   * As nearest_eigenpairs(), by the Krylov-Schur method (Stewart 2001, SIAM J.
   * Matrix Anal. Appl. 23, 601; Trilinos Anasazi on Tpetra) for
   * (K - sigma M)^-1 M in the inner product by M (Ericsson & Ruhe 1980, Math.
   * Comp. 35, 1251) or K - sigma M (Grimes, Lewis & Simon 1994, SIAM J. Matrix
   * Anal. Appl. 15, 228). Does not scale vectors.
   * Collective.
   */
  Eigenpairs krylov_eigenpairs(const ShiftedEigenproblem &problem,
                               unsigned int               n);
} // namespace auxfem
#endif
