#ifndef auxfem_algebra_joint_order_h
#define auxfem_algebra_joint_order_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <optional>

namespace auxfem
{
  /**
   * Unknowns at joints in rows of equal blocks, one block a joint, as multigrid
   * wants them. What a joint does not have (a rotation without struts, what is
   * prescribed) is a row that stands for nothing; rotations of released ends
   * that find no place in the joint's block are in further ones.
   */
  class JointRows
  {
  public:
    /** Takes the owned @p unknowns that are numbered in @p selected. */
    JointRows(const Unknowns &all, const std::vector<int> &selected);

    /** Rows a block: components of motion a node has. */
    unsigned int block_size() const;

    /** The rows; ghosts are those of the unknowns' own ghosts. */
    const UnknownLayout &layout() const
    {
      return *row_layout;
    }

    /** Row of a local unknown; none if it was not selected. */
    std::optional<unsigned int> row(const unsigned int unknown) const
    {
      return rows[unknown];
    }

    /** Unknown of an owned row; none if the row stands for nothing. */
    std::optional<unsigned int> unknown(const unsigned int row) const
    {
      return unknown_of_row[row];
    }

    /**
     * Motions of the lattice as a rigid body: the translations, then the
     * rotations about its middle (one in the plane, three in space), over the
     * owned rows, rotations measured in Unknowns::length times radian. Zero in
     * rows that stand for nothing or for what is prescribed.
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

  /** The rows of this rank that are not prescribed, in one group a joint, which
   * is eliminated as one pivot block. */
  struct JointGroups
  {
    explicit JointGroups(const Unknowns &unknowns);

    /** Group of an owned row; none of prescribed ones. */
    std::vector<std::optional<unsigned int>> group;
    /** Number of an owned row in its group. */
    std::vector<unsigned int> number;
    /** By group, its rows. */
    std::vector<std::vector<int>> rows;
  };

  /**
   * The order in which groups of rows are eliminated, found from the pattern
   * alone, and where the blocks that come into being are kept. Eliminating a
   * group couples all its neighbours with each other; so the one with the
   * fewest comes first (minimum degree; Rose 1972).
   */
  class JointOrder
  {
  public:
    /** A group that another acts on, and the first entry of the block. */
    struct Link
    {
      unsigned int group;
      std::size_t  block;
    };

    /** A group to eliminate; with what it is coupled at that time. */
    struct Pivot
    {
      unsigned int group;
      std::size_t  block;
      /** Blocks (pivot, neighbour), and of the same neighbours (., pivot). */
      std::vector<Link> right, left;
      /** Blocks (neighbour, neighbour), row by row. */
      std::vector<std::size_t> between;
    };

    /** Takes groups while they have at most @p max_neighbours; those coupled
     * with rows of other ranks stay. */
    JointOrder(const SparseMatrix &matrix,
               const JointGroups  &groups,
               const Unknowns     &unknowns,
               unsigned int        max_neighbours);

    const std::vector<Pivot> &pivots() const
    {
      return order;
    }

    /** Entries of all blocks, row by row in each. */
    std::size_t n_entries() const
    {
      return n_used;
    }

    /** First entry of the block (@p row, @p column) of two groups that the
     * matrix itself couples. */
    std::size_t initial_block(unsigned int row, unsigned int column) const;

    /** Groups that stay, and the blocks of their rows, in order of groups. */
    const std::vector<unsigned int> &remaining() const
    {
      return remaining_groups;
    }

    const std::vector<Link> &links(const unsigned int group) const
    {
      return adjacent[group];
    }

    /** Memory of all this (bytes). */
    std::size_t memory() const;

  private:
    void connect(const SparseMatrix &matrix, const Unknowns &unknowns);
    void eliminate_groups(std::size_t max_neighbours);
    void eliminate(unsigned int group);
    /** The block (row, column), a new one if there is none yet. */
    std::size_t block(unsigned int row, unsigned int column);

    const JointGroups &groups;
    /** Of every group, itself included, before and during elimination. */
    std::vector<std::vector<Link>> initial_links, adjacent;
    std::vector<bool>              is_eliminated, must_stay;
    std::vector<Pivot>             order;
    std::vector<unsigned int>      remaining_groups;
    std::size_t                    n_used = 0;
  };
} // namespace auxfem

#endif
