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
   * K x = lambda M x with symmetric K and M, as operators on the owned rows of
   * all ranks: M positive semidefinite, or else K - sigma M positive definite.
   * What they compute is collective.
   */
  struct ShiftedEigenproblem
  {
    const UnknownLayout &layout;
    /** Sigma: not an eigenvalue itself. */
    double shift;
    /** y = M x. */
    std::function<void(const double *x, double *y)> multiply_mass;
    /** x becomes (K - sigma M)^-1 x; returns whether that succeeded. */
    std::function<bool(double *x)> solve;
    /** How many eigenvalues are finite, at most. */
    unsigned int n_finite;
    /** y = (K - sigma M) x, where M is not semidefinite: the product in which
     * vectors have unit length. Else none, and it is that by M. */
    std::function<void(const double *x, double *y)> multiply_definite = {};
    /** Whether eigenvalues below the shift do not count. */
    bool only_above = false;
  };

  struct Eigenpair
  {
    double value;
    /** Owned rows, of unit length in the norm by M, or by K - sigma M where
     * that is the definite one. */
    std::vector<double> vector;
  };

  /** What was found, by rising eigenvalue; `why` tells if it is not all. */
  struct Eigenpairs
  {
    std::vector<Eigenpair> pairs;
    std::string            why;
  };

  /**
   * The @p n eigenvalues nearest to the shift with their vectors: by
   * dense_eigenpairs() where few are finite, else by krylov_eigenpairs(). Of
   * equal eigenvalues the latter may miss some: count them by an inertia.
   * Collective.
   */
  Eigenpairs nearest_eigenpairs(const ShiftedEigenproblem &problem,
                                unsigned int               n);

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

  /**
   * As nearest_eigenpairs(), by LAPACK on dense matrices of all unknowns that
   * every rank has: where so few eigenvalues are finite that Krylov's method
   * would run out of directions. Eigenvalues far above the lowest keep seven
   * digits or so on fine meshes, since solutions lose as many as the stiffness
   * has orders of magnitude. Does not scale vectors. Collective.
   */
  Eigenpairs dense_eigenpairs(const ShiftedEigenproblem &problem,
                              unsigned int               n);

  /** Combinations of some vectors with stationary quotients. */
  struct RitzPairs
  {
    std::vector<double> values; ///< quotients, by falling size
    /** Column j: the coefficients of the combination with values[j]. */
    dealii::FullMatrix<double> coefficients;
  };

  /**
   * The Rayleigh-Ritz method: stationary values of y.S y / y.D y over the
   * combinations of some vectors. Fewer than vectors where these depend on each
   * other.
   * @param numerator, denominator S and D, symmetric, D positive definite
   */
  RitzPairs ritz_pairs(const dealii::FullMatrix<double> &numerator,
                       const dealii::FullMatrix<double> &denominator);

  /** The values of ritz_pairs(). */
  std::vector<double>
  ritz_values(const dealii::FullMatrix<double> &numerator,
              const dealii::FullMatrix<double> &denominator);

  /** An eigenvalue of a real matrix with its vector, of unit length. */
  struct ComplexEigenpair
  {
    std::complex<double>              value;
    std::vector<std::complex<double>> vector;
  };

  /**
   * All of a small matrix without symmetry, of conjugate ones that above the
   * real axis, by LAPACK; empty where that does not converge.
   * @param matrix @p n columns of n entries
   */
  std::vector<ComplexEigenpair> general_eigenpairs(std::vector<double> matrix,
                                                   int                 n);
} // namespace auxfem

#endif
