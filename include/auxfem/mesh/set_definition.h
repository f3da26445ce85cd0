#ifndef auxfem_mesh_set_definition_h
#define auxfem_mesh_set_definition_h

#include <auxfem/parameters/subsection_schema.h>

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
} // namespace auxfem

#endif
