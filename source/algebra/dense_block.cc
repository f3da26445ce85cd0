#include <auxfem/algebra/dense_block.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Subtracts multiples of row @p k from the rows below and stores the
     * factors.
     */
    void eliminate_below(double *a, const unsigned int n, const unsigned int k)
    {
      for (unsigned int i = k + 1; i < n; ++i)
        {
          const double factor = a[i * n + k] /= a[k * n + k];
          if (factor != 0)
            for (unsigned int j = k + 1; j < n; ++j)
              a[i * n + j] -= factor * a[k * n + j];
        }
    }

    /** Sizes known at compile time let the loops unroll. */
    template <unsigned int n>
    void
    subtract_square_product(double *target, const double *a, const double *b)
    {
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int j = 0; j < n; ++j)
            target[i * n + j] -= a[i * n + k] * b[k * n + j];
    }
  } // namespace

  bool factorize_definite_block(double            *a,
                                const unsigned int n,
                                const double       smallest)
  {
    for (unsigned int k = 0; k < n; ++k)
      {
        if (!(a[k * n + k] > smallest))
          return false;
        eliminate_below(a, n, k);
      }
    return true;
  }

  bool factorize_general_block(double            *a,
                               const unsigned int n,
                               int               *exchanges,
                               const double       smallest)
  {
    for (unsigned int k = 0; k < n; ++k)
      {
        unsigned int largest = k;
        for (unsigned int i = k + 1; i < n; ++i)
          if (std::abs(a[i * n + k]) > std::abs(a[largest * n + k]))
            largest = i;
        if (!(std::abs(a[largest * n + k]) > smallest))
          return false;
        exchanges[k] = static_cast<int>(largest);
        if (largest != k)
          std::swap_ranges(a + k * n, a + (k + 1) * n, a + largest * n);
        eliminate_below(a, n, k);
      }
    return true;
  }

  void solve_with_block(const double      *factors,
                        const int         *exchanges,
                        const unsigned int n,
                        double            *b,
                        const unsigned int m)
  {
    if (exchanges != nullptr)
      for (unsigned int k = 0; k < n; ++k)
        if (const unsigned int other = exchanges[k]; other != k)
          std::swap_ranges(b + k * m, b + (k + 1) * m, b + other * m);
    for (unsigned int i = 1; i < n; ++i)
      for (unsigned int k = 0; k < i; ++k)
        for (unsigned int j = 0; j < m; ++j)
          b[i * m + j] -= factors[i * n + k] * b[k * m + j];
    for (unsigned int i = n; i-- > 0;)
      {
        for (unsigned int k = i + 1; k < n; ++k)
          for (unsigned int j = 0; j < m; ++j)
            b[i * m + j] -= factors[i * n + k] * b[k * m + j];
        for (unsigned int j = 0; j < m; ++j)
          b[i * m + j] /= factors[i * n + i];
      }
  }

  void subtract_product(double            *target,
                        const double      *a,
                        const double      *b,
                        const unsigned int m1,
                        const unsigned int n,
                        const unsigned int m2)
  {
    if (m1 == n && m2 == n && n == 3)
      subtract_square_product<3>(target, a, b);
    else if (m1 == n && m2 == n && n == 6)
      subtract_square_product<6>(target, a, b);
    else
      for (unsigned int i = 0; i < m1; ++i)
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int j = 0; j < m2; ++j)
            target[i * m2 + j] -= a[i * n + k] * b[k * m2 + j];
  }

  void invert_root(double *a, const unsigned int n)
  {
    dealii::FullMatrix<double> root(n);
    root.cholesky(dealii::FullMatrix<double>(n, n, a));
    root.gauss_jordan();
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        a[i * n + j] = root(i, j);
  }

  unsigned int n_negative_eigenvalues(const double *a, const unsigned int n)
  {
    dealii::LAPACKFullMatrix<double> matrix(n);
    matrix.set_property(dealii::LAPACKSupport::symmetric);
    double bound = 0;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        {
          matrix(i, j) = (a[i * n + j] + a[j * n + i]) / 2;
          bound += std::abs(matrix(i, j));
        }
    dealii::Vector<double>     negative;
    dealii::FullMatrix<double> vectors;
    matrix.compute_eigenvalues_symmetric(-2 * bound, 0, 0, negative, vectors);
    return negative.size();
  }

  std::array<PrincipalAxis, 3>
  principal_axes(const dealii::Tensor<2, 3> &tensor)
  {
    // GCC and Clang mangle dealii::eigenvectors() differently, so the library's
    // symbol may be missing.
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
