#include <auxfem/connectors/connector_law.h>

namespace auxfem
{
  const Registry<ConnectorLaw> &connector_law_registry()
  {
    static const Registry<ConnectorLaw> registry = {
      spring_entry(),
      dashpot_entry(),
      kelvin_voigt_entry(),
      maxwell_entry(),
      standard_linear_solid_entry(),
      generalized_maxwell_entry()};
    return registry;
  }
} // namespace auxfem
