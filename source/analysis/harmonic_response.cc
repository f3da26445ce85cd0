#include <auxfem/algebra/gmres.h>
#include <auxfem/analysis/arc_length.h>
#include <auxfem/analysis/harmonic_response.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    /** Of what GMRES leaves. */
    constexpr double solved = 1e-12;
  } // namespace

  HarmonicResponse::HarmonicResponse(TangentSolver &solver,
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
    const Evaluation evaluation = Evaluation::equilibrium(at_rest, now);
    solver.residual(evaluation, results);
    loads = load_direction(equations, evaluation);
    loads.resize(layout.n_owned());
    if (layout.largest(largest_size(loads)) == 0)
      throw InputError(
        "Analysis = frequency response: no load and no prescribed motion acts "
        "at Frequency response/Time of the loads. Set it to a time at which "
        "there is one.");
  }

  HarmonicVibration HarmonicResponse::at(const double omega)
  {
    find_matrices(omega);
    const auto refuse = [omega](const std::string &why) {
      std::ostringstream message;
      message << "No steady vibration was found at "
              << omega / (2 * dealii::numbers::PI) << " Hz: " << why
              << ". Without damping there is none at a natural frequency.";
      throw ComputationError(message.str());
    };
    if (!solver.factorize())
      refuse(solver.why());
    const unsigned int  n = layout.n_owned();
    std::vector<double> b(2 * n, 0.), x(2 * n, 0.);
    std::copy(loads.begin(), loads.end(), b.begin());
    const auto solve_real_part = [this](double *values) {
      Vector all(layout.n_local(), 0.);
      std::copy_n(values, layout.n_owned(), all.begin());
      const bool is_solved = solver.solve(all);
      std::copy_n(all.begin(), layout.n_owned(), values);
      return is_solved;
    };
    const std::string why =
      solve_by_gmres({layout.communicator(),
                      2 * n,
                      [this](const double *from, double *to) {
                        multiply(from, to);
                      },
                      [&](double *values) {
                        return solve_real_part(values) &&
                          solve_real_part(values + layout.n_owned());
                      }},
                     b,
                     solved,
                     x);
    if (!why.empty())
      refuse(why);

    HarmonicVibration vibration;
    for (Vector *part :
         {&vibration.displacement.real, &vibration.displacement.imaginary})
      {
        part->assign(layout.n_local(), 0.);
        std::copy_n(x.begin() + (part == &vibration.displacement.real ? 0 : n),
                    n,
                    part->begin());
        layout.update_ghosts(part->data());
      }
    const Vector &u = vibration.displacement.real,
                 &v = vibration.displacement.imaginary;
    Vector &real    = vibration.reaction.real,
           &other   = vibration.reaction.imaginary;
    real.assign(layout.n_local(), 0.);
    other.assign(layout.n_local(), 0.);
    add_forces(1., solver.matrix(), u, real);
    add_forces(-1., imaginary, v, real);
    add_forces(1., imaginary, u, other);
    add_forces(1., solver.matrix(), v, other);
    double left = 0, all = 0;
    for (unsigned int i = 0; i < n; ++i)
      if (space.is_prescribed(i))
        all += real[i] * real[i] + other[i] * other[i];
      else
        {
          left += std::pow(real[i] - loads[i], 2) + other[i] * other[i];
          all += loads[i] * loads[i];
          real[i] = other[i] = 0;
        }
    vibration.residual = std::sqrt(layout.sum(left) / layout.sum(all));
    return vibration;
  }

  void HarmonicResponse::find_matrices(const double omega)
  {
    equations.dynamic_stiffness(Evaluation::equilibrium(at_rest, now),
                                results,
                                {0., omega},
                                solver.matrix(),
                                imaginary);
    leave_out_constraints(imaginary);
  }

  void HarmonicResponse::multiply(const double *x, double *y) const
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

  void HarmonicResponse::add_forces(const double         factor,
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
} // namespace auxfem
