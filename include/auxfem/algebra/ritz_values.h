#ifndef auxfem_algebra_ritz_values_h
#define auxfem_algebra_ritz_values_h

#include <deal.II/lac/full_matrix.h>

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
} // namespace auxfem

#endif
