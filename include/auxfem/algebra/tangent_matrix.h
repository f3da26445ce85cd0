#ifndef auxfem_algebra_tangent_matrix_h
#define auxfem_algebra_tangent_matrix_h

#include <auxfem/algebra/unknowns.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace auxfem
{
  /**
   * Which unknowns act on each other: dense blocks on the unknowns that effects
   * register. It may change between steps; its version then changes too.
   *
   * The blocks of a strut's elements can be condensed if they are registered
   * one after the other along it, each on the unknowns of its first node, of
   * its last one, and then of those between (see StrutCondensation).
   */
  class TangentPattern
  {
  public:
    /** @param unknowns must outlive the object. */
    explicit TangentPattern(const Unknowns &unknowns);

    /**
     * Announces a dense block on @p n local unknowns (entries -1: not there).
     * A block is announced on all ranks that own one of its unknowns. Returns
     * its number; blocks are numbered in the order in which they come.
     */
    std::size_t register_block(const int *unknowns, unsigned int n);

    /**
     * Announces a block for each of @p items, on the array of unknowns that
     * @p unknowns_of (a member or a function) gives of it. Returns the number of
     * the first.
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

    /** No blocks; @p unknowns must outlive the object. */
    void reset(const Unknowns &unknowns);

    /** A number that grows with every change. */
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

  /** How the equations of a matrix A are to be solved. */
  enum class Symmetry
  {
    given,    ///< A is symmetric (to round-off)
    enforced, ///< its symmetric part (A + A^T)/2 takes its place
    none
  };

  /**
   * The tangent (or mass) matrix, not assembled: the dense values of every
   * block of a pattern, one after the other, so adding a block is a plain sum.
   * The matrix is the sum of its blocks; on each rank the owned rows are
   * complete.
   *
   * Rows of prescribed unknowns are identity rows; their columns are kept, so
   * that a prescribed increment on the right-hand side moves the rest along.
   */
  class TangentMatrix
  {
  public:
    /** @param pattern must outlive the object. */
    explicit TangentMatrix(const TangentPattern &pattern);

    /**
     * All entries zero, identity in prescribed rows; with the blocks of the
     * pattern as it is now. Until then the matrix must not be used if the
     * pattern has changed.
     */
    void reset();

    /** Lets go of the memory of the entries; until reset() there are none. */
    void release();

    /** Not between release() and reset(). */
    bool has_entries() const
    {
      return !first.empty();
    }

    /** Adds the row-major block @p values to block @p block. */
    void add(std::size_t block, const double *values);

    /** Adds @p factor times @p other, which has the same pattern. */
    void add_multiple(double factor, const TangentMatrix &other);

    const TangentPattern &pattern() const
    {
      return tangent_pattern;
    }

    /** Version of the pattern that the matrix has. */
    unsigned long version() const
    {
      return built_version;
    }

    /** The row-major values of a block. */
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

    /** Takes the transpose of what is between free unknowns. */
    void transpose();

    /** Takes the symmetric part (A + A^T)/2 of each block. */
    void take_symmetric_part();

    /**
     * Adds @p values, one value for each owned row, to the diagonal of free
     * rows, until the next reset().
     */
    void add_to_diagonal(const std::vector<double> &values);

    /** What was added by add_to_diagonal(), zero in prescribed rows; empty if
     * nothing was. */
    const std::vector<double> &added_diagonal() const
    {
      return further_diagonal;
    }

    /** The diagonal of the owned rows; 1 if prescribed. */
    std::vector<double> diagonal() const;

    /** As add_to_diagonal(), so that diagonal() becomes @p values. */
    void set_diagonal(const std::vector<double> &values);

    /**
     * Size of each owned row: the largest |entry| of its blocks and its
     * diagonal; zero for a row that nothing has been added to.
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
     * @p y = the sum of all blocks and the added diagonal times x in owned
     * rows, those of prescribed unknowns too: forces of supports, say.
     * @param x, symmetry as for multiply()
     */
    void multiply_blocks(const double *x,
                         double       *y,
                         Symmetry      symmetry = Symmetry::none) const;

    /** An asymmetry() below this is the round-off of sums of symmetric terms.
     */
    static constexpr double symmetric_to_round_off = 1e-13;

    /**
     * |B - B^T| / |B| over all blocks B, in Frobenius' norm of their free rows
     * and columns; rotations are measured in Unknowns::length times radian.
     * Zero for no entries. Collective.
     */
    double asymmetry() const;

    /**
     * Whether the matrix is symmetric as a whole to round-off. Its blocks need
     * not be: those of struts in space are not, but where moments at joints
     * balance, what they lack cancels. Collective.
     */
    bool is_symmetric() const;

  private:
    /** As asymmetry(), of the sum of all blocks; estimated with a vector. */
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
