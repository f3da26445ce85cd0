#ifndef auxfem_algebra_dense_block_h
#define auxfem_algebra_dense_block_h

#include <deal.II/base/tensor.h>

#include <array>

/**
 * @file
 * Small dense blocks, stored row by row. Factors of three or six rows, as
 * pivots of a block elimination, are done before LAPACK has looked at its
 * arguments.
 */
namespace auxfem
{
  /**
   * Factors in place a = L U of the block @p a of size @p n, L with ones on its
   * diagonal, without exchanges of rows, which positive definite blocks can do
   * without. Returns false if a pivot is not larger than @p smallest; @p a is
   * then destroyed.
   */
  bool factorize_definite_block(double *a, unsigned int n, double smallest);

  /**
   * As above for any regular block, with the largest entry of a column as
   * pivot; false if that is not larger than @p smallest in size.
   * @param exchanges room for the n rows that the pivots came from
   */
  bool factorize_general_block(double      *a,
                               unsigned int n,
                               int         *exchanges,
                               double       smallest);

  /**
   * Solves with such factors for the @p m columns of @p b, in place.
   * @param exchanges nullptr for those of a definite block
   */
  void solve_with_block(const double *factors,
                        const int    *exchanges,
                        unsigned int  n,
                        double       *b,
                        unsigned int  m);

  /** @p target (m1 x m2) -= @p a (m1 x n) times @p b (n x m2). */
  void subtract_product(double       *target,
                        const double *a,
                        const double *b,
                        unsigned int  m1,
                        unsigned int  n,
                        unsigned int  m2);

  /** Puts L^-1, with L L^T = a and L a lower triangle, in place of the positive
   * definite block @p a. */
  void invert_root(double *a, unsigned int n);

  /** Number of negative eigenvalues of the symmetric block @p a. */
  unsigned int n_negative_eigenvalues(const double *a, unsigned int n);

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
