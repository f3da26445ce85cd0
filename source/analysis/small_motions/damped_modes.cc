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

      /**
       * With damping that grows to its full size in @p n_stages. Nothing if that
       * fails, or if what it leads to does not swing.
       */
      std::optional<NaturalMode::Damped> find(const unsigned int n_stages)
      {
        for (unsigned int stage = 1; stage <= n_stages; ++stage)
          {
            damping = double(stage) / n_stages;
            if (!find_with_damping())
              return std::nullopt;
          }
        // What has come to the real axis does not swing.
        if (std::abs(s.imag()) <= no_swing * std::abs(s))
          return std::nullopt;
        return NaturalMode::Damped{s.real(), std::abs(s.imag())};
      }

    private:
      /** Residual inverse iteration (Neumaier 1985) with the quotient of
       * Rayleigh for symmetric A(s), x.A(s) x = 0. */
      bool find_with_damping()
      {
        Settling settling;
        for (unsigned int i = 0; i < most_refinements; ++i)
          {
            const Complex before = s;
            if (!find_root())
              return false;
            if (settling.has_settled(std::abs(s - before) / std::abs(s)))
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
          stiffness.set(at, damping);
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
        stiffness.set(s, damping);
        stiffness.multiply(x.data(), left.data());
        stiffness.set(s * (1. + shift), damping);
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
      double               damping = 1;
    };

    bool are_near(const double one, const double other)
    {
      constexpr double near = 1e-6;
      return std::abs(one - other) <= near * std::abs(one);
    }

    /** Whether two different modes have led to the same damped one. */
    bool have_met(const NaturalMode &one, const NaturalMode &other)
    {
      return one.damped && other.damped &&
        !are_near(one.eigenvalue, other.eigenvalue) &&
        are_near(one.damped->angular_frequency,
                 other.damped->angular_frequency) &&
        are_near(one.damped->growth, other.damped->growth);
    }

    /** Calls @p action for each pair that has met. */
    template <class Action>
    void for_each_meeting(std::vector<NaturalMode> &modes, const Action &action)
    {
      for (std::size_t i = 0; i < modes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (have_met(modes[i], modes[j]))
            action(modes[i], modes[j]);
    }
  } // namespace

  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found)
  {
    constexpr unsigned int n_stages = 16;
    DynamicStiffness       stiffness(solver, state);
    const auto             find = [&](NaturalMode &mode, const unsigned int n) {
      mode.damped =
        DampedMode(stiffness, solver.equations().unknowns().layout, mode)
          .find(n);
    };
    for (NaturalMode &mode : found.modes)
      if (mode.eigenvalue > 0)
        find(mode, 1);
    for_each_meeting(found.modes, [&](NaturalMode &one, NaturalMode &other) {
      find(one, n_stages);
      find(other, n_stages);
    });
    // Which of them it is cannot be told.
    for_each_meeting(found.modes, [](NaturalMode &one, NaturalMode &other) {
      one.damped.reset();
      other.damped.reset();
    });
  }
} // namespace auxfem
