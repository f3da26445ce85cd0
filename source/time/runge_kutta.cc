#include <auxfem/time/runge_kutta.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace auxfem
{
  namespace
  {
    /** @p vector becomes A times it. */
    std::vector<double> product(const ButcherTableau      &tableau,
                                const std::vector<double> &vector)
    {
      std::vector<double> result(vector.size());
      for (std::size_t i = 0; i < vector.size(); ++i)
        result[i] = std::inner_product(tableau.factors[i].begin(),
                                       tableau.factors[i].end(),
                                       vector.begin(),
                                       0.);
      return result;
    }
  } // namespace

  double ButcherTableau::missed_growth(const unsigned int i,
                                       const unsigned int j) const
  {
    const double below = j <= i ? weights[i] * factors[i][j] : 0,
                 above = i <= j ? weights[j] * factors[j][i] : 0;
    return below + above - weights[i] * weights[j];
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
           "as accurate for the same time.";
  }

  std::complex<double> RungeKutta::response(const double angle) const
  {
    // y' = i angle y over a step of length one, y_0 = 1.
    const std::complex<double>        lambda(0, angle);
    std::vector<std::complex<double>> values(tableau.n_stages(), 1.);
    for (unsigned int i = 1; i < tableau.n_stages(); ++i)
      {
        for (unsigned int j = 0; j < i; ++j)
          values[i] += tableau.factors[i][j] * lambda * values[j];
        values[i] /= 1. - tableau.diagonal * lambda;
      }
    return values.back();
  }

  double RungeKutta::amplification(const double angle) const
  {
    return std::abs(response(angle));
  }

  double RungeKutta::missed_way(const double by_trapezoidal_rule) const
  {
    const double angle =
      2 * std::asin(std::min(1., std::sqrt(12 * by_trapezoidal_rule) / 2));
    if (angle == 0)
      return 0;
    return std::abs(response(angle) -
                    std::exp(std::complex<double>(0, angle))) /
      angle;
  }

  std::optional<double> RungeKutta::error_constant() const
  {
    // Where stiff damping lowers the order, that of order 5 differs too little
    // from its embedded scheme: errors were 30 times the estimate.
    if (tableau.order > 4)
      return {};
    std::vector<double> powers(tableau.n_stages(), 1.); // A^k 1
    double              exact = 1;                      // 1 / (k + 1)!
    for (unsigned int k = 1; k < tableau.order; ++k)
      {
        powers = product(tableau, powers);
        exact /= k + 1;
      }
    const auto along = [&powers](const std::vector<double> &weights) {
      return std::inner_product(weights.begin(),
                                weights.end(),
                                powers.begin(),
                                0.);
    };
    const double embedded = along(tableau.embedded_difference);
    powers                = product(tableau, powers);
    exact /= tableau.order + 1;
    return (along(tableau.weights) - exact) / embedded;
  }
} // namespace auxfem
