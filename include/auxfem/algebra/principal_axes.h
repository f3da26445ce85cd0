#ifndef auxfem_algebra_principal_axes_h
#define auxfem_algebra_principal_axes_h

#include <deal.II/base/tensor.h>

#include <array>

namespace auxfem
{
  struct PrincipalAxis
  {
    double               value;
    dealii::Tensor<1, 3> direction; ///< of length one
  };

  /** Eigenvalues and eigenvectors of a symmetric @p tensor without negative
   * eigenvalues, the largest first. */
  std::array<PrincipalAxis, 3>
  principal_axes(const dealii::Tensor<2, 3> &tensor);
} // namespace auxfem

#endif
