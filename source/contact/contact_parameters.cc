#include <auxfem/contact/contact_parameters.h>

namespace auxfem
{
  namespace
  {
    const Quantity contact_stiffness = {
      "Stiffness",
      "1",
      "1",
      Range::positive(),
      "Stiffness of the face of a strut against its axis, times that of its "
      "material, EA / (2 h^2) per length, h being half its thickness."};

    const Quantity contact_smoothing = {
      "Smoothing",
      "0.01",
      "1",
      Range{0, 1, true, false},
      "Penetration over half the thickness of the strut up to which the "
      "stiffness grows from zero to its value."};

    const Quantity contact_penetration = {
      "Largest penetration",
      "0.5",
      "1",
      Range{0, 1, true, true},
      "Penetration over half the thickness of the strut beyond which a step is "
      "rejected and divided."};

    const Quantity contact_friction = {
      "Friction coefficient",
      "0",
      "1",
      Range::non_negative(),
      "Coulomb's friction: largest force along the surface over that across."};

    const Quantity contact_slip_velocity = {
      "Slip velocity",
      "1 mm/s",
      "m/s",
      Range::positive(),
      "Velocity v0 at which things count as slipping: friction goes with "
      "v / sqrt(v^2 + v0^2), so what sticks creeps slower than this."};
  } // namespace



  SubsectionSchema contact_schema()
  {
    return {"Contact",
            SubsectionSchema::Form::fixed,
            "How struts resist what touches them.",
            {contact_stiffness,
             contact_smoothing,
             contact_penetration,
             contact_friction,
             contact_slip_velocity}};
  }



  ContactParameters read_contact(ParameterValues &values)
  {
    ContactParameters contact;
    contact.stiffness           = values[contact_stiffness];
    contact.smoothing           = values[contact_smoothing];
    contact.largest_penetration = values[contact_penetration];
    contact.friction            = values[contact_friction];
    contact.slip_velocity       = values[contact_slip_velocity];
    return contact;
  }
} // namespace auxfem
