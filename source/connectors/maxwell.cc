#include <auxfem/connectors/connector_law.h>
#include <auxfem/connectors/maxwell.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity maxwell_stiffness{
      "Spring stiffness",
      "",
      "N/m",
      Range::positive(),
      "Stiffness of the spring in series with the dashpot."};

    const Quantity maxwell_damping{
      "Damping coefficient",
      "",
      "N s/m",
      Range::non_negative(),
      "Dashpot force per rate of its own extension; below 0 it would create "
      "energy."};

    /** Spring and dashpot in series: dF/dt + (K/C) F = K du/dt. */
    std::unique_ptr<ConnectorLaw> make_maxwell(ParameterValues &values)
    {
      const double stiffness = values[maxwell_stiffness];
      const double damping   = values[maxwell_damping];
      return make_generalized_maxwell_law(0,
                                          {{stiffness, damping / stiffness}});
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

  double MaxwellElement::dissipated_energy(const double           force,
                                           const ConnectorMotion &motion) const
  {
    const double a = reduced_time(motion.dt, relaxation_time);
    if (a == 0 || std::isinf(a))
      return a == 0 ? 0 : stored_energy(force);

    const double increment = motion.extension - motion.previous_extension;
    return a / stiffness *
      mean_square(force,
                  {a,
                   stiffness * increment,
                   stiffness * (motion.rate * motion.dt - increment)});
  }

  RegistryEntry<ConnectorLaw> maxwell_entry()
  {
    return {"maxwell",
            "Spring and dashpot in series.",
            {maxwell_stiffness, maxwell_damping},
            make_maxwell};
  }
} // namespace auxfem
