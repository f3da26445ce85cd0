#include <auxfem/connectors/connector_law.h>
#include <auxfem/connectors/maxwell.h>

namespace auxfem
{
  namespace
  {
    const Quantity maxwell_stiffness{
      "Spring stiffness",
      "",
      "N/m",
      Range::positive(),
      "Stiffness of the spring in series with the dashpot."};

    const Quantity maxwell_damping{
      "Damping coefficient",
      "",
      "N s/m",
      Range::non_negative(),
      "Dashpot force per rate of its own extension; below 0 it would create "
      "energy."};

    /** Spring and dashpot in series: dF/dt + (K/C) F = K du/dt. */
    std::unique_ptr<ConnectorLaw> make_maxwell(ParameterValues &values)
    {
      const double stiffness = values[maxwell_stiffness];
      const double damping   = values[maxwell_damping];
      return make_generalized_maxwell_law(0,
                                          {{stiffness, damping / stiffness}});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> maxwell_entry()
  {
    return {"maxwell",
            "Spring and dashpot in series.",
            {maxwell_stiffness, maxwell_damping},
            make_maxwell};
  }
} // namespace auxfem
