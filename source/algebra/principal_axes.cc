#include <auxfem/algebra/principal_axes.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace auxfem
{
  std::array<PrincipalAxis, 3>
  principal_axes(const dealii::Tensor<2, 3> &tensor)
  {
    // Not dealii::eigenvectors(): GCC and Clang give it different symbols, and
    // the library has that of the compiler it was built with.
    dealii::LAPACKFullMatrix<double> matrix(3, 3);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        matrix(i, j) = tensor[i][j];
    matrix.compute_svd();
    const auto                  &u = matrix.get_svd_u();
    std::array<PrincipalAxis, 3> axes;
    for (unsigned int a = 0; a < 3; ++a)
      {
        axes[a].value = matrix.singular_value(a);
        for (unsigned int i = 0; i < 3; ++i)
          axes[a].direction[i] = u(i, a);
      }
    return axes;
  }
} // namespace auxfem
