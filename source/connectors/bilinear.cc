#include <auxfem/connectors/elastic_law.h>

namespace auxfem
{
  namespace
  {
    const Quantity bilinear_stiffness{"Spring stiffness",
                                      "",
                                      "N/m",
                                      Range::non_negative(),
                                      "Stiffness up to the kink."};

    const Quantity bilinear_second_stiffness{"Second stiffness",
                                             "",
                                             "N/m",
                                             Range::non_negative(),
                                             "Stiffness beyond the kink."};

    const Quantity kink_extension{
      "Kink extension",
      "",
      "m",
      Range::positive(),
      "Extension or shortening at which the stiffness changes."};

    std::unique_ptr<ConnectorLaw> make_bilinear(ParameterValues &values)
    {
      const double u      = values[kink_extension];
      const double force  = values[bilinear_stiffness] * u;
      const double second = values[bilinear_second_stiffness];
      return make_elastic_law(
        std::make_shared<PiecewiseLinearCurve>(
          std::vector<PiecewiseLinearCurve::Point>{{-u, -force}, {u, force}},
          second,
          second),
        {values[parallel_damping()]});
    }
  } // namespace

  RegistryEntry<ConnectorLaw> bilinear_entry()
  {
    return {"bilinear",
            "Elastic spring of two stiffnesses, alike in tension and "
            "compression.",
            {bilinear_stiffness,
             bilinear_second_stiffness,
             kink_extension,
             parallel_damping()},
            make_bilinear};
  }
} // namespace auxfem
