#ifndef auxfem_mesh_merge_joints_h
#define auxfem_mesh_merge_joints_h

#include <auxfem/mesh/cell.h>

#include <functional>
#include <utility>

namespace auxfem
{
  /** Lowest and highest coordinate of @p joints along x, y or z (m). */
  std::pair<double, double>
  coordinate_range(const std::vector<dealii::Point<3>> &joints, unsigned int d);

  /** Distance below which two joints of different cells are one (m): far above
   * the round-off of cell centres, far below any strut length. */
  double joint_tolerance(const UnitCell &cell);

  /** A joint of a cell that is made earlier than another cell and has a joint
   * in the same place. */
  struct EarlierJoint
  {
    std::array<int, 3> offset; ///< of the earlier cell from the other, in cells
    unsigned int       joint;  ///< joint number in the earlier cell
  };

  /**
   * For each joint of @p cell, the coincident joints of earlier cells in an
   * array of @p n_cells cells. Cells are made along x first, then y and z.
   */
  std::vector<std::vector<EarlierJoint>>
  find_earlier_joints(const UnitCell                    &cell,
                      const std::array<unsigned int, 3> &n_cells);

  /** For each joint the first one within @p distance (m), maybe itself. */
  std::vector<unsigned int>
  first_joints_within(double                               distance,
                      const std::vector<dealii::Point<3>> &joints);

  /** Names of joints and struts of a cell for messages, by their number. */
  struct CellNames
  {
    std::function<std::string(unsigned int)> joint, strut;
  };

  /** Parameter `Merge distance` of cells that the user gives joint by joint. */
  const Quantity &merge_distance();

  /**
   * Merges each joint with the first one nearer than @p distance (m). Struts
   * without length are removed; repeated struts are united, with their sets.
   * With distance 0 coincident joints are only reported. Adds the results to
   * the notes of @p cell, which must have no pairs. Throws InputError if no
   * strut remains.
   */
  void merge_joints(double           distance,
                    const CellNames &names,
                    unsigned int     dimension,
                    UnitCell        &cell);
} // namespace auxfem

#endif
