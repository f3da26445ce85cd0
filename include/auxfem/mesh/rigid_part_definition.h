#ifndef auxfem_mesh_rigid_part_definition_h
#define auxfem_mesh_rigid_part_definition_h

#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/tensor.h>

#include <optional>
#include <string>

namespace auxfem
{
  /** `Rigid parts/NAME`: struts or joints that move as rigid bodies. */
  struct RigidPartDefinition
  {
    std::string name;
    /** Strut set; empty if the part is made of joints. */
    std::string struts;
    /** Joint set of one part; empty if parts are made of struts. */
    std::string joints;
    /** True: every strut is a part of its own; false: struts that meet are one.
     */
    bool   single_struts = false;
    double mass          = 0; ///< of each part (kg)
    /**
     * About axes through the centre of mass along x, y, z at rest (kg m2), in
     * the plane the last alone; empty: from the even spread of mass.
     */
    std::optional<dealii::Tensor<1, 3>> rotary_inertia;
    /** Whether elastic struts at its joints are clamped to it, not hinged. */
    bool        clamps_struts = false;
    std::string path;
  };

  /** `Rigid parts`. */
  SubsectionSchema rigid_parts_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  RigidPartDefinition read_rigid_part(ParameterValues &values);
} // namespace auxfem

#endif
