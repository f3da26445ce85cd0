#include <auxfem/analysis/small_motions/characteristic_equation.h>
#include <auxfem/analysis/small_motions/complex_shape.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    using Complex = CharacteristicEquation::Complex;
    using Values  = CharacteristicEquation::Values;
  } // namespace

  CharacteristicEquation::CharacteristicEquation(TangentSolver &solver,
                                                 const State   &equilibrium,
                                                 const Damping  damping)
    : layout(solver.equations().unknowns().layout)
    , stiffness(solver, equilibrium, damping)
    , factors(solver.equations().pattern())
    , relaxation_times(damping == Damping::all
                         ? solver.equations().relaxation_times()
                         : std::map<double, unsigned int>())
  {}

  bool CharacteristicEquation::is_within_reach(const TangentSolver &solver)
  {
    // Some hundred factorizations, and the matrix on every rank.
    constexpr unsigned int most = 100000;
    return solver.equations().unknowns().layout.n_global() <= most;
  }

  bool CharacteristicEquation::factorize(const Complex s)
  {
    ++n_done;
    stiffness.set(s);
    return stiffness.factorize(factors);
  }

  std::optional<Complex> CharacteristicEquation::logarithm(const Complex s)
  {
    if (!factorize(s))
      return std::nullopt;
    return factors.log_determinant();
  }

  std::optional<CharacteristicEquation::Logarithm>
  CharacteristicEquation::at(const Complex s)
  {
    constexpr double relative_step = 1e-5, turn = 2 * dealii::numbers::PI;
    const auto here = logarithm(s), there = logarithm(s * (1. + relative_step));
    if (!here || !there)
      return std::nullopt;
    const Complex change = *there - *here;
    Logarithm     logarithm{*here,
                        Complex(change.real(),
                                std::remainder(change.imag(), turn)) /
                          (s * relative_step)};
    for (const auto &[time, often] : relaxation_times)
      {
        logarithm.value += double(often) * std::log(1. + s * time);
        logarithm.slope += double(often) * time / (1. + s * time);
      }
    return logarithm;
  }

  Values CharacteristicEquation::beginning(const unsigned int number) const
  {
    // Without symmetry, which a mode may lack, and the same on any ranks.
    const unsigned int n = layout.n_owned();
    Values             x(2 * n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      x[i] = std::sin(1. + (0.7 + 0.1 * number) * (layout.global(i) + number));
    return x;
  }

  Values CharacteristicEquation::derivative(const Complex s, const Values &x)
  {
    constexpr double relative_step = 1e-4;
    Values           before(x.size()), after(x.size());
    stiffness.set(s * (1. - relative_step));
    stiffness.multiply(x.data(), before.data());
    stiffness.set(s * (1. + relative_step));
    stiffness.multiply(x.data(), after.data());
    const unsigned int n = layout.n_owned();
    for (unsigned int i = 0; i < n; ++i)
      {
        const Complex slope =
          Complex(after[i] - before[i], after[n + i] - before[n + i]) /
          (2. * relative_step * s);
        after[i]     = slope.real();
        after[n + i] = slope.imag();
      }
    return after;
  }

  /** Improves shapes @p x and @p y of both sides; by which @p s errs. */
  std::optional<Complex>
  CharacteristicEquation::step(const Complex s, Values &x, Values &y)
  {
    // The last digit may hit the root itself.
    if (!factorize(s) && !factorize(s * (1. + 1e-12)))
      return std::nullopt;
    for (unsigned int i = 0; i < 2; ++i)
      for (const auto &[shape, side] :
           {std::pair(&x, ComplexFactors::Side::right),
            std::pair(&y, ComplexFactors::Side::left)})
        {
          factors.solve(*shape, side);
          const double length = size(layout, *shape);
          if (!(std::isfinite(length) && length > 0))
            return std::nullopt;
          for (double &value : *shape)
            value /= length;
        }
    stiffness.set(s);
    Values left(x.size());
    stiffness.multiply(x.data(), left.data());
    const Complex change =
      product(layout, y, left) / product(layout, y, derivative(s, x));
    if (!std::isfinite(std::abs(change)))
      return std::nullopt;
    return change;
  }

  std::optional<CharacteristicEquation::Root>
  CharacteristicEquation::refine(const Complex guess, const unsigned int number)
  {
    // Elements much stiffer than the mode leave it that many digits.
    constexpr double       converged = 1e-12, round_off = 1e-3, slow = 0.7;
    constexpr unsigned int most_steps = 40;
    Root                   root{guess, beginning(number), 0., 0.};
    // Where A is symmetric both are the same.
    Values y    = root.shape;
    double last = std::abs(guess);
    for (unsigned int i = 0; i < most_steps; ++i)
      {
        const auto change = step(root.s, root.shape, y);
        if (!change)
          return std::nullopt;
        root.s -= *change;
        root.uncertainty      = std::abs(*change);
        const double relative = root.uncertainty / std::abs(root.s);
        if (relative <= converged ||
            (relative <= round_off && relative >= slow * last))
          {
            Values left(root.shape.size());
            stiffness.set(root.s);
            stiffness.multiply(root.shape.data(), left.data());
            root.residual = size(layout, left) /
              (std::abs(root.s) * size(layout, derivative(root.s, root.shape)));
            return root;
          }
        last = relative;
      }
    return std::nullopt;
  }
} // namespace auxfem
