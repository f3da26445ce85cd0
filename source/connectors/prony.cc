#include <auxfem/connectors/laws.h>
#include <auxfem/connectors/maxwell_element.h>
#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/errors.h>

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

    /**
     * [a - 2 (1 - e^(-a)) + (1 - e^(-2a)) / 2] / a^2, the loss due to the
     * extension alone. It behaves as a / 3 for a -> 0 and 1 / a for large a.
     */
    double loss_coefficient(const double a)
    {
      if (a < 0.5)
        {
          // The closed form would lose 3 eps / a^2 to cancellation. Terms of
          // the series: (-1)^(n+1) (2^(n-1) - 2) / n! a^(n-2), n = 3, 4, ...;
          // at a = 0.5 the 18th is below 1e-16 of the sum.
          double sum = 0, term = a / 6, power_of_two = 4;
          for (unsigned int n = 3; n <= 18; ++n)
            {
              sum += term * (power_of_two - 2);
              term *= -a / (n + 1);
              power_of_two *= 2;
            }
          return sum;
        }
      const double relaxed = -std::expm1(-a);
      return (1 - relaxed * (1 + 0.5 * relaxed) / a) / a;
    }

    /**
     * [a - (1 - e^(-a))] / a^2, the mean of (1 - e^(-as)) / a over s from 0 to
     * 1: 1/2 for a -> 0 and 1 / a for large a.
     */
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

    /** Spring side by side with Maxwell elements; see maxwell_element.h. */
    class GeneralizedMaxwell : public ConnectorLaw
    {
    public:
      GeneralizedMaxwell(const double                stiffness,
                         std::vector<MaxwellElement> elements)
        : stiffness(stiffness)
        , elements(std::move(elements))
      {}

      unsigned int n_history() const override
      {
        return elements.size();
      }

      bool is_linear() const override
      {
        return true;
      }

      bool is_viscous() const override
      {
        return true;
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double          *committed,
                    double                *trial,
                    ConnectorResponse     *response) const override
      {
        if (n == 0)
          return;
        for (unsigned int i = 0; i < n; ++i)
          response[i] = {stiffness * motion[i].extension, stiffness, 0};
        for (unsigned int element = 0; element < elements.size(); ++element)
          add_element(element, n, motion, committed, trial, response);
      }

      void evaluate_mean(const unsigned int     n,
                         const ConnectorMotion *motion,
                         const double          *committed,
                         double                *trial,
                         ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const double increment =
              motion[i].extension - motion[i].previous_extension;
            response[i] = {stiffness *
                             (motion[i].previous_extension +
                              motion[i].extension) /
                             2,
                           stiffness / 2,
                           0};
            for (unsigned int e = 0; e < elements.size(); ++e)
              {
                const auto place = std::size_t(i) * elements.size() + e;
                const MaxwellElement::Step step =
                                             elements[e].step(motion[i].dt),
                                           mean =
                                             elements[e].mean(motion[i].dt);
                trial[place] =
                  step.decay * committed[place] + step.stiffness * increment;
                response[i].force +=
                  mean.decay * committed[place] + mean.stiffness * increment;
                response[i].stiffness += mean.stiffness;
              }
          }
      }

      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double          *committed,
                             const double          *trial) const override
      {
        ConnectorEnergy energy = {0.5 * stiffness * motion.extension *
                                    motion.extension,
                                  0};
        const double increment = motion.extension - motion.previous_extension;
        for (unsigned int i = 0; i < elements.size(); ++i)
          {
            energy.stored += elements[i].stored_energy(trial[i]);
            energy.dissipated +=
              elements[i].dissipated_energy(committed[i], increment, motion.dt);
          }
        return energy;
      }

      ContinuousResponse continuous(const double  extension,
                                    const double  rate,
                                    const double *internal,
                                    double       *internal_rates) const override
      {
        ContinuousResponse response = {stiffness * extension,
                                       0.5 * stiffness * extension * extension,
                                       0};
        for (unsigned int i = 0; i < elements.size(); ++i)
          {
            internal_rates[i] = elements[i].force_rate(internal[i], rate);
            // Without resistance of the dashpot there is no force either.
            if (elements[i].relaxation_time == 0)
              continue;
            response.force += internal[i];
            response.stored += elements[i].stored_energy(internal[i]);
            response.lost_power += elements[i].lost_power(internal[i]);
          }
        return response;
      }

      double long_time_stiffness() const override
      {
        return stiffness;
      }

    private:
      /** Adds force and tangent of one element to those of all connectors. */
      void add_element(const unsigned int     element,
                       const unsigned int     n,
                       const ConnectorMotion *motion,
                       const double          *committed,
                       double                *trial,
                       ConnectorResponse     *response) const
      {
        // Connectors share the step, so the exponential is needed once.
        double               dt   = motion[0].dt;
        MaxwellElement::Step step = elements[element].step(dt);
        for (unsigned int i = 0; i < n; ++i)
          {
            if (motion[i].dt != dt)
              {
                dt   = motion[i].dt;
                step = elements[element].step(dt);
              }
            const auto   place = std::size_t(i) * elements.size() + element;
            const double increment =
              motion[i].extension - motion[i].previous_extension;
            trial[place] =
              step.decay * committed[place] + step.stiffness * increment;
            response[i].force += trial[place];
            response[i].stiffness += step.stiffness;
          }
      }

      const double                      stiffness; ///< Kinf (N/m)
      const std::vector<MaxwellElement> elements;
    };

    const Quantity long_time_stiffness{"Long-time stiffness",
                                       "0",
                                       "N/m",
                                       Range::non_negative(),
                                       "Stiffness of the spring beside the "
                                       "Maxwell elements."};

    const QuantityList stiffnesses{"Stiffnesses",
                                   "",
                                   "N/m",
                                   Range::positive(),
                                   1,
                                   std::numeric_limits<unsigned int>::max(),
                                   "Stiffness of the spring in each Maxwell "
                                   "element."};

    const QuantityList relaxation_times{
      "Relaxation times",
      "",
      "s",
      Range::positive(),
      1,
      std::numeric_limits<unsigned int>::max(),
      "Damping coefficient over stiffness in "
      "each Maxwell element."};

    void declare_generalized_maxwell(dealii::ParameterHandler &prm)
    {
      declare(prm, long_time_stiffness);
      declare(prm, stiffnesses);
      declare(prm, relaxation_times);
    }

    std::unique_ptr<ConnectorLaw>
    make_generalized_maxwell(dealii::ParameterHandler &prm,
                             const SceneContext       &context)
    {
      const std::vector<double> k   = get(prm, stiffnesses);
      const std::vector<double> tau = get(prm, relaxation_times);
      if (k.size() != tau.size())
        throw InputError(
          context.path + ": '" + stiffnesses.name + "' has " +
          std::to_string(k.size()) + " values, '" + relaxation_times.name +
          "' has " + std::to_string(tau.size()) +
          ".\nEach Maxwell element needs one stiffness and one relaxation "
          "time: give lists of equal length.");

      std::vector<MaxwellElement> elements;
      for (unsigned int i = 0; i < k.size(); ++i)
        elements.push_back({k[i], tau[i]});
      return make_generalized_maxwell_law(get(prm, long_time_stiffness),
                                          std::move(elements));
    }
  } // namespace

  MaxwellElement::Step MaxwellElement::step(const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time);
    if (a == 0)
      return {1, stiffness};
    return {std::exp(-a), stiffness * (-std::expm1(-a) / a)};
  }

  MaxwellElement::Step MaxwellElement::mean(const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time);
    if (a == 0)
      return {1, stiffness / 2};
    return {-std::expm1(-a) / a, stiffness * mean_coefficient(a)};
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
                                           const double extension_increment,
                                           const double dt) const
  {
    const double a = reduced_time(dt, relaxation_time);
    if (a == 0)
      return 0;

    // With F(s) = F0 e^(-s/tau) + (G/a) (1 - e^(-s/tau)), G = k du, the
    // integral of F^2 / c is a quadratic form in F0 and G. Written in G and not
    // in the force G / a of steady flow, it stays finite for a -> 0.
    const double G       = stiffness * extension_increment;
    const double relaxed = -std::expm1(-a);
    return (force * force * relaxed * (1 - 0.5 * relaxed) +
            force * G * relaxed * (relaxed / a) + G * G * loss_coefficient(a)) /
      stiffness;
  }

  std::unique_ptr<ConnectorLaw>
  make_generalized_maxwell_law(const double                long_time_stiffness,
                               std::vector<MaxwellElement> elements)
  {
    return std::make_unique<GeneralizedMaxwell>(long_time_stiffness,
                                                std::move(elements));
  }

  RegistryEntry<ConnectorLaw> generalized_maxwell_entry()
  {
    return {"generalized-maxwell",
            "Spring side by side with any number of Maxwell elements (Prony "
            "series).",
            &declare_generalized_maxwell,
            &make_generalized_maxwell};
  }
} // namespace auxfem
