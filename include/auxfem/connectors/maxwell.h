#ifndef auxfem_connectors_maxwell_h
#define auxfem_connectors_maxwell_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/mathematics/maxwell_element.h>

#include <vector>

namespace auxfem
{
  /**
   * A spring (possibly of zero stiffness) in parallel with Maxwell elements,
   *
   *   F = Kinf u + sum_i F_i,   dF_i/dt + F_i / tau_i = k_i du/dt,
   *
   * that is a Prony series. With one element this is the standard linear solid,
   * without the spring the Maxwell law. The internal variables are the forces
   * F_i in the order of @p elements.
   */
  std::unique_ptr<ConnectorLaw>
  make_generalized_maxwell_law(double                      long_time_stiffness,
                               std::vector<MaxwellElement> elements);
} // namespace auxfem

#endif
