#ifndef algebra_tpetra_types_h
#define algebra_tpetra_types_h

#include <auxfem/algebra/joint_order.h>

#include <Tpetra_CrsMatrix.hpp>

#include <optional>

// Types shared by few translation units: Tpetra's headers take seconds to
// compile.

namespace auxfem
{
  using TpetraMatrix   = Tpetra::CrsMatrix<double>;
  using TpetraVectors  = Tpetra::MultiVector<double>;
  using TpetraOperator = Tpetra::Operator<double>;
  using TpetraMap      = TpetraMatrix::map_type;

  /** Map of the first @p n local numbers of @p layout. */
  Teuchos::RCP<const TpetraMap> make_map(const UnknownLayout &layout,
                                         unsigned int         n);

  struct Multigrid
  {
    Teuchos::RCP<TpetraOperator> cycle;
    /**
     * Negative eigenvalues of the coarsest level, a lower bound for those of
     * the matrix; none if unknown. If there are none, the cycle is positive
     * definite.
     */
    std::optional<unsigned long> n_negative;
  };

  /**
   * Smoothed aggregation (MueLu) with the rigid-body modes of @p rows as near
   * null space and a direct solver on the coarsest level. Throws if that level
   * is singular. Collective.
   */
  Multigrid make_multigrid(const Teuchos::RCP<TpetraMatrix> &matrix,
                           const JointRows                  &rows,
                           bool                              is_symmetric);

  /**
   * ILU(1) (Ifpack2), with one layer of overlap between ranks. Throws on
   * breakdown.
   */
  Teuchos::RCP<TpetraOperator>
  make_incomplete_factorization(const Teuchos::RCP<TpetraMatrix> &matrix);
} // namespace auxfem

#endif
