#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Of Re s (1/s). */
    double round_off_of_growth(const ComplexMode &mode)
    {
      constexpr double least = 1e-6, safety = 10;
      return std::max(least * std::abs(mode.s), safety * mode.uncertainty);
    }

    /** Lowest frequency without the part of the stiffness that is not symmetric
     * (rad/s). */
    double lowest_frequency(TangentSolver &solver, const State &state)
    {
      double lowest = 0;
      for (const NaturalMode &mode :
           natural_modes(solver, state, 1, StiffnessPart::symmetric).modes)
        lowest = std::sqrt(std::abs(mode.eigenvalue));
      return lowest > 0 ? lowest : 1.;
    }

    ComplexMode mode_of(const MotionRoot &root, const UnknownLayout &layout)
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

    /** By rising |s|. A growing motion and its mirror image, which decays, have
     * one |s|: the growing one first, whatever round-off says. */
    void sort(std::vector<ComplexMode> &modes)
    {
      constexpr double near = 1e-5;
      std::sort(modes.begin(),
                modes.end(),
                [](const ComplexMode &one, const ComplexMode &other) {
                  return std::abs(one.s) < std::abs(other.s);
                });
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
    const double shift = shift_below_roots * lowest_frequency(solver, state);
    const UnknownLayout &layout = solver.equations().unknowns().layout;
    MotionPencil         pencil(solver, state, damping);
    // The order by distance from the shift is nearly that by |s|.
    const MotionPencil::Roots found =
      pencil.nearest(shift, {[](const auto s) { return !relaxes(s); }, n + 2});
    std::vector<ComplexMode> all;
    for (const MotionRoot &root : found.roots)
      {
        all.push_back(mode_of(root, layout));
        ComplexMode &mode = all.back();
        // Without damping -s is a root, too: what is near its mirror image is
        // its own.
        if (damping == Damping::none && mode.swings() &&
            std::abs(mode.s.real()) <= round_off_of_growth(mode))
          mode.s.real(0.);
      }
    sort(all);
    ComplexModes modes;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (i < n || all[i].grows())
        modes.modes.push_back(std::move(all[i]));
    if (modes.modes.empty())
      throw ComputationError("Analysis = modes: no motion was found.");
    return modes;
  }
} // namespace auxfem
