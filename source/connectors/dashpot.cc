#include <auxfem/connectors/laws.h>
#include <auxfem/parameters/declare.h>

namespace auxfem
{
  namespace
  {
    const Quantity dashpot_damping{"Damping coefficient",
                                   "",
                                   "N s/m",
                                   Range::non_negative(),
                                   "Force of the dashpot per rate of "
                                   "extension."};

    void declare_dashpot(dealii::ParameterHandler &prm)
    {
      declare(prm, dashpot_damping);
    }

    /** Linear dashpot: F = C du/dt. */
    std::unique_ptr<ConnectorLaw> make_dashpot(dealii::ParameterHandler &prm,
                                               const SceneContext & /*context*/)
    {
      return make_kelvin_voigt_law(0, get(prm, dashpot_damping));
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
