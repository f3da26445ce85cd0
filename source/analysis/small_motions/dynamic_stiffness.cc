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
    , at_rest(equilibrium)
    , now(equilibrium)
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
    leave_out_constraints(imaginary);
  }

  void DynamicStiffness::find_mass(TangentMatrix &matrix)
  {
    equations.tangent(evaluation(), results, {0., 0., 1.}, matrix);
  }

  void DynamicStiffness::find_relaxing(const double time, TangentMatrix &matrix)
  {
    equations.relaxing_stiffness(results, time, matrix);
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
    Values left(x.size());
    multiply(x.data(), left.data());
    return product(layout, x, left);
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
    Vector of_real      = product(solver.matrix(), real),
           of_imaginary = product(solver.matrix(), imaginary_part);
    add_multiple(-1., product(imaginary, imaginary_part), of_real);
    add_multiple(1., product(imaginary, real), of_imaginary);
    return {of_real, of_imaginary};
  }

  void include_damping(EffectSwitches &effects)
  {
    for (Switch EffectSwitches::*damping :
         {&EffectSwitches::connector_viscosity, &EffectSwitches::strut_damping})
      if (effects.*damping == Switch::automatic)
        effects.*damping = Switch::on;
  }

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
