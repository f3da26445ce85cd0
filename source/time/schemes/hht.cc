#include <auxfem/time/schemes/alpha_family.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  namespace
  {
    const std::string hht_name = "hht";

    const Quantity alpha_entry = {
      "HHT alpha",
      "-0.05",
      "1",
      Range::closed(-1. / 3., 0),
      "Parameter alpha of Scheme = hht; 0 is undamped."};

    std::unique_ptr<TimeScheme> make_hht(ParameterValues &values)
    {
      return std::make_unique<AlphaFamily>(hht_name,
                                           AlphaFamily::hht(
                                             values[alpha_entry]));
    }
  } // namespace

  AlphaFamily::Coefficients AlphaFamily::hht(const double alpha)
  {
    return {0, -alpha, (1 - alpha) * (1 - alpha) / 4, 0.5 - alpha};
  }

  TimeSchemeEntry hht_entry()
  {
    return {{hht_name,
             "Hilber-Hughes-Taylor, of second order, damps high frequencies",
             {alpha_entry},
             make_hht},
            {Model::lattice, Model::reduced_cell}};
  }
} // namespace auxfem
