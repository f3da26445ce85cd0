#ifndef auxfem_algebra_tangent_matrix_h
#define auxfem_algebra_tangent_matrix_h

#include <auxfem/model/numbering.h>

#include <Epetra_CrsMatrix.h>

namespace auxfem
{
  /**
   * Which unknowns act on each other: dense blocks on the unknowns of each
   * element and on those that effects register. It may change between steps;
   * its version then changes too.
   */
  class TangentPattern
  {
  public:
    /** Registers block e on the unknowns of each element e of @p numbering. */
    explicit TangentPattern(const DofNumbering &numbering);

    /**
     * Announces a dense block on @p n local unknowns (entries -1: not there).
     * Returns its number; blocks of one effect are numbered consecutively.
     */
    std::size_t register_block(const int *unknowns, unsigned int n);

    /** Back to the blocks of elements. */
    void clear();

    /** A number that grows with every change. */
    unsigned long version() const;

    const DofNumbering &numbering() const;

    std::size_t n_blocks() const;

    /** Begin and end of the unknowns of a block. */
    ///@{
    const int *begin(std::size_t block) const;
    const int *end(std::size_t block) const;
    ///@}

  private:
    const DofNumbering      &dofs;
    std::vector<int>         unknowns;
    std::vector<std::size_t> first; ///< of each block, and the end of the last
    unsigned long            changes = 0;
  };

  /**
   * The tangent (or mass) matrix: an Epetra matrix of this rank's rows with the
   * pattern of registered blocks. Each block remembers where its entries lie,
   * so adding a block is a plain scatter.
   *
   * Rows of prescribed unknowns are identity rows; their columns are kept, so
   * that a prescribed increment on the right-hand side moves the rest along.
   */
  class TangentMatrix
  {
  public:
    /**
     * Throws InputError if the rows of a rank have more entries than an int can
     * count.
     * @param pattern must outlive the object.
     */
    explicit TangentMatrix(const TangentPattern &pattern);

    /**
     * All entries zero, identity in prescribed rows; where the pattern has
     * changed since the last time, a new matrix with the new pattern.
     */
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

    /** Version of the pattern that matrix() has. */
    unsigned long version() const;

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
      explicit BlockRows(const TangentPattern &pattern);

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

    void rebuild();
    void make_matrix(const BlockRows &blocks);
    void find_positions(const BlockRows &blocks);


    const TangentPattern &pattern;
    unsigned long         built_version = 0;

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
