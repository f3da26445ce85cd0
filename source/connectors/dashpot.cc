#include <auxfem/connectors/laws.h>
#include <auxfem/parameters/declare.h>

namespace auxfem
{
  namespace
  {
    const Quantity damping_coefficient{"Damping coefficient",
                                       "",
                                       "N s/m",
                                       Range::non_negative(),
                                       "Force of the dashpot per rate of "
                                       "extension."};

    void declare_dashpot(dealii::ParameterHandler &prm)
    {
      declare(prm, damping_coefficient);
    }

    /** Linear dashpot: F = C du/dt. */
    std::unique_ptr<ConnectorLaw> make_dashpot(dealii::ParameterHandler &prm,
                                               const SceneContext & /*context*/)
    {
      return make_kelvin_voigt_law(0, get(prm, damping_coefficient));
    }
  } // namespace

  RegistryEntry<ConnectorLaw> dashpot_entry()
  {
    return {"dashpot",
            "Linear dashpot: force = damping coefficient times rate of "
            "extension.",
            &declare_dashpot,
            &make_dashpot};
  }
} // namespace auxfem
