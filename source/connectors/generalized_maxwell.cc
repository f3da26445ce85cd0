#include <auxfem/connectors/connector_law.h>
#include <auxfem/connectors/maxwell.h>
#include <auxfem/parameters/errors.h>

#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Spring in parallel with Maxwell elements; see maxwell.h. */
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

      void evaluate_stage(const unsigned int     n,
                          const ConnectorMotion *motion,
                          const double          *base,
                          double                *trial,
                          ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            response[i] = {stiffness * motion[i].extension, stiffness, 0};
            for (unsigned int e = 0; e < elements.size(); ++e)
              {
                const auto index = std::size_t(i) * elements.size() + e;
                const MaxwellElement::Stage stage =
                  elements[e].stage(motion[i].dt);
                trial[index] =
                  stage.decay * base[index] + stage.damping * motion[i].rate;
                response[i].force += trial[index];
                response[i].damping += stage.damping;
              }
          }
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
                const auto index = std::size_t(i) * elements.size() + e;
                const MaxwellElement::Mean mean =
                  elements[e].mean(motion[i].dt);
                trial[index] = elements[e].at_constant_rate(committed[index],
                                                            increment,
                                                            motion[i].dt);
                response[i].force +=
                  mean.decay * committed[index] + mean.stiffness * increment;
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
        for (unsigned int i = 0; i < elements.size(); ++i)
          {
            energy.stored += elements[i].stored_energy(trial[i]);
            energy.dissipated +=
              elements[i].dissipated_energy(committed[i],
                                            motion.extension -
                                              motion.previous_extension,
                                            motion.rate,
                                            motion.dt);
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
            // A dashpot without resistance carries no force.
            if (elements[i].relaxation_time == 0)
              continue;
            response.force += internal[i];
            response.stored += elements[i].stored_energy(internal[i]);
            response.lost_power += elements[i].lost_power(internal[i]);
          }
        return response;
      }

      ConnectorResponse relaxed(const double extension) const override
      {
        return {stiffness * extension, stiffness, 0};
      }

      std::complex<double>
      dynamic_stiffness(const std::complex<double> s,
                        const double /*extension*/) const override
      {
        std::complex<double> sum = stiffness;
        for (const MaxwellElement &element : elements)
          sum += element.dynamic_stiffness(s);
        return sum;
      }

      std::map<double, double> relaxing_stiffnesses() const override
      {
        std::map<double, double> stiffnesses;
        for (const MaxwellElement &element : elements)
          if (element.stiffness > 0 && element.relaxation_time > 0)
            stiffnesses[element.relaxation_time] += element.stiffness;
        return stiffnesses;
      }

    private:
      /** Adds force and tangent of one element to the responses of all
       * connectors. */
      void add_element(const unsigned int     element,
                       const unsigned int     n,
                       const ConnectorMotion *motion,
                       const double          *committed,
                       double                *trial,
                       ConnectorResponse     *response) const
      {
        // All connectors share the step, so compute the exponential once.
        double               dt   = motion[0].dt;
        MaxwellElement::Step step = elements[element].step(dt);
        for (unsigned int i = 0; i < n; ++i)
          {
            if (motion[i].dt != dt)
              {
                dt   = motion[i].dt;
                step = elements[element].step(dt);
              }
            const auto   index = std::size_t(i) * elements.size() + element;
            const double increment =
              motion[i].extension - motion[i].previous_extension;
            trial[index] = step.decay * committed[index] +
              step.stiffness * increment + step.damping * motion[i].rate;
            response[i].force += trial[index];
            response[i].stiffness += step.stiffness;
            response[i].damping += step.damping;
          }
      }

      const double                      stiffness; ///< Kinf (N/m)
      const std::vector<MaxwellElement> elements;
    };

    const Quantity long_time_stiffness{"Long-time stiffness",
                                       "0",
                                       "N/m",
                                       Range::non_negative(),
                                       "Stiffness of the parallel spring."};

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
      "Damping coefficient over stiffness of each Maxwell element."};

    std::unique_ptr<ConnectorLaw>
    make_generalized_maxwell(ParameterValues &values)
    {
      const std::vector<double> k   = values[stiffnesses];
      const std::vector<double> tau = values[relaxation_times];
      if (k.size() != tau.size())
        throw InputError(
          values.context.path + ": '" + stiffnesses.name + "' has " +
          std::to_string(k.size()) + " values, '" + relaxation_times.name +
          "' has " + std::to_string(tau.size()) +
          ".\nEach Maxwell element needs one stiffness and one relaxation "
          "time: give lists of equal length.");

      std::vector<MaxwellElement> elements;
      for (unsigned int i = 0; i < k.size(); ++i)
        elements.push_back({k[i], tau[i]});
      return make_generalized_maxwell_law(values[long_time_stiffness],
                                          std::move(elements));
    }
  } // namespace

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
            "Spring in parallel with any number of Maxwell elements (Prony "
            "series).",
            {long_time_stiffness, stiffnesses, relaxation_times},
            make_generalized_maxwell};
  }
} // namespace auxfem
