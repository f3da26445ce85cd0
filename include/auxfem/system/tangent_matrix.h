#ifndef auxfem_system_tangent_matrix_h
#define auxfem_system_tangent_matrix_h

#include <auxfem/model/numbering.h>

#include <Epetra_CrsMatrix.h>

namespace auxfem
{
  /**
   * The tangent (or mass) matrix: an Epetra matrix of this rank's rows whose
   * pattern is known from registered blocks. Each block remembers where its
   * entries lie, so adding a block is a plain scatter.
   *
   * Rows of prescribed unknowns are identity rows; their columns are kept, so
   * that a prescribed increment on the right-hand side moves the rest along.
   */
  class TangentMatrix
  {
  public:
    /** Registers block e on the unknowns of each element e of @p numbering. */
    explicit TangentMatrix(const DofNumbering &numbering);

    /**
     * Announces a dense block on @p n local unknowns (entries -1: not there).
     * Returns its number; blocks of one effect are numbered consecutively.
     */
    std::size_t register_block(const int *unknowns, unsigned int n);

    /** Makes the pattern. No block can be registered afterwards. */
    void finalize();

    /** All entries zero, identity in prescribed rows. */
    void reset();

    /** Adds the row-major block @p values to the entries of block @p block. */
    void add(std::size_t block, const double *values)
    {
      const std::size_t begin = block_begin[block],
                        end   = block_begin[block + 1];
      for (std::size_t i = begin; i < end; ++i)
        if (positions[i] >= 0)
          entries[positions[i]] += values[i - begin];
    }

    const Epetra_CrsMatrix &matrix() const;
    Epetra_CrsMatrix       &matrix();

    /** Largest |entry| of each owned row. */
    std::vector<double> row_sizes() const;

  private:
    const DofNumbering &numbering;

    /** Unknowns of all blocks; emptied by finalize(). */
    std::vector<int>         block_unknowns;
    std::vector<std::size_t> unknowns_begin;

    std::vector<std::size_t> block_begin;
    /**
     * Index into `entries` for each block entry; -1: row of another rank or
     * prescribed.
     */
    std::vector<int> positions;

    std::unique_ptr<Epetra_CrsMatrix> crs;
    double                           *entries   = nullptr;
    int                               n_entries = 0;
    std::vector<int>                  identity_positions;
  };
} // namespace auxfem

#endif
