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

  /**
   * Distance below which two joints of different cells are one (m): far above
   * round-off of the cell centres, far below any strut.
   */
  double joint_tolerance(const UnitCell &cell);

  /** A joint of a cell made before another: where one of the other lies, too.
   */
  struct EarlierJoint
  {
    std::array<int, 3> offset; ///< from the other cell, in cells
    unsigned int       joint;  ///< of the cell
  };

  /**
   * Of each joint of @p cell all in whose place it lies in an array of
   * @p n_cells cells that are made along x first, then y and z.
   */
  std::vector<std::vector<EarlierJoint>>
  find_earlier_joints(const UnitCell                    &cell,
                      const std::array<unsigned int, 3> &n_cells);

  /** Names of joints and struts of a cell, by their number, for messages. */
  struct CellNames
  {
    std::function<std::string(unsigned int)> joint, strut;
  };

  /** `Merge distance`, of cells that the user gives joint by joint. */
  const Quantity &merge_distance();

  /**
   * Makes joints that lie nearer than @p distance (m) to one with a smaller
   * number one with it. Struts that have no length then, and those that repeat
   * another one, go; their sets stay. A distance of 0 merges nothing, and
   * joints that lie within round-off of each other are only told of. What was
   * found is in the notes of @p cell, which must not have pairs. Throws InputError if no
   * strut is left.
   */
  void merge_joints(double           distance,
                    const CellNames &names,
                    unsigned int     dimension,
                    UnitCell        &cell);
} // namespace auxfem

#endif
