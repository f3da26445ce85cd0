#ifndef auxfem_mesh_lattice_definition_h
#define auxfem_mesh_lattice_definition_h

#include <auxfem/mesh/array_changes.h>
#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <memory>
#include <string>

namespace auxfem
{
  /** Parameter `Joints` where it must be given. */
  inline const Text set_of_joints = {"Joints", "", "Set of joints.", true};

  /** `Sets/NAME`: the user's own set of joints or struts. */
  struct SetDefinition
  {
    std::string name;
    /** `joints: ...` or `struts: ...` as written; grammar in mesh/sets.h. */
    std::string selection;
    std::string path; ///< for messages
  };

  /** Schema of `Sets`. */
  SubsectionSchema sets_schema();

  /** Reads one entry `Sets/NAME`. */
  SetDefinition read_set(ParameterValues &values);

  /** `Lattice`: the array of unit cells. */
  struct LatticeDefinition
  {
    std::shared_ptr<const Cell> cell;
    std::array<unsigned int, 3> n_cells = {{1, 1, 1}};
    ArrayChanges                changes;
    /** Whether struts may pass through each other. */
    bool struts_may_cross = false;
    /** Whether the array is one period of an infinite lattice. */
    bool is_infinite = false;
  };

  /** Schema of `Lattice`. */
  SubsectionSchema lattice_schema();

  /** Reads `Lattice`. Throws InputError if values contradict each other. */
  LatticeDefinition read_lattice(ParameterValues &values);
} // namespace auxfem

#endif
