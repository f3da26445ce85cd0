#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    std::vector<double> conjugate(const UnknownLayout &layout,
                                  std::vector<double>  x)
    {
      const unsigned int n = layout.n_owned();
      for (unsigned int i = 0; i < n; ++i)
        x[n + i] *= -1;
      return x;
    }
  } // namespace

  std::complex<double> product(const UnknownLayout       &layout,
                               const std::vector<double> &x,
                               const std::vector<double> &y)
  {
    const unsigned int   n         = layout.n_owned();
    std::complex<double> local_sum = 0;
    for (unsigned int i = 0; i < n; ++i)
      local_sum += std::complex<double>(x[i], x[n + i]) *
        std::complex<double>(y[i], y[n + i]);
    const std::vector<double> sums =
      layout.sum(std::vector<double>{local_sum.real(), local_sum.imag()});
    return {sums[0], sums[1]};
  }

  double size(const UnknownLayout &layout, const std::vector<double> &x)
  {
    double sum = 0;
    for (const double value : x)
      sum += value * value;
    return std::sqrt(layout.sum(sum));
  }

  bool are_parallel(const UnknownLayout       &layout,
                    const std::vector<double> &x,
                    const std::vector<double> &y)
  {
    constexpr double parallel = 0.999;
    return std::abs(product(layout, conjugate(layout, x), y)) >
      parallel * size(layout, x) * size(layout, y);
  }

  void maximize_real_part(const UnknownLayout &layout,
                          std::vector<double> &shape)
  {
    const unsigned int         n = layout.n_owned();
    const std::complex<double> turn =
      std::polar(1., -std::arg(product(layout, shape, shape)) / 2);
    for (unsigned int i = 0; i < n; ++i)
      {
        const std::complex<double> value =
          turn * std::complex<double>(shape[i], shape[n + i]);
        shape[i]     = value.real();
        shape[n + i] = value.imag();
      }
  }

  namespace
  {
    /** Round-off of Re s (1/s). */
    double round_off_of_growth(const ComplexMode &mode)
    {
      constexpr double least = 1e-6, safety = 10;
      return std::max(least * std::abs(mode.s), safety * mode.uncertainty);
    }

    /**
     * Lowest natural frequency of the symmetric part of the stiffness (rad/s).
     */
    double lowest_symmetric_frequency(TangentSolver &solver, const State &state)
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

    /**
     * Sorts by increasing |s|. A growing mode and its decaying mirror image
     * have equal |s|; the growing one comes first regardless of round-off.
     */
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
    const double shift =
      shift_below_roots * lowest_symmetric_frequency(solver, state);
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
        // Without damping -s is a root, too, so a root near its mirror image
        // lies on the imaginary axis.
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

  namespace
  {
    /** Share of a natural mode in a damped mode. */
    struct ModalShare
    {
      std::size_t mode, root;
      double      size;
    };

    /** Upper bound of the factor by which struts that have no time to relax
     * raise frequencies. */
    double stiffening(const LatticeModel &model)
    {
      double factor = 1;
      for (const auto &law : model.laws)
        if (law)
          for (const StrainType type : {StrainType::normal, StrainType::shear})
            factor =
              std::max(factor, 1 / std::sqrt(law->long_time_ratio(type)));
      return factor;
    }

    /** All shares, the largest first. */
    std::vector<ModalShare> modal_shares(const MotionPencil             &pencil,
                                         const std::vector<NaturalMode> &modes,
                                         const std::vector<MotionRoot>  &roots)
    {
      std::vector<ModalShare> shares;
      for (std::size_t k = 0; k < roots.size(); ++k)
        {
          const std::size_t begin = shares.size();
          double            all   = 0;
          for (std::size_t i = 0; i < modes.size(); ++i)
            {
              const double size =
                std::abs(pencil.mass_product(modes[i].shape, roots[k].shape));
              all += size * size;
              shares.push_back({i, k, size});
            }
          for (std::size_t j = begin; j < shares.size() && all > 0; ++j)
            shares[j].size /= std::sqrt(all);
        }
      std::stable_sort(shares.begin(),
                       shares.end(),
                       [](const ModalShare &one, const ModalShare &other) {
                         return one.size > other.size;
                       });
      return shares;
    }
  } // namespace

  void add_damped_modes(TangentSolver &solver,
                        const State   &state,
                        NaturalModes  &found)
  {
    // A limit just above the highest frequency hardly coincides with a root.
    constexpr double    margin = 1.0437;
    std::vector<double> frequencies;
    for (const NaturalMode &mode : found.modes)
      if (mode.eigenvalue > 0)
        frequencies.push_back(mode.angular_frequency());
    if (frequencies.empty())
      return;
    const auto [lowest, highest] =
      std::minmax_element(frequencies.begin(), frequencies.end());
    const double max_magnitude =
      margin * *highest * stiffening(solver.equations().model());
    MotionPencil              pencil(solver, state, Damping::all);
    const MotionPencil::Roots damped = pencil.nearest(
      shift_below_roots * *lowest,
      {swings, static_cast<unsigned int>(frequencies.size()), max_magnitude});

    std::vector<char> is_assigned(damped.roots.size(), false);
    const auto        damped_part = [](const MotionRoot &root) {
      return NaturalMode::Damped{root.s.real(), root.s.imag()};
    };
    for (const ModalShare &share :
         modal_shares(pencil, found.modes, damped.roots))
      if (NaturalMode &mode = found.modes[share.mode];
          mode.eigenvalue > 0 && !mode.damped && !is_assigned[share.root])
        {
          mode.damped             = damped_part(damped.roots[share.root]);
          is_assigned[share.root] = true;
        }
    for (std::size_t k = 0; k < damped.roots.size(); ++k)
      if (!is_assigned[k])
        found.further_damped.push_back(damped_part(damped.roots[k]));
    if (damped.is_complete)
      found.damped_limit = max_magnitude;
  }
} // namespace auxfem
