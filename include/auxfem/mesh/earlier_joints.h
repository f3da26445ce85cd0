#ifndef auxfem_mesh_earlier_joints_h
#define auxfem_mesh_earlier_joints_h

#include <auxfem/mesh/cell.h>

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
} // namespace auxfem

#endif
