#ifndef auxfem_algebra_ritz_values_h
#define auxfem_algebra_ritz_values_h

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace auxfem
{
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
