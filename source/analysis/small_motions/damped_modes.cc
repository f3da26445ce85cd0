#include <auxfem/analysis/small_motions/damped_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>

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

    double size(const UnknownLayout &layout, const Values &x)
    {
      double sum = 0;
      for (const double value : x)
        sum += value * value;
      return std::sqrt(layout.sum(sum));
    }

    /** Finds one mode. */
    class DampedMode
    {
    public:
      DampedMode(DynamicStiffness    &stiffness,
                 const UnknownLayout &layout,
                 const NaturalMode   &undamped)
        : stiffness(stiffness)
        , layout(layout)
        , s(0., undamped.angular_frequency())
        , x(2 * layout.n_owned(), 0.)
      {
        std::copy_n(undamped.shape.begin(), layout.n_owned(), x.begin());
      }

      /** Residual inverse iteration (Neumaier 1985) with the quotient of
       * Rayleigh for symmetric A(s), x.A(s) x = 0. Nothing if that fails. */
      std::optional<NaturalMode::Damped> find()
      {
        Settling settling;
        for (unsigned int i = 0; i < most_refinements; ++i)
          {
            const Complex before = s;
            if (!find_root())
              return std::nullopt;
            if (settling.has_settled(std::abs(s - before) / std::abs(s)))
              {
                // What has come to the real axis does not swing.
                if (std::abs(s.imag()) <= no_swing * std::abs(s))
                  return std::nullopt;
                return NaturalMode::Damped{s.real(), std::abs(s.imag())};
              }
            if (!improve())
              return std::nullopt;
          }
        return std::nullopt;
      }

    private:
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
    };
  } // namespace

  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found)
  {
    DynamicStiffness stiffness(solver, state);
    for (NaturalMode &mode : found.modes)
      if (mode.eigenvalue > 0)
        mode.damped =
          DampedMode(stiffness, solver.equations().unknowns().layout, mode)
            .find();
  }
} // namespace auxfem
