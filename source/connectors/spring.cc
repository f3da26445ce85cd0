#include <auxfem/connectors/connector_law.h>

namespace auxfem
{
  namespace
  {
    const Quantity spring_stiffness{"Spring stiffness",
                                    "",
                                    "N/m",
                                    Range::non_negative(),
                                    "Stiffness of the spring."};

    /** Linear spring: F = K u. */
    std::unique_ptr<ConnectorLaw> make_spring(ParameterValues &values)
    {
      return make_spring_law(values[spring_stiffness]);
    }
  } // namespace

  std::unique_ptr<ConnectorLaw> make_spring_law(const double stiffness)
  {
    return make_kelvin_voigt_law(stiffness, /*damping=*/0);
  }

  RegistryEntry<ConnectorLaw> spring_entry()
  {
    return {"spring",
            "Linear spring: force = stiffness times extension.",
            {spring_stiffness},
            make_spring};
  }
} // namespace auxfem
