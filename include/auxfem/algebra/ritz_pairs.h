#ifndef auxfem_algebra_ritz_pairs_h
#define auxfem_algebra_ritz_pairs_h

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace auxfem
{
  /** Ritz values and vectors. */
  struct RitzPairs
  {
    std::vector<double> values; ///< quotients, descending
    /** Column j: coefficients of the combination with values[j]. */
    dealii::FullMatrix<double> coefficients;
  };

  /**
   * Rayleigh-Ritz method: stationary values of y.S y / y.D y over the
   * combinations of some vectors; dependent vectors reduce their number.
   * @param numerator, denominator S and D, symmetric, D positive definite
   */
  RitzPairs ritz_pairs(const dealii::FullMatrix<double> &numerator,
                       const dealii::FullMatrix<double> &denominator);

  /**
   * As ritz_pairs() for many vectors that are independent, by LAPACK.
   * @param n number of columns of coefficients, of the first values
   */
  RitzPairs independent_pairs(const dealii::FullMatrix<double> &numerator,
                              const dealii::FullMatrix<double> &denominator,
                              unsigned int                      n);

  /** Values of ritz_pairs(). */
  std::vector<double>
  ritz_values(const dealii::FullMatrix<double> &numerator,
              const dealii::FullMatrix<double> &denominator);
} // namespace auxfem

#endif
