#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/analysis/small_motions/complex_modes.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/analysis/small_motions/motion_pencil.h>
#include <auxfem/analysis/small_motions/natural_modes.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  DynamicStiffness::DynamicStiffness(TangentSolver &solver,
                                     const State   &equilibrium,
                                     const Damping  damping)
    : solver(solver)
    , equations(solver.equations())
    , layout(equations.unknowns().layout)
    , damping(damping)
    , space(solver)
    , start_state(equilibrium)
    , end_state(equilibrium)
    , results(equations.make_results())
    , imaginary(equations.pattern())
  {
    solver.residual(evaluation(), results);
  }

  void DynamicStiffness::set(const std::complex<double> s)
  {
    if (damping == Damping::all)
      equations.dynamic_stiffness(evaluation(),
                                  results,
                                  s,
                                  solver.matrix(),
                                  imaginary);
    else
      {
        const std::complex<double> square = s * s;
        equations.tangent(evaluation(),
                          results,
                          {1., 0., square.real()},
                          solver.matrix());
        equations.tangent(evaluation(),
                          results,
                          {0., 0., square.imag()},
                          imaginary);
      }
    clear_constraint_entries(imaginary);
  }

  void DynamicStiffness::assemble_mass(TangentMatrix &matrix)
  {
    equations.tangent(evaluation(), results, {0., 0., 1.}, matrix);
  }

  void DynamicStiffness::assemble_relaxing_stiffness(const double   time,
                                                     TangentMatrix &matrix)
  {
    equations.relaxing_stiffness(evaluation(), results, time, matrix);
  }

  void DynamicStiffness::multiply(const double *x, double *y) const
  {
    const unsigned int n = layout.n_owned();
    Vector             real(layout.n_local(), 0.), other(layout.n_local(), 0.);
    std::copy_n(x, n, real.begin());
    std::copy_n(x + n, n, other.begin());
    layout.update_ghosts(real.data());
    layout.update_ghosts(other.data());
    const TangentMatrix &matrix = solver.matrix();
    Vector               by_real(n), by_other(n);
    imaginary.multiply(real.data(), by_real.data());
    imaginary.multiply(other.data(), by_other.data());
    matrix.multiply(real.data(), y);
    matrix.multiply(other.data(), y + n);
    for (unsigned int i = 0; i < n; ++i)
      if (!space.is_prescribed(i))
        {
          y[i] -= by_other[i];
          y[n + i] += by_real[i];
        }
  }

  std::string DynamicStiffness::solve(const Values &b, Values &x)
  {
    const unsigned int n       = layout.n_owned();
    const auto         by_real = [&](double *values) {
      Vector all(layout.n_local(), 0.);
      std::copy_n(values, n, all.begin());
      const bool is_solved = solver.solve(all);
      std::copy_n(all.begin(), n, values);
      return is_solved;
    };
    return solve_by_gmres(
      {layout.communicator(),
       2 * n,
       [this](const double *from, double *to) { multiply(from, to); },
       [&](double *values) { return by_real(values) && by_real(values + n); }},
      b,
      round_off,
      x);
  }

  std::complex<double> DynamicStiffness::form(const Values &x) const
  {
    Values image(x.size());
    multiply(x.data(), image.data());
    return product(layout, x, image);
  }

  std::pair<Vector, Vector>
  DynamicStiffness::forces(const Vector &real,
                           const Vector &imaginary_part) const
  {
    const auto product = [this](const TangentMatrix &matrix, const Vector &x) {
      Vector y(layout.n_owned());
      matrix.multiply_blocks(x.data(), y.data());
      return y;
    };
    Vector real_forces      = product(solver.matrix(), real),
           imaginary_forces = product(solver.matrix(), imaginary_part);
    add_multiple(-1., product(imaginary, imaginary_part), real_forces);
    add_multiple(1., product(imaginary, real), imaginary_forces);
    return {real_forces, imaginary_forces};
  }

  void include_damping(EffectSwitches &effects)
  {
    for (Switch EffectSwitches::*damping :
         {&EffectSwitches::connector_viscosity,
          &EffectSwitches::strut_damping,
          &EffectSwitches::strut_relaxation})
      if (effects.*damping == Switch::automatic)
        effects.*damping = Switch::on;
  }

  namespace
  {
    /**
     * Relaxation rates (1/s) of single Maxwell elements and the lowest
     * frequency (rad/s), near which dashpots relax. Rates within a factor of
     * two are merged.
     */
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
      std::vector<double> separated;
      for (const double rate : rates)
        if (separated.empty() || rate > 2 * separated.back())
          separated.push_back(rate);
      return separated;
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

    /** Number of close roots above which they count as a cluster. */
    unsigned int cluster_size(const unsigned int n)
    {
      return 2 * n + 10;
    }

    /**
     * Removes roots from the first cluster on; @p roots are sorted by |s|.
     * Stiffness-proportional damping and equal Maxwell elements cluster as many
     * roots at one rate as there are modes or elements.
     */
    void remove_clusters(std::vector<MotionRoot> &roots, const unsigned int n)
    {
      constexpr double  near = 1.7173;
      const std::size_t most = cluster_size(n);
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
    // A shift next to a rate hardly coincides with a root.
    constexpr double          offset = 1.1437;
    const UnknownLayout      &layout = solver.equations().unknowns().layout;
    const std::vector<double> rates  = typical_rates(solver, state);
    std::vector<double>       shifts{shift_below_roots * rates.front()};
    for (const double rate : rates)
      shifts.push_back(-offset * rate);
    MotionPencil            pencil(solver, state, Damping::all);
    std::vector<MotionRoot> roots;
    for (const double shift : shifts)
      for (const MotionRoot &root :
           pencil.nearest(shift, {relaxes, cluster_size(n) + 1}).roots)
        if (is_new(layout, root, roots))
          roots.push_back(root);
    std::sort(roots.begin(),
              roots.end(),
              [](const MotionRoot &one, const MotionRoot &other) {
                return std::abs(one.s) < std::abs(other.s);
              });
    remove_clusters(roots, n);
    Relaxations found;
    for (const MotionRoot &root : roots)
      if (found.size() < n)
        found.push_back({-root.s.real(), root.residual});
    return found;
  }
} // namespace auxfem
