#ifndef auxfem_tests_connectors_law_on_trial_h
#define auxfem_tests_connectors_law_on_trial_h

#include <auxfem/connectors/connector_law.h>

#include <support/parameter_values.h>

#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace auxfem
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  using LawParameters = std::map<std::string, std::string>;

  /** The law @p name of the table, made from its own subsection. */
  inline std::unique_ptr<ConnectorLaw> make_law(const std::string   &name,
                                                const LawParameters &values)
  {
    for (const RegistryEntry<ConnectorLaw> &entry : connector_law_registry())
      if (entry.name == name)
        {
          SceneContext context;
          context.path = "Connectors/damper";
          std::string text;
          for (const auto &[key, value] : values)
            text += "set " + key + " = " + value + "\n";
          ParameterValues given =
            values_from_text(entry.parameters, text, context);
          return entry.make(given);
        }
    throw std::logic_error("no law " + name);
  }

  /** One connector that is led through a motion step by step. */
  class LawOnTrial
  {
  public:
    explicit LawOnTrial(std::unique_ptr<ConnectorLaw> law)
      : law(std::move(law))
      , history(this->law->n_history(), 0.)
    {}

    /** Extends to @p new_extension in @p dt and commits. */
    ConnectorResponse
    step(const double new_extension, const double rate, const double dt)
    {
      const ConnectorMotion motion = {new_extension, rate, extension, dt};
      std::vector<double>   trial(history.size());
      ConnectorResponse     response;
      law->evaluate(1, &motion, history.data(), trial.data(), &response);
      const ConnectorEnergy energy =
        law->energy(motion, history.data(), trial.data());
      work += 0.5 * (force + response.force) * (new_extension - extension);
      stored = energy.stored;
      dissipated += energy.dissipated;
      history   = trial;
      extension = new_extension;
      force     = response.force;
      return response;
    }

    /** The same at a constant rate, none if no time passes or for ever. */
    ConnectorResponse ramp(const double new_extension, const double dt)
    {
      return step(new_extension,
                  dt > 0 ? (new_extension - extension) / dt : 0.,
                  dt);
    }

    const std::unique_ptr<ConnectorLaw> law;
    std::vector<double>                 history;
    double                              extension = 0;
    double                              force     = 0;
    /** Work of the force by the trapezoidal rule, and energies, so far (J). */
    double work = 0, stored = 0, dissipated = 0;
  };
} // namespace auxfem

#endif
