#include <auxfem/analysis/small_motions/complex_shape.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/analysis/small_motions/relaxations.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** Rates (1/s) of Maxwell elements by themselves, and the lowest frequency
     * (rad/s), about which relaxations of dashpots are: none twice as fast as
     * another. */
    std::vector<double> typical_rates(TangentSolver &solver, const State &state)
    {
      std::vector<double> rates;
      for (const double time : solver.equations().relaxation_times())
        rates.push_back(1 / time);
      for (const NaturalMode &mode :
           natural_modes(solver, state, 1, StiffnessPart::symmetric).modes)
        if (mode.eigenvalue != 0)
          rates.push_back(std::sqrt(std::abs(mode.eigenvalue)));
      if (rates.empty())
        rates.push_back(1.);
      std::sort(rates.begin(), rates.end());
      std::vector<double> apart;
      for (const double rate : rates)
        if (apart.empty() || rate > 2 * apart.back())
          apart.push_back(rate);
      return apart;
    }

    /** Whether @p root is not among @p known. */
    bool is_new(const UnknownLayout           &layout,
                const MotionRoot              &root,
                const std::vector<MotionRoot> &known)
    {
      constexpr double near = 1e-7;
      return std::none_of(known.begin(),
                          known.end(),
                          [&](const MotionRoot &other) {
                            return std::abs(other.s - root.s) <=
                              near * std::abs(root.s) &&
                              are_parallel(layout, other.shape, root.shape);
                          });
    }

    /** More than so many near each other gather. */
    unsigned int most_of(const unsigned int n)
    {
      return 2 * n + 10;
    }

    /**
     * Leaves out, of roots by rising |s|, those from where very many gather:
     * damping in proportion to the stiffness has as many at one time as the
     * mesh has modes, equal Maxwell elements as many as there are elements.
     */
    void leave_out_gathering(std::vector<MotionRoot> &roots,
                             const unsigned int       n)
    {
      constexpr double  near = 1.7173;
      const std::size_t most = most_of(n);
      for (std::size_t i = 0; i + most < roots.size(); ++i)
        if (std::abs(roots[i + most].s) < near * std::abs(roots[i].s))
          {
            roots.resize(i);
            return;
          }
    }
  } // namespace

  Relaxations
  relaxations(TangentSolver &solver, const State &state, const unsigned int n)
  {
    // A shift beside a rate is hardly a root itself.
    constexpr double          beside = 1.1437;
    const UnknownLayout      &layout = solver.equations().unknowns().layout;
    const std::vector<double> rates  = typical_rates(solver, state);
    std::vector<double>       shifts{shift_below_roots * rates.front()};
    for (const double rate : rates)
      shifts.push_back(-beside * rate);
    MotionPencil            pencil(solver, state, Damping::all);
    std::vector<MotionRoot> roots;
    for (const double shift : shifts)
      for (const MotionRoot &root :
           pencil.nearest(shift, {relaxes, most_of(n) + 1}).roots)
        if (is_new(layout, root, roots))
          roots.push_back(root);
    std::sort(roots.begin(),
              roots.end(),
              [](const MotionRoot &one, const MotionRoot &other) {
                return std::abs(one.s) < std::abs(other.s);
              });
    leave_out_gathering(roots, n);
    Relaxations found;
    for (const MotionRoot &root : roots)
      if (found.size() < n)
        found.push_back({-root.s.real(), root.residual});
    return found;
  }
} // namespace auxfem
