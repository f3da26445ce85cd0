#ifndef auxfem_system_tangent_matrix_h
#define auxfem_system_tangent_matrix_h

#include <auxfem/dofs/numbering.h>

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

    /**
     * Makes the pattern. No block can be registered afterwards. Throws
     * InputError if the rows of a rank have more entries than an int can count.
     */
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
    /** A row of a block. */
    struct BlockRow
    {
      unsigned int block;
      unsigned int row;
    };

    /** The rows of blocks that are added to each owned row of the matrix. */
    class BlockRows
    {
    public:
      explicit BlockRows(const TangentMatrix &matrix);

      const BlockRow *begin(const unsigned int owned) const
      {
        return rows.data() + begins[owned];
      }

      const BlockRow *end(const unsigned int owned) const
      {
        return rows.data() + begins[owned + 1];
      }

    private:
      std::vector<std::size_t> begins;
      std::vector<BlockRow>    rows;
    };

    void make_matrix(const BlockRows &blocks);
    void find_positions(const BlockRows &blocks);

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
