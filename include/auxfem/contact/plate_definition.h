#ifndef auxfem_contact_plate_definition_h
#define auxfem_contact_plate_definition_h

#include <auxfem/contact/rigid_surface.h>
#include <auxfem/loads/load_definitions.h>
#include <auxfem/loads/support_definition.h>

#include <deal.II/base/point.h>

#include <optional>

namespace auxfem
{
  /**
   * `Plates/NAME`: a rigid body that struts cannot enter. It does not turn. Its
   * point of reference is a joint of its own, the set NAME, so whatever holds,
   * moves, loads or shows joints serves plates too.
   */
  struct PlateDefinition
  {
    std::string                         name;
    std::shared_ptr<const RigidSurface> surface;
    dealii::Point<3>                    position; ///< of reference, at rest (m)
    /** Of the components that are held or moved; none if all are free. */
    std::optional<SupportDefinition> support;
    /** None without mass. */
    std::optional<MassDefinition> mass;
    /** None if it starts at rest. */
    std::optional<InitialVelocityDefinition> initial_velocity;
    std::string                              path;
  };

  /** `Plates`. */
  SubsectionSchema plates_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  PlateDefinition read_plate(ParameterValues &values);
} // namespace auxfem

#endif
