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

  /** Creates the law @p name of the registry from its own subsection. */
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

  /** One connector that follows a motion step by step. */
  class LawOnTrial
  {
  public:
    explicit LawOnTrial(std::unique_ptr<ConnectorLaw> law)
      : law(std::move(law))
      , history(this->law->n_history(), 0.)
    {}

    /** Extends to @p new_extension in @p dt and commits the step. */
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

    /**
     * Extends at a constant rate; the rate is zero if dt is zero or infinite.
     */
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
    /** Trapezoidal work of the force and energies since the start (J). */
    double work = 0, stored = 0, dissipated = 0;
  };
} // namespace auxfem

#endif
