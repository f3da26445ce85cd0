#ifndef auxfem_algebra_eigen_solver_h
#define auxfem_algebra_eigen_solver_h

#include <auxfem/algebra/unknowns.h>

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * K x = lambda M x with symmetric operators on the owned rows of all ranks. M
   * is positive semidefinite, or K - sigma M is positive definite. All
   * operators are collective.
   */
  struct ShiftedEigenproblem
  {
    const UnknownLayout &layout;
    /** Shift sigma; it must not be an eigenvalue. */
    double shift;
    /** y = M x. */
    std::function<void(const double *x, double *y)> multiply_mass;
    /** x <- (K - sigma M)^-1 x; returns success. */
    std::function<bool(double *x)> solve;
    /** Upper bound for the number of finite eigenvalues. */
    unsigned int n_finite;
    /**
     * y = (K - sigma M) x: inner product for unit length of vectors where M is
     * not semidefinite. If empty, M defines it.
     */
    std::function<void(const double *x, double *y)> multiply_definite = {};
    /** Whether to ignore eigenvalues below the shift. */
    bool only_above = false;
  };

  struct Eigenpair
  {
    double value;
    /**
     * Owned rows, of unit length in the norm of M, or of K - sigma M if
     * multiply_definite is set.
     */
    std::vector<double> vector;
  };

  /**
   * Eigenpairs by ascending eigenvalue; `failure_reason` gives the reason if
   * some are missing.
   */
  struct Eigenpairs
  {
    std::vector<Eigenpair> pairs;
    std::string            failure_reason;
  };

  /**
   * The @p n eigenpairs nearest to the shift: by dense_eigenpairs() if few
   * eigenvalues are finite, else by krylov_eigenpairs(), which may miss some
   * equal eigenvalues; verify the count with an inertia. Collective.
   */
  Eigenpairs nearest_eigenpairs(const ShiftedEigenproblem &problem,
                                unsigned int               n);

  /** Dimension of the Krylov space for @p n eigenpairs. */
  constexpr unsigned int n_krylov_directions(const unsigned int n)
  {
    return 2 * n + 20;
  }

  /**
   * As nearest_eigenpairs(), by the Krylov-Schur method (Stewart 2001, SIAM J.
   * Matrix Anal. Appl. 23, 601; Trilinos Anasazi) for (K - sigma M)^-1 M in the
   * inner product of M (Ericsson & Ruhe 1980, Math. Comp. 35, 1251) or K -
   * sigma M (Grimes, Lewis & Simon 1994, SIAM J. Matrix Anal. Appl. 15, 228).
   * Does not normalize vectors. Collective.
   */
  Eigenpairs krylov_eigenpairs(const ShiftedEigenproblem &problem,
                               unsigned int               n);

  /**
   * As nearest_eigenpairs(), by LAPACK on dense matrices of all unknowns,
   * replicated on every rank; for so few finite eigenvalues that Krylov's
   * method runs out of directions. Eigenvalues far above the lowest lose digits
   * on fine meshes as the condition of K grows. Does not normalize vectors.
   * Collective.
   */
  Eigenpairs dense_eigenpairs(const ShiftedEigenproblem &problem,
                              unsigned int               n);

  /** Ascending eigenvalues of a symmetric matrix by LAPACK; not a number if it
   * does not converge. */
  std::vector<double>
  symmetric_eigenvalues(const dealii::FullMatrix<double> &matrix);

  /** Eigenvalue of a real matrix with its vector of unit length. */
  struct ComplexEigenpair
  {
    std::complex<double>              value;
    std::vector<std::complex<double>> vector;
  };

  /**
   * All eigenpairs of a small unsymmetric matrix by LAPACK; of a conjugate
   * pair, the one above the real axis. Empty if LAPACK does not converge.
   * @param matrix @p n columns of n entries
   */
  std::vector<ComplexEigenpair> general_eigenpairs(std::vector<double> matrix,
                                                   int                 n);
} // namespace auxfem

#endif
