#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/analysis/small_motions/relaxations.h>
#include <auxfem/analysis/small_motions/root_search.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Rates (1/s) of Maxwell elements by themselves, and the lowest frequency
     * (rad/s), about which relaxations of dashpots are. */
    std::vector<double> typical_rates(TangentSolver &solver, const State &state)
    {
      std::vector<double> rates;
      for (const auto &[time, often] : solver.equations().relaxation_times())
        rates.push_back(1 / time);
      for (const NaturalMode &mode :
           natural_modes(solver, state, 1, StiffnessPart::symmetric).modes)
        if (mode.eigenvalue != 0)
          rates.push_back(std::sqrt(std::abs(mode.eigenvalue)));
      if (rates.empty())
        rates.push_back(1.);
      std::sort(rates.begin(), rates.end());
      return rates;
    }
    /** How many are looked for to have the @p n slowest. */
    unsigned int most_of(const unsigned int n)
    {
      return 2 * n + 10;
    }

    /**
     * Widens @p region until it has the @p n slowest relaxations, but not as far
     * as very many gather: damping in proportion to the stiffness has as many
     * at one time as the mesh has modes. Returns how many it has; none if that
     * is not known.
     */
    std::optional<unsigned int> widen(CharacteristicEquation &equation,
                                      RootRegion             &region,
                                      const unsigned int      n)
    {
      constexpr double            growth        = 1.7173;
      constexpr unsigned int      most_attempts = 24;
      std::optional<unsigned int> counted       = n_roots(equation, region);
      for (unsigned int i = 0; i < most_attempts; ++i)
        {
          if (counted && *counted >= n)
            break;
          RootRegion wider = region;
          wider.outer *= growth;
          const auto in_wider = n_roots(equation, wider);
          if (in_wider && *in_wider > most_of(n))
            break;
          region  = wider;
          counted = in_wider;
        }
      return counted;
    }
  } // namespace

  Relaxations
  relaxations(TangentSolver &solver, const State &state, const unsigned int n)
  {
    if (!CharacteristicEquation::is_within_reach(solver))
      throw InputError("Modes/Relaxations: they are computed for up to 100000 "
                       "unknowns. Take fewer cells, or 0.");
    constexpr double                 slowest = 1e-6, margin = 1.3437;
    const std::vector<double>        rates = typical_rates(solver, state);
    CharacteristicEquation           equation(solver, state, Damping::all);
    RootRegion                       region{slowest * rates.front(),
                      margin * rates.front(),
                      RootRegion::Kind::relaxes};
    const auto                       counted = widen(equation, region, n);
    RootSearch                       search(equation,
                      solver.equations().unknowns().layout,
                      region,
                      {});
    std::vector<RootSearch::Complex> starts;
    for (const double rate : rates)
      for (const double factor : {-0.7, -1.1})
        starts.push_back(factor * rate);
    search.find(std::min(counted.value_or(n), most_of(n)), starts);
    Relaxations found;
    if (counted)
      found.n_missing = search.n_missing(*counted);
    for (const CharacteristicEquation::Root &root : search.found())
      if (found.all.size() < n)
        found.all.push_back({-root.s.real(), root.residual});
    return found;
  }
} // namespace auxfem
