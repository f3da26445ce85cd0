#include <auxfem/analysis/small_motions/complex_shape.h>
#include <auxfem/analysis/small_motions/damped_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/projected_modes.h>
#include <auxfem/analysis/small_motions/root_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    using Complex = std::complex<double>;
    using Values  = DynamicStiffness::Values;

    /** How far the factorized equations are from singular ones, over s: each
     * iteration makes the error smaller by about this. */
    constexpr double       shift            = 5e-3;
    constexpr double       no_swing         = 1e-9;
    constexpr double       settled_shape    = 1e-4;
    constexpr unsigned int most_refinements = 30, most_secants = 20;

    /** Watches changes of a number until they are round-off. */
    class Settling
    {
    public:
      /** Whether @p change, over the number, is as small as it becomes. */
      bool has_settled(const double change)
      {
        constexpr double converged = 1e-13, small = 1e-6;
        const bool       settled =
          change <= converged || (change <= small && change >= last / 2);
        last = change;
        return settled;
      }

    private:
      double last = std::numeric_limits<double>::infinity();
    };

    /** Finds one mode. */
    class DampedMode
    {
    public:
      DampedMode(DynamicStiffness    &stiffness,
                 const UnknownLayout &layout,
                 const Complex        s,
                 const Values        &x)
        : stiffness(stiffness)
        , layout(layout)
        , s(s)
        , x(x)
      {}

      /** Returns whether it was found and swings. */
      bool find()
      {
        return find_root_and_shape() &&
          // What has come to the real axis does not swing.
          std::abs(s.imag()) > no_swing * std::abs(s);
      }

      NaturalMode::Damped told() const
      {
        return {s.real(), std::abs(s.imag())};
      }

      /** Owned rows, real parts before imaginary ones. */
      const Values &shape() const
      {
        return x;
      }

    private:
      /** Residual inverse iteration (Neumaier 1985) with the quotient of
       * Rayleigh for symmetric A(s), x.A(s) x = 0. */
      bool find_root_and_shape()
      {
        Settling settling;
        for (unsigned int i = 0; i < most_refinements; ++i)
          {
            const Complex before = s;
            if (!find_root())
              return false;
            // A guess may be at its root while the shape is far from its own.
            if (settling.has_settled(std::abs(s - before) / std::abs(s)) &&
                change_of_shape <= settled_shape)
              return true;
            if (!improve())
              return false;
          }
        return false;
      }

      /** The root s of x.A(s) x near the last, by secants. */
      bool find_root()
      {
        const auto form = [this](const Complex at) {
          stiffness.set(at);
          return stiffness.form(x);
        };
        Settling settling;
        Complex  before = s * (1. + 1e-4), of_before = form(before);
        for (unsigned int i = 0; i < most_secants; ++i)
          {
            const Complex of_s = form(s);
            if (of_s == of_before)
              return true;
            const Complex change = of_s * (s - before) / (of_s - of_before);
            before               = s;
            of_before            = of_s;
            s -= change;
            // What has stopped swinging is no vibration.
            if (!std::isfinite(s.real()) || !(std::abs(s.imag()) > 0))
              return false;
            if (settling.has_settled(std::abs(change) / std::abs(s)))
              return true;
          }
        return false;
      }

      /** x <- x - A(sigma)^-1 A(s) x with sigma near s. */
      bool improve()
      {
        Values left(x.size()), change(x.size(), 0.);
        stiffness.set(s);
        stiffness.multiply(x.data(), left.data());
        stiffness.set(s * (1. + shift));
        if (!stiffness.factorize() || !stiffness.solve(left, change).empty())
          return false;
        change_of_shape = size(layout, change) / size(layout, x);
        for (std::size_t i = 0; i < x.size(); ++i)
          x[i] -= change[i];
        const double length = size(layout, x);
        if (!(std::isfinite(length) && length > 0))
          return false;
        for (double &value : x)
          value /= length;
        return true;
      }

      DynamicStiffness    &stiffness;
      const UnknownLayout &layout;
      Complex              s;
      Values               x;
      double change_of_shape = std::numeric_limits<double>::infinity();
    };

    bool are_near(const NaturalMode::Damped &one,
                  const NaturalMode::Damped &other)
    {
      constexpr double near = 1e-6;
      return std::hypot(one.growth - other.growth,
                        one.angular_frequency - other.angular_frequency) <=
        near * std::hypot(one.growth, one.angular_frequency);
    }

    /** Finds the damped modes of a list of natural ones. */
    class DampedModes
    {
    public:
      DampedModes(TangentSolver            &solver,
                  const State              &state,
                  std::vector<NaturalMode> &modes)
        : stiffness(solver, state)
        , layout(solver.equations().unknowns().layout)
        , modes(modes)
        , shapes(modes.size())
      {}

      /** From each natural mode by itself. */
      void find_each()
      {
        for (std::size_t i = 0; i < modes.size(); ++i)
          if (modes[i].eigenvalue > 0)
            {
              Values x(2 * layout.n_owned(), 0.);
              std::copy_n(modes[i].shape.begin(), layout.n_owned(), x.begin());
              find(i, {0., modes[i].angular_frequency()}, x);
            }
      }

      /** Whether a mode has no damped one, or two have the same. */
      bool are_mixed() const
      {
        for (std::size_t i = 0; i < modes.size(); ++i)
          if ((modes[i].eigenvalue > 0 && !modes[i].damped) || is_known(i))
            return true;
        return false;
      }

      /**
       * From what @p basis makes with damping, each given to the mode of
       * the basis that has the largest part in it and none yet.
       */
      void find_together(const std::vector<NaturalMode> &basis)
      {
        std::vector<char>              taken(basis.size(), false);
        const std::vector<NaturalMode> before           = modes;
        const std::vector<Values>      shapes_of_before = shapes;
        for (NaturalMode &mode : modes)
          mode.damped.reset();
        for (const ProjectedMode &guess :
             projected_modes(stiffness, layout, basis))
          {
            std::size_t best = basis.size();
            for (std::size_t j = 0; j < basis.size(); ++j)
              if (!taken[j] &&
                  (best == basis.size() ||
                   std::abs(guess.parts[j]) > std::abs(guess.parts[best])))
                best = j;
            if (best == basis.size())
              break;
            taken[best] = true;
            if (best < modes.size() && modes[best].eigenvalue > 0)
              find(best, guess.s, shape(basis, guess));
          }
        leave_out_known();
        // What only the search from the mode itself has found.
        for (std::size_t i = 0; i < modes.size(); ++i)
          if (!modes[i].damped)
            {
              modes[i].damped = before[i].damped;
              shapes[i]       = shapes_of_before[i];
              for (std::size_t j = 0; j < modes.size(); ++j)
                if (j != i && are_same(i, j))
                  modes[i].damped.reset();
            }
      }

      /** All that is told. */
      std::vector<CharacteristicEquation::Root> roots() const
      {
        std::vector<CharacteristicEquation::Root> all;
        for (std::size_t i = 0; i < modes.size(); ++i)
          if (const auto &damped = modes[i].damped)
            all.push_back(
              {{damped->growth, damped->angular_frequency}, shapes[i], 0., 0.});
        return all;
      }

    private:
      /** No mode is told twice. */
      void leave_out_known()
      {
        for (std::size_t i = 0; i < modes.size(); ++i)
          if (is_known(i))
            modes[i].damped.reset();
      }

      void find(const std::size_t i, const Complex s, const Values &x)
      {
        DampedMode mode(stiffness, layout, s, x);
        if (!mode.find())
          return;
        modes[i].damped = mode.told();
        shapes[i]       = mode.shape();
      }

      Values shape(const std::vector<NaturalMode> &basis,
                   const ProjectedMode            &guess) const
      {
        const unsigned int n = layout.n_owned();
        Values             x(2 * n, 0.);
        for (std::size_t j = 0; j < basis.size(); ++j)
          for (unsigned int k = 0; k < n; ++k)
            {
              x[k] += guess.parts[j].real() * basis[j].shape[k];
              x[n + k] += guess.parts[j].imag() * basis[j].shape[k];
            }
        return x;
      }

      /** Whether a mode before this one has the same damped one. */
      bool is_known(const std::size_t i) const
      {
        for (std::size_t j = 0; j < i; ++j)
          if (are_same(i, j))
            return true;
        return false;
      }

      bool are_same(const std::size_t i, const std::size_t j) const
      {
        return modes[i].damped && modes[j].damped &&
          are_near(*modes[i].damped, *modes[j].damped) &&
          are_parallel(layout, shapes[i], shapes[j]);
      }

      DynamicStiffness          stiffness;
      const UnknownLayout      &layout;
      std::vector<NaturalMode> &modes;
      std::vector<Values>       shapes;
    };
    /** Up to the highest of @p roots and of the frequencies of @p modes. */
    RootRegion region_of(const std::vector<NaturalMode>                  &modes,
                         const std::vector<CharacteristicEquation::Root> &roots)
    {
      // Neither is likely to be met by a frequency.
      constexpr double    below = 0.0917, above = 1.0437;
      std::vector<double> sizes;
      for (const NaturalMode &mode : modes)
        if (mode.eigenvalue > 0)
          sizes.push_back(mode.angular_frequency());
      for (const CharacteristicEquation::Root &root : roots)
        sizes.push_back(std::abs(root.s));
      const auto [lowest, highest] =
        std::minmax_element(sizes.begin(), sizes.end());
      return {below * *lowest, above * *highest};
    }

    /** Counts what is damped and looks for what is missing. */
    void count(TangentSolver                                   &solver,
               const State                                     &state,
               const std::vector<CharacteristicEquation::Root> &known,
               NaturalModes                                    &found)
    {
      constexpr unsigned int most_attempts = 3;
      constexpr double       further       = 1.0173;
      if (known.empty() || !CharacteristicEquation::is_within_reach(solver))
        return;
      CharacteristicEquation      equation(solver, state, Damping::all);
      RootRegion                  region = region_of(found.modes, known);
      std::optional<unsigned int> n      = n_roots(equation, region);
      for (unsigned int i = 1; i < most_attempts && !n; ++i)
        {
          region.outer *= further;
          region.inner /= further;
          n = n_roots(equation, region);
        }
      if (!n)
        return;
      RootSearch search(equation,
                        solver.equations().unknowns().layout,
                        region,
                        known);
      search.find(*n, {});
      for (const CharacteristicEquation::Root &root : search.found_anew())
        if (root.s.imag() > 0)
          found.further_damped.push_back({root.s.real(), root.s.imag()});
      found.damped_count = {region.outer, search.n_missing(*n) / 2};
    }
  } // namespace

  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found)
  {
    DampedModes damped(solver, state, found.modes);
    damped.find_each();
    if (damped.are_mixed())
      // What damping mixes has parts of higher modes too.
      damped.find_together(
        natural_modes(solver, state, 2 * found.modes.size()).modes);
    count(solver, state, damped.roots(), found);
  }
} // namespace auxfem
