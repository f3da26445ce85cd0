#include <auxfem/time/schemes/runge_kutta.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    /**
     * Error |R(iz) - exp(iz)| at the end of a step in which an oscillation
     * turns by
     * @p angle.
     */
    double error_of(const std::vector<std::complex<double>> &stages,
                    const double                             angle)
    {
      return std::abs(stages.back() - std::exp(std::complex<double>(0, angle)));
    }
  } // namespace

  double ButcherTableau::missed_growth(const unsigned int i,
                                       const unsigned int j) const
  {
    const double below = j <= i ? weights[i] * factors[i][j] : 0,
                 above = i <= j ? weights[j] * factors[j][i] : 0;
    return below + above - weights[i] * weights[j];
  }

  std::vector<std::complex<double>>
  ButcherTableau::oscillation(const double angle) const
  {
    const std::complex<double>        lambda(0, angle);
    std::vector<std::complex<double>> values(n_stages(), 1.);
    for (unsigned int i = 1; i < n_stages(); ++i)
      {
        for (unsigned int j = 0; j < i; ++j)
          values[i] += factors[i][j] * lambda * values[j];
        values[i] /= 1. - diagonal * lambda;
      }
    return values;
  }

  RungeKutta::RungeKutta(const std::string &name, const ButcherTableau &tableau)
    : ImplicitScheme(name)
    , tableau(tableau)
  {}

  void RungeKutta::predict(const State &from, const double dt, State &to) const
  {
    const std::size_t n     = from.displacement.size();
    const double     *u     = from.displacement.data();
    const double     *v     = from.velocity->data();
    const double     *a     = from.acceleration->data();
    double           *u_new = to.displacement.data();
    double           *v_new = to.velocity->data();
    double           *a_new = to.acceleration->data();
    for (std::size_t i = 0; i < n; ++i)
      {
        a_new[i] = a[i];
        v_new[i] = v[i] + dt * a[i];
        u_new[i] = u[i] + dt * v_new[i];
      }
  }

  void RungeKutta::correct(const State  &from,
                           const Vector &increment,
                           const double  dt,
                           State        &trial) const
  {
    const TangentFactors f = factors(from, dt);
    add_multiple(1., increment, trial.displacement);
    add_multiple(f.damping, increment, *trial.velocity);
    add_multiple(f.mass, increment, *trial.acceleration);
  }

  std::optional<std::string> RungeKutta::note_on_rigid_parts() const
  {
    return "Their motion is of second to third order only; Scheme = newmark is "
           "as accurate at the same cost.";
  }

  double RungeKutta::amplification(const double angle) const
  {
    return std::abs(tableau.oscillation(angle).back());
  }

  double RungeKutta::error_by_difference(const double angle) const
  {
    // For smaller angles error and difference have few digits; their ratio is
    // proportional to the angle.
    constexpr double smallest = 0.1;
    if (angle < smallest)
      return error_by_difference(smallest) * angle / smallest;
    const std::vector<std::complex<double>> stages = tableau.oscillation(angle);
    const std::complex<double>              difference =
      std::inner_product(stages.begin(),
                         stages.end(),
                         tableau.embedded_difference.begin(),
                         std::complex<double>());
    return error_of(stages, angle) / std::abs(angle * difference);
  }

  double RungeKutta::missed_phase(const double by_trapezoidal_rule) const
  {
    const double angle =
      2 * std::asin(std::min(1., std::sqrt(12 * by_trapezoidal_rule) / 2));
    if (angle == 0)
      return 0;
    return error_of(tableau.oscillation(angle), angle) / angle;
  }

  bool RungeKutta::estimates_errors() const
  {
    // Stiff damping lowers the order: the scheme of order 5 then differs too
    // little from its embedded scheme.
    return tableau.order <= 4;
  }
} // namespace auxfem
