#ifndef auxfem_algebra_ritz_values_h
#define auxfem_algebra_ritz_values_h

#include <deal.II/lac/full_matrix.h>

#include <complex>
#include <vector>

namespace auxfem
{
  /**
   * The best values that combinations of some vectors give, y.S y / y.D y, by
   * falling size; fewer than vectors where these depend on each other.
   * @param numerator, denominator S and D, symmetric, D positive definite
   */
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
