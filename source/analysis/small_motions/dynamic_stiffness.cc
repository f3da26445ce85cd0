#include <auxfem/algebra/gmres.h>
#include <auxfem/analysis/small_motions/complex_shape.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>

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
} // namespace auxfem
