#include <auxfem/algebra/gmres.h>
#include <auxfem/analysis/small_motions/dynamic_stiffness.h>

#include <algorithm>

namespace auxfem
{
  DynamicStiffness::DynamicStiffness(TangentSolver &solver,
                                     const State   &equilibrium)
    : solver(solver)
    , equations(solver.equations())
    , layout(equations.unknowns().layout)
    , space(solver)
    , at_rest(equilibrium)
    , now(equilibrium)
    , results(equations.make_results())
    , imaginary(equations.pattern())
  {
    solver.residual(evaluation(), results);
  }

  Evaluation DynamicStiffness::evaluation()
  {
    return Evaluation::equilibrium(at_rest, now);
  }

  void DynamicStiffness::set(const std::complex<double> s, const double damping)
  {
    equations.dynamic_stiffness(evaluation(),
                                results,
                                s,
                                solver.matrix(),
                                imaginary,
                                damping);
    leave_out_constraints(imaginary);
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

  bool DynamicStiffness::factorize()
  {
    return solver.factorize();
  }

  std::string DynamicStiffness::solve(const Values &b, Values &x)
  {
    constexpr double   tolerance = 1e-12;
    const unsigned int n         = layout.n_owned();
    const auto         by_real   = [&](double *values) {
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
      tolerance,
      x);
  }

  std::complex<double> DynamicStiffness::form(const Values &x) const
  {
    const unsigned int n = layout.n_owned();
    Values             product(2 * n);
    multiply(x.data(), product.data());
    std::complex<double> mine = 0;
    for (unsigned int i = 0; i < n; ++i)
      mine += std::complex<double>(x[i], x[n + i]) *
        std::complex<double>(product[i], product[n + i]);
    const std::vector<double> sums =
      layout.sum(std::vector<double>{mine.real(), mine.imag()});
    return {sums[0], sums[1]};
  }

  std::pair<Vector, Vector>
  DynamicStiffness::forces(const Vector &real,
                           const Vector &imaginary_part) const
  {
    Vector of_real(layout.n_local(), 0.), of_imaginary(layout.n_local(), 0.);
    add_forces(1., solver.matrix(), real, of_real);
    add_forces(-1., imaginary, imaginary_part, of_real);
    add_forces(1., imaginary, real, of_imaginary);
    add_forces(1., solver.matrix(), imaginary_part, of_imaginary);
    return {of_real, of_imaginary};
  }

  void DynamicStiffness::add_forces(const double         factor,
                                    const TangentMatrix &matrix,
                                    const Vector        &values,
                                    Vector              &forces) const
  {
    const TangentPattern &pattern = matrix.pattern();
    const int             n_owned = layout.n_owned();
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      {
        const unsigned int  n       = pattern.size(block);
        const int *const    first   = pattern.begin(block);
        const double *const entries = matrix.values(block);
        for (unsigned int i = 0; i < n; ++i)
          if (first[i] >= 0 && first[i] < n_owned)
            for (unsigned int j = 0; j < n; ++j)
              if (first[j] >= 0)
                forces[first[i]] +=
                  factor * entries[i * n + j] * values[first[j]];
      }
    const std::vector<double> &diagonal = matrix.added_diagonal();
    for (std::size_t i = 0; i < diagonal.size(); ++i)
      forces[i] += factor * diagonal[i] * values[i];
  }

  void include_damping(Scene &scene)
  {
    for (Switch EffectSwitches::*damping :
         {&EffectSwitches::connector_viscosity, &EffectSwitches::strut_damping})
      if (scene.effects.*damping == Switch::automatic)
        scene.effects.*damping = Switch::on;
  }
} // namespace auxfem
