#ifndef auxfem_connectors_laws_h
#define auxfem_connectors_laws_h

#include <auxfem/connectors/connector_law.h>

namespace auxfem
{
  /**
   * @name Table entries of the laws, one per file source/connectors/<name>.cc.
   * Only register.cc needs them.
   */
  ///@{
  RegistryEntry<ConnectorLaw> spring_entry();
  RegistryEntry<ConnectorLaw> dashpot_entry();
  RegistryEntry<ConnectorLaw> kelvin_voigt_entry();
  RegistryEntry<ConnectorLaw> maxwell_entry();
  RegistryEntry<ConnectorLaw> standard_linear_solid_entry();
  RegistryEntry<ConnectorLaw> generalized_maxwell_entry();
  ///@}

  /**
   * Spring @p stiffness (N/m) and dashpot @p damping (N s/m) side by side:
   * F = K u + C du/dt. Either may be zero.
   */
  std::unique_ptr<ConnectorLaw> make_kelvin_voigt_law(double stiffness,
                                                      double damping);
} // namespace auxfem

#endif
