#include <auxfem/parameters/errors.h>
#include <auxfem/time/alpha_family.h>
#include <auxfem/time/quasi_static.h>

namespace auxfem
{
  const std::vector<TimeSchemeEntry> &time_scheme_registry()
  {
    static const std::vector<TimeSchemeEntry> registry = {
      {"newmark",
       "Newmark with `Newmark beta` and `Newmark gamma`; 1/4, 1/2 is the average "
       "acceleration rule: second order, stable, no numerical damping.",
       [](const TimeParameters &p) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<AlphaFamily>(
           AlphaFamily::newmark(p.beta, p.gamma));
       }},
      {"hht",
       "Hilber-Hughes-Taylor with `HHT alpha`: second order, damps high frequencies.",
       [](const TimeParameters &p) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<AlphaFamily>(AlphaFamily::hht(p.hht_alpha));
       }},
      {"generalized-alpha",
       "Chung-Hulbert from the `Spectral radius` at infinite frequency: second order, "
       "damps high frequencies with least effect on low ones.",
       [](const TimeParameters &p) -> std::unique_ptr<TimeIntegrator> {
         return std::make_unique<AlphaFamily>(
           AlphaFamily::generalized_alpha(p.spectral_radius));
       }},
      {"static",
       "No inertia: equilibrium at every step, loads and prescribed motion follow the "
       "(pseudo) time; viscous connectors act with the rate of that time.",
       [](const TimeParameters &) -> std::unique_ptr<TimeIntegrator> {
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
