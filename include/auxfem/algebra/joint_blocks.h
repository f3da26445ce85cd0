#ifndef auxfem_algebra_joint_blocks_h
#define auxfem_algebra_joint_blocks_h

#include <auxfem/model/lattice_model.h>

#include <Epetra_Map.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * The unknowns at joints in rows of equal blocks, one block a joint, as
   * multigrid wants them. What a joint does not have (the rotation of a
   * joint without struts) is a row that stands for nothing; rotations of
   * released ends that find no place in the joint's block are in further ones.
   * Unknowns inside struts have no row.
   */
  class JointBlocks
  {
  public:
    explicit JointBlocks(const LatticeModel &model);

    /** Rows a block: unknowns a node. */
    unsigned int size() const;

    /** The rows, block by block, those of a rank in one range. */
    const Epetra_Map &map() const;

    /** Global row of a local unknown; -1 if it lies inside a strut. */
    int row(unsigned int unknown) const;

    /** Local unknown of a row of this rank; -1 if it stands for nothing. */
    int unknown(unsigned int local_row) const;

    /** Strut that a local unknown lies inside of; invalid_index if none. */
    unsigned int strut(unsigned int unknown) const;

    /**
     * Motions of the lattice as a rigid body: the translations, then the
     * rotations about its middle (one in the plane, three in space), each over
     * the rows of this rank, rotations measured in @p length (m) times radian.
     * Zero in rows that are prescribed or stand for nothing.
     */
    std::vector<std::vector<double>> rigid_body_modes(double length) const;

  private:
    void find_inside_struts();
    void place_unknowns();
    /**
     * Puts an unknown of this rank that has no row yet into the first of the
     * joint's @p blocks where its place is free, or into a new one.
     */
    void place(int               unknown,
               unsigned int      component,
               unsigned int      joint,
               std::vector<int> &blocks);
    void share_rows();

    const DofNumbering         &numbering;
    const Lattice              &lattice;
    std::vector<unsigned int>   inside;
    std::vector<int>            rows;
    std::vector<int>            unknowns;
    std::vector<unsigned int>   joint_of_block;
    std::unique_ptr<Epetra_Map> row_map;
  };
} // namespace auxfem

#endif
