#ifndef auxfem_algebra_joint_rows_h
#define auxfem_algebra_joint_rows_h

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
    /** Takes the owned @p unknowns that are numbered in @p taken. */
    JointRows(const Unknowns &all, const std::vector<int> &taken);

    /** Rows a block: components of motion a node has. */
    unsigned int block_size() const;

    /** The rows; ghosts are those of the unknowns' own ghosts. */
    const UnknownLayout &layout() const
    {
      return *row_layout;
    }

    /** Row of a local unknown; none if it was not taken. */
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
} // namespace auxfem

#endif
