#include <auxfem/connectors/elastic_law.h>

namespace auxfem
{
  namespace
  {
    const Quantity gap_stiffness{"Spring stiffness",
                                 "",
                                 "N/m",
                                 Range::positive(),
                                 "Stiffness of the closed gap."};

    const Quantity gap_width{
      "Gap",
      "0 m",
      "m",
      Range::non_negative(),
      "Shortening up to which there is no force; 0: a spring that only pushes."};

    std::unique_ptr<ConnectorLaw> make_gap(ParameterValues &values)
    {
      return make_elastic_law(std::make_shared<PiecewiseLinearCurve>(
                                std::vector<PiecewiseLinearCurve::Point>{
                                  {-values[gap_width], 0.}},
                                values[gap_stiffness],
                                /*last=*/0),
                              {0, values[stop_damping()]});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> gap_entry()
  {
    return {"gap",
            "Stop in compression: a spring that pushes once a gap has closed.",
            {gap_stiffness, gap_width, stop_damping()},
            make_gap};
  }
} // namespace auxfem
