#include <auxfem/mathematics/maxwell_element.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** dt / tau; infinite for a dashpot without resistance, even if dt = 0. */
    double reduced_time(const double dt, const double relaxation_time)
    {
      return relaxation_time > 0 ? dt / relaxation_time
                                 : std::numeric_limits<double>::infinity();
    }

    /** [a - (1 - e^(-a))] / a^2, the mean of (1 - e^(-as)) / a over s from 0 to
     * 1: 1/2 for a -> 0 and 1 / a for large a. */
    double mean_coefficient(const double a)
    {
      if (a < 0.5)
        {
          // The closed form would lose eps / a^2 to cancellation. Terms of the
          // series: (-a)^n / (n + 2)!; at a = 0.5 the 14th is below 1e-17.
          double sum = 0, term = 0.5;
          for (unsigned int n = 0; n < 14; ++n)
            {
              sum += term;
              term *= -a / (n + 3);
            }
          return sum;
        }
      return (1 + std::expm1(-a) / a) / a;
    }

    /** (1 - e^(-a)) / a, the mean of e^(-as) over s from 0 to 1. */
    double mean_decay(const double a)
    {
      return a == 0 ? 1 : -std::expm1(-a) / a;
    }

    /** Motion of an element in a step: forces k u (N), and a = dt / tau. */
    struct Extension
    {
      double a;
      double increment; ///< force increment
      double lead; ///< excess of the end rate over the mean rate, times k dt
    };

    /** Force at the fraction @p s in [0, 1] of a step that starts with @p
     * force. */
    double
    force_at(const double s, const double force, const Extension &extension)
    {
      return std::exp(-extension.a * s) * force +
        (extension.increment - extension.lead) * s *
        mean_decay(extension.a * s) +
        2 * extension.lead * s * s * mean_coefficient(extension.a * s);
    }

    /** Integral of the squared force over s from 0 to 1. */
    double mean_square(const double force, const Extension &extension)
    {
      const double a = extension.a;
      // The closed form would lose eps / a^4 to cancellation. The quadrature is
      // exact to round-off.
      if (a < 0.5)
        return boost::math::quadrature::gauss<double, 7>::integrate(
          [&](const double s) {
            const double now = force_at(s, force, extension);
            return now * now;
          },
          0.,
          1.);
      // The force is flow + slope s + rest e^(-as).
      const double slope = 2 * extension.lead / a,
                   flow  = (extension.increment - extension.lead - slope) / a,
                   rest  = force - flow;
      return flow * flow + flow * slope + slope * slope / 3 +
        2 * rest *
        (flow * mean_decay(a) + slope * (mean_decay(a) - std::exp(-a)) / a) +
        rest * rest * mean_decay(2 * a);
    }
  } // namespace

  MaxwellElement::Step MaxwellElement::step(const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time), steady = mean_decay(a),
                 lead = 2 * mean_coefficient(a) - steady;
    return {std::exp(-a),
            stiffness * (steady - lead),
            stiffness * (std::isinf(a) ? relaxation_time : lead * dt)};
  }

  MaxwellElement::Stage MaxwellElement::stage(const double dt) const
  {
    const double decay = 1 / (1 + reduced_time(dt, relaxation_time));
    return {decay, decay * stiffness * dt};
  }

  double MaxwellElement::at_constant_rate(const double force,
                                          const double extension_increment,
                                          const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time);
    return std::exp(-a) * force +
      stiffness * mean_decay(a) * extension_increment;
  }

  MaxwellElement::Mean MaxwellElement::mean(const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time);
    return {mean_decay(a), stiffness * mean_coefficient(a)};
  }

  double MaxwellElement::stored_energy(const double force) const
  {
    return 0.5 * force * force / stiffness;
  }

  double MaxwellElement::force_rate(const double force,
                                    const double extension_rate) const
  {
    return relaxation_time > 0
      ? stiffness * extension_rate - force / relaxation_time
      : 0.;
  }

  double MaxwellElement::lost_power(const double force) const
  {
    return relaxation_time > 0 ? force * force / (stiffness * relaxation_time)
                               : 0.;
  }

  double MaxwellElement::dissipated_energy(const double force,
                                           const double increment,
                                           const double end_rate,
                                           const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time);
    if (a == 0 || std::isinf(a))
      return a == 0 ? 0 : stored_energy(force);
    return a / stiffness *
      mean_square(force,
                  {a,
                   stiffness * increment,
                   stiffness * (end_rate * dt - increment)});
  }
} // namespace auxfem
