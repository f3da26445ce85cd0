#ifndef auxfem_algebra_direct_solvers_h
#define auxfem_algebra_direct_solvers_h

#include <auxfem/algebra/direct_solver.h>

namespace auxfem
{
  /** Where MUMPS factorizes. */
  enum class MumpsRanks
  {
    first,
    /** Contributions add up as they come in: round-off differs from run to
     * run. */
    all
  };

  /** How rows are ordered so that factors stay sparse. */
  enum class EliminationOrder
  {
    minimum_degree,   ///< AMD (Amestoy, Davis, Duff 1996)
    nested_dissection ///< METIS (Karypis, Kumar 1998)
  };

  /**
   * @name Direct solvers, each on any number of ranks. All bring the matrix to
   * the first rank and factorize it there, unless MUMPS is to use all.
   */
  ///@{
  /**
   * CHOLMOD's simplicial LDL' (Chen, Davis, Hager, Rajamanickam 2008), for
   * symmetric matrices: definite ones, and indefinite ones as long as pivots in
   * the order that keeps the factors sparse are sound; `singular` otherwise.
   * Not for matrices with multipliers.
   */
  std::unique_ptr<DirectSolver> make_cholmod(EliminationOrder order);

  /** KLU (Davis, Palamadai Natarajan 2010), for any matrix; no inertia. */
  std::unique_ptr<DirectSolver> make_klu(EliminationOrder order);

  /**
   * MUMPS (Amestoy, Duff, Koster, L'Excellent 2001), for any matrix: LDL' with
   * pivots of one and two rows for symmetric ones, else LU.
   */
  std::unique_ptr<DirectSolver> make_mumps(MumpsRanks ranks);
  ///@}
} // namespace auxfem

#endif
