#ifndef auxfem_algebra_tangent_matrix_h
#define auxfem_algebra_tangent_matrix_h

#include <auxfem/algebra/unknowns.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace auxfem
{
  /**
   * Coupling of unknowns: dense blocks registered by the effects. It may change
   * between steps; its version then changes too. To be condensed, blocks of a
   * strut's elements are registered consecutively along it. Each lists its
   * first node, its last node, then those between (see StrutCondensation).
   */
  class TangentPattern
  {
  public:
    /** @param unknowns must outlive the object. */
    explicit TangentPattern(const Unknowns &unknowns);

    /**
     * Registers a dense block on @p n local unknowns (-1 for none), on all
     * ranks that own one of them. Returns its number; numbers are consecutive.
     */
    std::size_t register_block(const int *unknowns, unsigned int n);

    /**
     * Registers a block for each of @p items on the unknowns that @p
     * unknowns_of (a member or a function) returns for it. Returns the number
     * of the first block.
     */
    template <class Items, class UnknownsOf>
    std::size_t register_blocks(const Items      &items,
                                const UnknownsOf &unknowns_of)
    {
      const std::size_t first_of_items = n_blocks();
      for (const auto &item : items)
        {
          const auto &unknowns = std::invoke(unknowns_of, item);
          register_block(std::data(unknowns), std::size(unknowns));
        }
      return first_of_items;
    }

    /** Removes all blocks; @p unknowns must outlive the object. */
    void reset(const Unknowns &unknowns);

    /** Increases with every change. */
    unsigned long version() const
    {
      return changes;
    }

    const Unknowns &unknowns() const
    {
      return *all;
    }

    std::size_t n_blocks() const
    {
      return first.size() - 1;
    }

    /** Begin and end of the unknowns of a block. */
    ///@{
    const int *begin(const std::size_t block) const
    {
      return block_unknowns.data() + first[block];
    }

    const int *end(const std::size_t block) const
    {
      return block_unknowns.data() + first[block + 1];
    }
    ///@}

    /** Number of unknowns of a block. */
    unsigned int size(const std::size_t block) const
    {
      return first[block + 1] - first[block];
    }

  private:
    const Unknowns          *all;
    std::vector<int>         block_unknowns;
    std::vector<std::size_t> first; ///< of each block, and the end of the last
    unsigned long            changes = 0;
  };

  /** Symmetry of a matrix A in a solution. */
  enum class Symmetry
  {
    given,    ///< A is symmetric (to round-off)
    enforced, ///< its symmetric part (A + A^T)/2 is used instead
    none
  };

  /**
   * Tangent (or mass) matrix, not assembled: the dense values of all blocks of
   * a pattern. The matrix is the sum of its blocks; on each rank the owned rows
   * are complete. Rows of prescribed unknowns are identity rows; their columns
   * are kept, so that prescribed increments on the right-hand side act on the
   * free unknowns.
   */
  class TangentMatrix
  {
  public:
    /** @param pattern must outlive the object. */
    explicit TangentMatrix(const TangentPattern &pattern);

    /**
     * Sets all entries to zero and prescribed rows to identity rows, for the
     * present blocks of the pattern. Required after each change of the pattern.
     */
    void reset();

    /** Frees the entries until the next reset(). */
    void release();

    /** False between release() and reset(). */
    bool has_entries() const
    {
      return !first.empty();
    }

    /** Adds the row-major @p values to block @p block. */
    void add(std::size_t block, const double *values);

    /** Adds @p factor times @p other, which has the same pattern. */
    void add_multiple(double factor, const TangentMatrix &other);

    const TangentPattern &pattern() const
    {
      return tangent_pattern;
    }

    /** Pattern version of the matrix. */
    unsigned long version() const
    {
      return built_version;
    }

    /** Row-major values of a block. */
    const double *values(const std::size_t block) const
    {
      return entries.data() + first[block];
    }

    /** Replaces the values of a block. */
    void set(const std::size_t block, const double *values)
    {
      std::copy(values,
                values + (first[block + 1] - first[block]),
                entries.begin() + first[block]);
    }

    /** Transposes the part of free unknowns. */
    void transpose();

    /** Replaces each block by its symmetric part (A + A^T)/2. */
    void symmetrize_blocks();

    /**
     * Adds @p values of the owned rows to the diagonal of free rows, until the
     * next reset().
     */
    void add_to_diagonal(const std::vector<double> &values);

    /**
     * Sum of add_to_diagonal(), zero in prescribed rows; empty if nothing was
     * added.
     */
    const std::vector<double> &added_diagonal() const
    {
      return further_diagonal;
    }

    /** Diagonal of the owned rows; 1 if prescribed. */
    std::vector<double> diagonal() const;

    /** As add_to_diagonal(), so that diagonal() becomes @p values. */
    void set_diagonal(const std::vector<double> &values);

    /**
     * Size of each owned row: the largest |entry| of its blocks and its
     * diagonal; zero for an empty row.
     */
    std::vector<double> row_sizes() const;

    /**
     * @p y = A x in owned rows.
     * @param x values at local unknowns, ghosts up to date
     * @param symmetry with `enforced` the free rows and columns are those of
     *   the symmetric part; prescribed columns stay as they are.
     */
    void multiply(const double *x,
                  double       *y,
                  Symmetry      symmetry = Symmetry::none) const;

    /**
     * @p y = (sum of all blocks and the added diagonal) x in owned rows,
     *   prescribed ones included, e.g. for forces of supports.
     * @param x, symmetry as for multiply()
     */
    void multiply_blocks(const double *x,
                         double       *y,
                         Symmetry      symmetry = Symmetry::none) const;

    /** An asymmetry() below this is round-off of symmetric terms. */
    static constexpr double symmetric_to_round_off = 1e-13;

    /**
     * |B - B^T| / |B| over all blocks B, in Frobenius' norm of their free rows
     * and columns; rotations are measured in Unknowns::length times radian.
     * Zero for no entries. Collective.
     */
    double asymmetry() const;

    /**
     * Whether the sum of the blocks is symmetric to round-off. Blocks of struts
     * in space are not, but their skew parts cancel where moments at joints
     * balance. Collective.
     */
    bool is_symmetric() const;

  private:
    /**
     * As asymmetry() for the sum of all blocks; estimated by a product with one
     * vector.
     */
    double asymmetry_of_sum() const;

    template <class Action>
    void for_each_block(const Action &action) const;

    const TangentPattern    &tangent_pattern;
    unsigned long            built_version = 0;
    std::vector<std::size_t> first; ///< of each block, and the end of the last
    std::vector<double>      entries;
    std::vector<double>      further_diagonal;
  };
} // namespace auxfem

#endif
