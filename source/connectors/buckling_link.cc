#include <auxfem/connectors/elastic_law.h>

namespace auxfem
{
  namespace
  {
    const Quantity link_stiffness{"Spring stiffness",
                                  "",
                                  "N/m",
                                  Range::positive(),
                                  "Stiffness in tension, and in compression "
                                  "before the link buckles."};

    const Quantity buckling_load{
      "Buckling load",
      "",
      "N",
      Range::positive(),
      "Compressive force at which the link buckles; it stays constant "
      "afterwards."};

    std::unique_ptr<ConnectorLaw> make_buckling_link(ParameterValues &values)
    {
      const double stiffness = values[link_stiffness];
      const double load      = values[buckling_load];
      return make_elastic_law(std::make_shared<PiecewiseLinearCurve>(
        std::vector<PiecewiseLinearCurve::Point>{{-load / stiffness, -load}},
        /*first=*/0,
        stiffness));
    }
  } // namespace

  RegistryEntry<ConnectorLaw> buckling_link_entry()
  {
    return {"buckling-link",
            "Slender elastic link that buckles in compression and straightens "
            "again.",
            {link_stiffness, buckling_load},
            make_buckling_link};
  }
} // namespace auxfem
