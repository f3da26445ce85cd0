#ifndef algebra_tpetra_types_h
#define algebra_tpetra_types_h

#include <auxfem/algebra/joint_order.h>

#include <Tpetra_CrsMatrix.hpp>

#include <optional>

// What the iterative solution shares among few translation units: the headers
// of Tpetra take seconds to compile.

namespace auxfem
{
  using TpetraMatrix   = Tpetra::CrsMatrix<double>;
  using TpetraVectors  = Tpetra::MultiVector<double>;
  using TpetraOperator = Tpetra::Operator<double>;
  using TpetraMap      = TpetraMatrix::map_type;

  /** The first @p n local numbers of @p layout. */
  Teuchos::RCP<const TpetraMap> make_map(const UnknownLayout &layout,
                                         unsigned int         n);

  struct Multigrid
  {
    Teuchos::RCP<TpetraOperator> cycle;
    /**
     * Negative eigenvalues of the coarsest level, of which the matrix has as
     * many at least; without any, the cycle is positive definite. Nothing where
     * they are not known.
     */
    std::optional<unsigned long> n_negative;
  };

  /**
   * Smoothed aggregation (MueLu) with the rigid-body motions of @p rows as near
   * null space and a direct solver on the coarsest level. Throws if that is
   * singular. Collective.
   */
  Multigrid make_multigrid(const Teuchos::RCP<TpetraMatrix> &matrix,
                           const JointRows                  &rows,
                           bool                              is_symmetric);

  /**
   * ILU(1) (Ifpack2), on several ranks with one layer of overlap. Throws if it
   * breaks down.
   */
  Teuchos::RCP<TpetraOperator>
  make_incomplete_factorization(const Teuchos::RCP<TpetraMatrix> &matrix);
} // namespace auxfem

#endif
