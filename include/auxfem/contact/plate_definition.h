#ifndef auxfem_contact_plate_definition_h
#define auxfem_contact_plate_definition_h

#include <auxfem/contact/contact_law.h>
#include <auxfem/contact/rigid_surface.h>
#include <auxfem/loads/load_definitions.h>
#include <auxfem/parameters/subsection_schema.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <optional>

namespace auxfem
{
  /**
   * `Plates/NAME`: a rigid, non-rotating obstacle. Its reference point is an
   * extra joint that forms the set NAME, so supports, loads and probes of
   * joints apply to plates.
   */
  struct PlateDefinition
  {
    std::string                         name;
    std::shared_ptr<const RigidSurface> surface;
    dealii::Point<3> position; ///< of the reference point, as given (m)
    /** Gap at rest to the nearest strut (m), to which the plate is moved;
     * empty: it stays at its position. */
    std::optional<double> gap;
    /** Prescribed components; none if all are free. */
    std::optional<SupportDefinition> support;
    /** Empty without mass. */
    std::optional<MassDefinition> mass;
    /** Empty if the plate starts at rest. */
    std::optional<InitialVelocityDefinition> initial_velocity;
    std::string                              path;
  };

  /** Declares subsection `Plates`. */
  SubsectionSchema plates_schema();

  /** Reads one plate. Throws InputError for contradicting values. */
  PlateDefinition read_plate(ParameterValues &values);
} // namespace auxfem

#endif
