#include <auxfem/parameters/errors.h>
#include <auxfem/time/alpha_family.h>
#include <auxfem/time/quasi_static.h>

namespace auxfem
{
  const std::vector<TimeSchemeEntry> &time_scheme_registry()
  {
    static const std::vector<TimeSchemeEntry> registry = {
      {"newmark",
       [](const TimeParameters &p) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<AlphaFamily>(
           AlphaFamily::newmark(p.beta, p.gamma));
       }},
      {"hht",
       [](const TimeParameters &p) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<AlphaFamily>(AlphaFamily::hht(p.hht_alpha));
       }},
      {"generalized-alpha",
       [](const TimeParameters &p) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<AlphaFamily>(
           AlphaFamily::generalized_alpha(p.spectral_radius));
       }},
      {"static", [](const TimeParameters &) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<QuasiStatic>();
       }}};
    return registry;
  }

  std::unique_ptr<TimeIntegrator>
  make_integrator(const TimeParameters &parameters)
  {
    for (const TimeSchemeEntry &entry : time_scheme_registry())
      if (entry.name == parameters.scheme)
        return entry.make(parameters);
    throw InputError("Time/Scheme: there is no scheme '" + parameters.scheme +
                     "'.");
  }
} // namespace auxfem
