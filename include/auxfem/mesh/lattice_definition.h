#ifndef auxfem_mesh_lattice_definition_h
#define auxfem_mesh_lattice_definition_h

#include <auxfem/mesh/cell.h>

#include <array>
#include <memory>

namespace auxfem
{
  /** `Lattice`: the array of unit cells. */
  struct LatticeDefinition
  {
    std::shared_ptr<const Cell> cell;
    std::array<unsigned int, 3> n_cells = {{1, 1, 1}};
    /** Nothing is wrong with struts that pass through each other. */
    bool struts_may_cross = false;
  };

  /** `Lattice`. */
  SubsectionSchema lattice_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  LatticeDefinition read_lattice(ParameterValues &values);
} // namespace auxfem

#endif
