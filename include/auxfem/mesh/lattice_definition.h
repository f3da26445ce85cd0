#ifndef auxfem_mesh_lattice_definition_h
#define auxfem_mesh_lattice_definition_h

#include <auxfem/mesh/cell.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <memory>
#include <string>

namespace auxfem
{
  /** The joints of a group that has to name some. */
  inline const Text set_of_joints = {"Joints", "", "Set of joints.", true};

  /**
   * `Sets/NAME`: the user's own set of joints or struts, resolved on the
   * lattice.
   */
  struct SetDefinition
  {
    std::string name;
    /**
     * `joints: ...` or `struts: ...` as written; see mesh/sets.h for the
     * grammar.
     */
    std::string selection;
    std::string path; ///< for messages
  };

  /** `Sets`. */
  SubsectionSchema sets_schema();

  /** The values of one such subsection. */
  SetDefinition read_set(ParameterValues &values);

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
