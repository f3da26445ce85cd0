#ifndef auxfem_mesh_merge_joints_h
#define auxfem_mesh_merge_joints_h

#include <auxfem/mesh/cell.h>

#include <functional>

namespace auxfem
{
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
