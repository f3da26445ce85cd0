#include <auxfem/connectors/elastic_law.h>

namespace auxfem
{
  namespace
  {
    const Quantity hook_stiffness{"Spring stiffness",
                                  "",
                                  "N/m",
                                  Range::positive(),
                                  "Stiffness of the taut hook."};

    const Quantity hook_slack{
      "Slack",
      "0 m",
      "m",
      Range::non_negative(),
      "Extension up to which there is no force; 0: a cable that only pulls."};

    std::unique_ptr<ConnectorLaw> make_hook(ParameterValues &values)
    {
      return make_elastic_law(std::make_shared<PiecewiseLinearCurve>(
                                std::vector<PiecewiseLinearCurve::Point>{
                                  {values[hook_slack], 0.}},
                                /*first=*/0,
                                values[hook_stiffness]),
                              {0, values[stop_damping()]});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> hook_entry()
  {
    return {"hook",
            "Cable or hook: a spring that pulls once its slack is taken up.",
            {hook_stiffness, hook_slack, stop_damping()},
            make_hook};
  }
} // namespace auxfem
