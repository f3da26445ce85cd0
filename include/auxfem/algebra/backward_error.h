#ifndef auxfem_algebra_backward_error_h
#define auxfem_algebra_backward_error_h

#include <auxfem/algebra/tangent_matrix.h>

namespace auxfem
{
  /**
   * Largest of |A x - b| / (|A| y + |b|) by rows: how wrong the entries of A
   * and b would have to be for @p x to be the solution (J. L. Rigal, J. Gaches,
   * J. ACM 14, 1967, 543-548). y is the largest |x| of all motions, rotations
   * measured in Unknowns::length times radian, or of all multipliers; what is
   * below least_of_full_precision is no error. Infinite if something is no
   * number.
   *
   * @param x values at local unknowns, ghosts up to date
   * @param b owned rows
   * @param symmetry as in TangentMatrix::multiply(). Collective.
   */
  double backward_error(const TangentMatrix       &matrix,
                        const std::vector<double> &x,
                        const std::vector<double> &b,
                        Symmetry                   symmetry = Symmetry::none);
} // namespace auxfem

#endif
