#ifndef auxfem_algebra_joint_order_h
#define auxfem_algebra_joint_order_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <optional>

namespace auxfem
{
  /**
   * Rows of equal blocks, one block per joint, as multigrid requires. Motions
   * that a joint lacks (a rotation without struts, a prescribed motion) leave
   * unused rows. Rotations of released ends beyond a joint's block go to
   * additional blocks.
   */
  class JointRows
  {
  public:
    /** Numbers the owned unknowns @p selected. */
    JointRows(const Unknowns &all, const std::vector<int> &selected);

    /** Rows of a block: components of motion of a node. */
    unsigned int block_size() const;

    /** Layout of the rows; its ghosts correspond to those of the unknowns. */
    const UnknownLayout &layout() const
    {
      return *row_layout;
    }

    /** Row of a local unknown; none if it was not selected. */
    std::optional<unsigned int> row(const unsigned int unknown) const
    {
      return rows[unknown];
    }

    /** Unknown of an owned row; none if the row is unused. */
    std::optional<unsigned int> unknown(const unsigned int row) const
    {
      return unknown_of_row[row];
    }

    /**
     * Rigid-body modes over the owned rows: translations, then rotations about
     * the middle (one in the plane, three in space), with rotations times
     * Unknowns::length. Zero in unused and prescribed rows.
     */
    std::vector<std::vector<double>> rigid_body_modes() const;

  private:
    void add(unsigned int unknown, std::vector<unsigned int> &blocks);
    void share();

    const Unknowns                          &unknowns;
    std::vector<std::optional<unsigned int>> rows;
    std::vector<std::optional<unsigned int>> unknown_of_row;
    std::vector<unsigned int>                joint_of_block;
    std::unique_ptr<UnknownLayout>           row_layout;
  };

  /**
   * This rank's rows that are not prescribed, grouped by joint; a group is one
   * pivot block.
   */
  struct JointGroups
  {
    explicit JointGroups(const Unknowns &unknowns);

    /** Group of an owned row; none for prescribed rows. */
    std::vector<std::optional<unsigned int>> group;
    /** Index of an owned row in its group. */
    std::vector<unsigned int> number;
    /** Rows of each group. */
    std::vector<std::vector<int>> rows;
  };

  /**
   * Elimination order of groups by minimum degree (Rose 1972), from the pattern
   * alone, and the storage of fill-in blocks. Eliminating a group couples all
   * its neighbours, so groups with few neighbours come first.
   */
  class JointOrder
  {
  public:
    /** A coupled group and the position of the first entry of the block. */
    struct Link
    {
      unsigned int group;
      std::size_t  block;
    };

    /** A group to eliminate and its couplings at that stage. */
    struct Pivot
    {
      unsigned int group;
      std::size_t  block;
      /**
       * Blocks (pivot, neighbour), and (neighbour, pivot) in the same order.
       */
      std::vector<Link> right, left;
      /** Blocks (neighbour, neighbour), row by row. */
      std::vector<std::size_t> between;
    };

    /**
     * Eliminates groups with at most @p max_neighbours; those coupled with rows
     * of other ranks remain.
     */
    JointOrder(const SparseMatrix &matrix,
               const JointGroups  &groups,
               const Unknowns     &unknowns,
               unsigned int        max_neighbours);

    const std::vector<Pivot> &pivots() const
    {
      return order;
    }

    /** Number of entries of all blocks, stored row by row. */
    std::size_t n_entries() const
    {
      return n_used;
    }

    /**
     * Position of the block (@p row, @p column) of two groups that the matrix
     * itself couples.
     */
    std::size_t initial_block(unsigned int row, unsigned int column) const;

    /** Remaining groups; links() gives the blocks of their rows. */
    const std::vector<unsigned int> &remaining() const
    {
      return remaining_groups;
    }

    const std::vector<Link> &links(const unsigned int group) const
    {
      return adjacent[group];
    }

    /** Memory of the order (bytes). */
    std::size_t memory() const;

  private:
    void connect(const SparseMatrix &matrix, const Unknowns &unknowns);
    void eliminate_groups(std::size_t max_neighbours);
    void eliminate(unsigned int group);
    /** The block (row, column), created if it does not exist. */
    std::size_t block(unsigned int row, unsigned int column);

    const JointGroups &groups;
    /** Links of every group, itself included, before and during elimination. */
    std::vector<std::vector<Link>> initial_links, adjacent;
    std::vector<bool>              is_eliminated, must_stay;
    std::vector<Pivot>             order;
    std::vector<unsigned int>      remaining_groups;
    std::size_t                    n_used = 0;
  };
} // namespace auxfem

#endif
