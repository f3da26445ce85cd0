#include <auxfem/connectors/connector_law.h>

namespace auxfem
{
  namespace
  {
    const Quantity dashpot_damping{"Damping coefficient",
                                   "",
                                   "N s/m",
                                   Range::non_negative(),
                                   "Dashpot force per rate of extension."};

    /** Linear dashpot: F = C du/dt. */
    std::unique_ptr<ConnectorLaw> make_dashpot(ParameterValues &values)
    {
      return make_kelvin_voigt_law(0, values[dashpot_damping]);
    }
  } // namespace

  RegistryEntry<ConnectorLaw> dashpot_entry()
  {
    return {"dashpot",
            "Linear dashpot: force = damping coefficient times rate of "
            "extension.",
            {dashpot_damping},
            make_dashpot};
  }
} // namespace auxfem
