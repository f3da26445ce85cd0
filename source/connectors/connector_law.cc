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
      generalized_maxwell_entry(),
      cubic_entry(),
      bilinear_entry(),
      gap_entry(),
      hook_entry(),
      tabulated_entry(),
      buckling_link_entry(),
      power_law_dashpot_entry(),
      friction_slider_entry(),
      expression_entry()};
    return registry;
  }

  std::unique_ptr<ConnectorLaw> ConnectorLaw::without_viscosity() const
  {
    return make_spring_law(relaxed(0).stiffness);
  }
} // namespace auxfem
