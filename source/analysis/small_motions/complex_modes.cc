#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/analysis/small_motions/root_search.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Of Re s, as far as can be told (1/s). */
    double round_off_of_growth(const ComplexMode &mode)
    {
      constexpr double least = 1e-6, safety = 10;
      return std::max(least * std::abs(mode.s), safety * mode.uncertainty);
    }

    /** Frequencies without the part of the stiffness that is not symmetric
     * (rad/s). */
    std::vector<double> frequencies_without_circulation(TangentSolver &solver,
                                                        const State   &state,
                                                        const unsigned int n)
    {
      std::vector<double> frequencies;
      for (const NaturalMode &mode :
           natural_modes(solver, state, n, StiffnessPart::symmetric).modes)
        if (mode.eigenvalue != 0)
          frequencies.push_back(std::sqrt(std::abs(mode.eigenvalue)));
      std::sort(frequencies.begin(), frequencies.end());
      if (frequencies.empty())
        throw ComputationError("Analysis = modes: nothing that can move has a "
                               "stiffness.");
      return frequencies;
    }

    /** A region with at least @p n modes, if there are so many, and how many
     * roots it has. */
    std::pair<RootRegion, std::optional<unsigned int>>
    region_of(CharacteristicEquation    &equation,
              const std::vector<double> &frequencies,
              const unsigned int         n)
    {
      // Neither is likely to be met by a frequency.
      constexpr double            margin = 1.0437, growth = 1.3173;
      constexpr unsigned int      most_attempts = 12;
      RootRegion                  region{0.0917 * frequencies.front(),
                        margin * frequencies.back()};
      std::optional<unsigned int> counted;
      for (unsigned int i = 0; i < most_attempts; ++i)
        {
          counted = n_roots(equation, region);
          if (counted && *counted >= 2 * n)
            break;
          region.outer *= counted ? growth : margin;
          region.inner /= counted ? growth : margin;
        }
      return {region, counted};
    }

    ComplexMode mode_of(const CharacteristicEquation::Root &root,
                        const UnknownLayout                &layout)
    {
      const unsigned int n = layout.n_owned();
      ComplexMode        mode{root.s,
                       root.residual,
                       root.uncertainty,
                       Vector(layout.n_local(), 0.),
                       Vector(layout.n_local(), 0.)};
      std::copy_n(root.shape.begin(), n, mode.real.begin());
      std::copy_n(root.shape.begin() + n, n, mode.imaginary.begin());
      layout.update_ghosts(mode.real.data());
      layout.update_ghosts(mode.imaginary.data());
      return mode;
    }
    /** What grows and its mirror image, which decays, have one |s|: the growing
     * one first, whatever round-off says. */
    void put_growing_first(std::vector<ComplexMode> &modes)
    {
      constexpr double near = 1e-5;
      for (std::size_t i = 0; i + 1 < modes.size(); ++i)
        if (std::abs(modes[i + 1].s) < (1 + near) * std::abs(modes[i].s) &&
            modes[i + 1].s.real() > modes[i].s.real())
          std::swap(modes[i], modes[i + 1]);
    }
  } // namespace

  bool ComplexMode::grows() const
  {
    return s.real() > round_off_of_growth(*this);
  }

  double ComplexMode::ratio() const
  {
    return (0. - s.real()) / std::abs(s);
  }

  ComplexModes complex_modes(TangentSolver     &solver,
                             const State       &state,
                             const unsigned int n,
                             const Damping      damping)
  {
    if (!CharacteristicEquation::is_within_reach(solver))
      throw InputError("Analysis = modes: under loads that follow their joints "
                       "modes are computed for up to 100000 unknowns. Take "
                       "fewer cells, or Direction = fixed.");
    const UnknownLayout      &layout = solver.equations().unknowns().layout;
    const std::vector<double> frequencies =
      frequencies_without_circulation(solver, state, n);
    CharacteristicEquation equation(solver, state, damping);
    const auto [region, counted] = region_of(equation, frequencies, n);
    std::vector<Complex> starts;
    for (const double frequency : frequencies)
      starts.push_back(frequency * Complex(0.02, 1.));
    RootSearch search(equation, layout, region, {});
    search.find(counted.value_or(2 * n), starts);
    ComplexModes found;
    found.limit            = region.outer;
    found.n_factorizations = equation.n_factorizations();
    if (counted)
      found.n_missing = (search.n_missing(*counted) + 1) / 2;
    std::vector<ComplexMode> all;
    for (const CharacteristicEquation::Root &root : search.found())
      {
        all.push_back(mode_of(root, layout));
        ComplexMode &mode = all.back();
        // Without damping -s is a root, too: what is near its mirror image is
        // its own.
        if (damping == Damping::none && mode.swings() &&
            std::abs(mode.s.real()) <= round_off_of_growth(mode))
          mode.s.real(0.);
      }
    put_growing_first(all);
    std::copy_if(all.begin(),
                 all.end(),
                 std::back_inserter(found.modes),
                 [&](const ComplexMode &mode) {
                   return &mode - all.data() < std::ptrdiff_t(n) ||
                     mode.grows();
                 });
    if (found.modes.empty())
      throw ComputationError("Analysis = modes: no motion was found.");
    return found;
  }
} // namespace auxfem
