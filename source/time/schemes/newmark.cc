#include <auxfem/parameters/errors.h>
#include <auxfem/time/schemes/alpha_family.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <sstream>

namespace auxfem
{
  namespace
  {
    const std::string newmark_name = "newmark";

    const Quantity beta_entry = {
      "Newmark beta",
      "0.25",
      "1",
      Range::closed(0, 1),
      "Parameter beta of Scheme = newmark; 2 beta >= gamma."};
    const Quantity gamma_entry = {
      "Newmark gamma",
      "0.5",
      "1",
      Range::closed(0, 1),
      "Parameter gamma of Scheme = newmark, at least 1/2; larger values damp."};

    void refuse_unstable(const double       beta,
                         const double       gamma,
                         const std::string &path)
    {
      // beta = gamma / 2 must pass although both decimals are rounded.
      if (gamma >= 0.5 && 2 * beta >= gamma * (1 - 1e-12))
        return;
      std::ostringstream text;
      text << path << '/' << beta_entry.name << " = " << beta << " and " << path
           << '/' << gamma_entry.name << " = " << gamma
           << " are not unconditionally stable, which needs 2 beta >= gamma >= "
              "1/2. Use e.g. beta = 0.25 and gamma = 0.5";
      throw InputError(text.str());
    }

    std::unique_ptr<TimeScheme> make_newmark(ParameterValues &values)
    {
      const double beta = values[beta_entry], gamma = values[gamma_entry];
      refuse_unstable(beta, gamma, values.context.path);
      return std::make_unique<AlphaFamily>(newmark_name,
                                           AlphaFamily::newmark(beta, gamma));
    }
  } // namespace

  AlphaFamily::Coefficients AlphaFamily::newmark(const double beta,
                                                 const double gamma)
  {
    return {0, 0, beta, gamma};
  }

  TimeSchemeEntry newmark_entry()
  {
    return {{newmark_name,
             "Newmark; default: average acceleration, of second order",
             {beta_entry, gamma_entry},
             make_newmark},
            {Model::lattice, Model::reduced_cell}};
  }
} // namespace auxfem
