#ifndef auxfem_algebra_dense_block_h
#define auxfem_algebra_dense_block_h

#include <deal.II/base/tensor.h>

#include <array>

/**
 * @file
 * Small dense blocks, stored row by row, for the pivots of block eliminations.
 * With three or six rows these loops are faster than calls of LAPACK.
 */
namespace auxfem
{
  /**
   * Factorizes the block @p a of size @p n in place, a = L U with a unit
   * diagonal of L, without row exchanges: positive definite blocks need none.
   * Returns false, with @p a destroyed, if a pivot is not larger than @p
   * smallest.
   */
  bool factorize_definite_block(double *a, unsigned int n, double smallest);

  /**
   * As factorize_definite_block() for any regular block, with the largest entry
   * of a column as pivot.
   * @param exchanges result, row exchanges of the n pivots
   * @param smallest pivots must be larger in size
   */
  bool factorize_general_block(double      *a,
                               unsigned int n,
                               int         *exchanges,
                               double       smallest);

  /**
   * Solves with these factors for the @p m columns of @p b, in place.
   * @param exchanges nullptr for a definite block
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

  /**
   * Replaces the positive definite block @p a by L^-1, where a = L L^T and L is
   * lower triangular.
   */
  void invert_root(double *a, unsigned int n);

  /** Number of negative eigenvalues of the symmetric block @p a. */
  unsigned int n_negative_eigenvalues(const double *a, unsigned int n);

  struct PrincipalAxis
  {
    double               value;
    dealii::Tensor<1, 3> direction; ///< of length one
  };

  /**
   * Eigenvalues and eigenvectors of a positive semidefinite @p tensor, the
   * largest eigenvalue first.
   */
  std::array<PrincipalAxis, 3>
  principal_axes(const dealii::Tensor<2, 3> &tensor);
} // namespace auxfem

#endif
