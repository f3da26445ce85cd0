#include <auxfem/connectors/connector_law.h>


namespace auxfem
{
  namespace
  {
    /** Spring and dashpot in parallel: F = K u + C du/dt. */
    class KelvinVoigt : public ConnectorLaw
    {
    public:
      KelvinVoigt(const double stiffness, const double damping)
        : stiffness(stiffness)
        , damping(damping)
      {}

      bool is_linear() const override
      {
        return true;
      }

      bool is_viscous() const override
      {
        return damping > 0;
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double * /*committed*/,
                    double * /*trial*/,
                    ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          response[i] = {stiffness * motion[i].extension +
                           damping * motion[i].rate,
                         stiffness,
                         damping};
      }

      void evaluate_mean(const unsigned int     n,
                         const ConnectorMotion *motion,
                         const double * /*committed*/,
                         double * /*trial*/,
                         ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const ConnectorMotion &m = motion[i];
            response[i] = {stiffness * (m.previous_extension + m.extension) /
                               2 +
                             damping * (m.extension - m.previous_extension) /
                               m.dt,
                           stiffness / 2 + damping / m.dt,
                           0};
          }
      }

      /**
       * The dissipation uses the mean rate of the step. With
       * average-acceleration Newmark, stored and dissipated energy then equal
       * the trapezoidal work of the force.
       */
      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double * /*committed*/,
                             const double * /*trial*/) const override
      {
        const double stored =
          0.5 * stiffness * motion.extension * motion.extension;
        const double increment = motion.extension - motion.previous_extension;
        // A step of length zero dissipates nothing.
        if (increment == 0)
          return {stored, 0};
        return {stored, damping * increment * (increment / motion.dt)};
      }

      ContinuousResponse continuous(const double extension,
                                    const double rate,
                                    const double * /*internal*/,
                                    double * /*internal_rates*/) const override
      {
        return {stiffness * extension + damping * rate,
                0.5 * stiffness * extension * extension,
                damping * rate * rate};
      }

      ConnectorResponse relaxed(const double extension) const override
      {
        return {stiffness * extension, stiffness, 0};
      }

      std::complex<double>
      dynamic_stiffness(const std::complex<double> s,
                        const double /*extension*/) const override
      {
        return stiffness + s * damping;
      }

    private:
      const double stiffness; ///< K (N/m)
      const double damping;   ///< C (N s/m)
    };

    const Quantity kelvin_voigt_stiffness{
      "Spring stiffness",
      "",
      "N/m",
      Range::positive(),
      "Stiffness of the spring; for a dashpot "
      "alone set Law = dashpot."};

    const Quantity kelvin_voigt_damping{
      "Damping coefficient",
      "",
      "N s/m",
      Range::non_negative(),
      "Dashpot force per rate of extension; below 0 it would create energy."};

    std::unique_ptr<ConnectorLaw> make_kelvin_voigt(ParameterValues &values)
    {
      return make_kelvin_voigt_law(values[kelvin_voigt_stiffness],
                                   values[kelvin_voigt_damping]);
    }
  } // namespace

  std::unique_ptr<ConnectorLaw> make_kelvin_voigt_law(const double stiffness,
                                                      const double damping)
  {
    return std::make_unique<KelvinVoigt>(stiffness, damping);
  }

  RegistryEntry<ConnectorLaw> kelvin_voigt_entry()
  {
    return {"kelvin-voigt",
            "Spring and dashpot in parallel.",
            {kelvin_voigt_stiffness, kelvin_voigt_damping},
            make_kelvin_voigt};
  }
} // namespace auxfem
