#include <auxfem/connectors/connector_law.h>
#include <auxfem/connectors/maxwell.h>

namespace auxfem
{
  namespace
  {
    const Quantity parallel_stiffness{"Long-time stiffness",
                                      "",
                                      "N/m",
                                      Range::non_negative(),
                                      "Stiffness of the parallel spring."};

    const Quantity series_stiffness{"Spring stiffness",
                                    "",
                                    "N/m",
                                    Range::positive(),
                                    "Stiffness of the spring in series with "
                                    "the dashpot."};

    const Quantity series_damping{"Damping coefficient",
                                  "",
                                  "N s/m",
                                  Range::non_negative(),
                                  "Dashpot force per rate of its own "
                                  "extension."};

    /** A spring in parallel with a Maxwell element: F = Kinf u + F1, dF1/dt +
     * (K/C) F1 = K du/dt. */
    std::unique_ptr<ConnectorLaw>
    make_standard_linear_solid(ParameterValues &values)
    {
      const double stiffness = values[series_stiffness];
      const double damping   = values[series_damping];
      return make_generalized_maxwell_law(values[parallel_stiffness],
                                          {{stiffness, damping / stiffness}});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> standard_linear_solid_entry()
  {
    return {"standard-linear-solid",
            "Spring in parallel with a Maxwell element.",
            {parallel_stiffness, series_stiffness, series_damping},
            make_standard_linear_solid};
  }
} // namespace auxfem
