#ifndef auxfem_contact_contact_parameters_h
#define auxfem_contact_contact_parameters_h

#include <auxfem/parameters/subsection_schema.h>

namespace auxfem
{
  /** `Contact`: how struts resist what touches them. */
  struct ContactParameters
  {
    /** Of a strut from axis to face, by that of its material. */
    double stiffness = 1;
    /** Of the penetration over half the thickness: up to which the stiffness
     * grows, and beyond which a step is rejected. */
    double smoothing = 0.01, largest_penetration = 0.5;
    double friction      = 0; ///< Coulomb's coefficient
    double slip_velocity = 0; ///< at which friction is near to its limit (m/s)
  };

  /** `Contact`. */
  SubsectionSchema contact_schema();

  /** The values of that subsection. */
  ContactParameters read_contact(ParameterValues &values);
} // namespace auxfem

#endif
