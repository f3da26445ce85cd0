#ifndef auxfem_algebra_direct_solvers_h
#define auxfem_algebra_direct_solvers_h

#include <auxfem/algebra/direct_solver.h>

namespace auxfem
{
  /**
   * @name Direct solvers, each on any number of ranks. All but MUMPS bring the
   * matrix to the first rank and factorize it there.
   */
  ///@{
  /**
   * CHOLMOD's simplicial LDL' (Chen, Davis, Hager, Rajamanickam 2008), for
   * symmetric matrices: definite ones, and indefinite ones as long as pivots in
   * the order that keeps the factors sparse are sound; `singular` otherwise.
   * Not for matrices with multipliers.
   */
  std::unique_ptr<DirectSolver> make_cholmod();

  /** KLU (Davis, Palamadai Natarajan 2010), for any matrix; no inertia. */
  std::unique_ptr<DirectSolver> make_klu();

  /**
   * MUMPS (Amestoy, Duff, Koster, L'Excellent 2001), for any matrix: LDL' with
   * pivots of one and two rows for symmetric ones, else LU.
   */
  std::unique_ptr<DirectSolver> make_mumps();

  /**
   * LAPACK's LDL' of Bunch and Kaufman (1977) on the whole square of a
   * symmetric matrix, for small ones with multipliers.
   */
  std::unique_ptr<DirectSolver> make_dense();
  ///@}

  /**
   * Unknowns up to which make_dense() is quicker than make_mumps(): on planar
   * grids of joints with eight neighbours it factorizes 108 unknowns in 0.19 ms
   * (MUMPS 0.25), 147 in 0.54 (0.54), 192 in 1.1 (0.43), on one rank.
   */
  constexpr unsigned int dense_limit = 140;
} // namespace auxfem

#endif
