#ifndef auxfem_mathematics_non_negative_least_squares_h
#define auxfem_mathematics_non_negative_least_squares_h

#include <vector>

namespace auxfem
{
  /**
   * Minimizes |A x - b| over x >= 0 by the active-set method of Lawson & Hanson
   * (1974, Solving Least Squares Problems, ch. 23).
   * @param columns of A, each as long as @p right_side
   */
  std::vector<double>
  non_negative_least_squares(const std::vector<std::vector<double>> &columns,
                             const std::vector<double> &right_side);
} // namespace auxfem

#endif
