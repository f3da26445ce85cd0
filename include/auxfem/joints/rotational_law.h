#ifndef auxfem_joints_rotational_law_h
#define auxfem_joints_rotational_law_h

#include <auxfem/connectors/connector_law.h>

#include <memory>
#include <string>
#include <vector>

namespace auxfem
{
  /** Choices of `Joints/NAME/Type` for rotational springs by laws of
   * connectors: `rotational LAW`, with moments for forces and rotations for
   * extensions. */
  std::vector<SubsectionVariant> rotational_laws();

  /** Makes the law of the choice @p type of rotational_laws() from @p values
   * of its subsection. Throws InputError as the law of connectors does. */
  std::unique_ptr<ConnectorLaw> make_rotational_law(const std::string &type,
                                                    ParameterValues   &values);
} // namespace auxfem

#endif
