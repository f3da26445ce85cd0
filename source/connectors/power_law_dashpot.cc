#include <auxfem/connectors/connector_law.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    /** F = C v (v^2 + s^2)^((a - 1) / 2) with v = du/dt: C |v|^a sign v for
     * rates far above the smoothing rate s. */
    class PowerLawDashpot : public ConnectorLaw
    {
    public:
      PowerLawDashpot(const double coefficient,
                      const double exponent,
                      const double smoothing)
        : coefficient(coefficient)
        , exponent(exponent)
        , smoothing(smoothing)
      {}

      bool is_linear() const override
      {
        return false;
      }

      bool is_viscous() const override
      {
        return true;
      }

      bool has_kinks() const override
      {
        return exponent < 1;
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double * /*committed*/,
                    double * /*trial*/,
                    ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          response[i] = {force(motion[i].rate), 0, slope(motion[i].rate)};
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
            const double rate = (m.extension - m.previous_extension) / m.dt;
            response[i]       = {force(rate), slope(rate) / m.dt, 0};
          }
      }

      /** The dissipation uses the mean rate of the step. */
      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double * /*committed*/,
                             const double * /*trial*/) const override
      {
        const double increment = motion.extension - motion.previous_extension;
        // A step of length zero dissipates nothing.
        if (increment == 0)
          return {0, 0};
        return {0, force(increment / motion.dt) * increment};
      }

      ContinuousResponse continuous(const double /*extension*/,
                                    const double rate,
                                    const double * /*internal*/,
                                    double * /*internal_rates*/) const override
      {
        return {force(rate), 0, force(rate) * rate};
      }

      ConnectorResponse relaxed(const double /*extension*/) const override
      {
        return {0, 0, 0};
      }

      std::complex<double>
      dynamic_stiffness(const std::complex<double> s,
                        const double /*extension*/) const override
      {
        return s * slope(0);
      }

    private:
      double force(const double v) const
      {
        return coefficient * v *
          std::pow(v * v + smoothing * smoothing, (exponent - 1) / 2);
      }

      /** d force / d rate (N s/m). */
      double slope(const double v) const
      {
        const double square = v * v + smoothing * smoothing;
        return coefficient * (exponent * v * v + smoothing * smoothing) /
          square * std::pow(square, (exponent - 1) / 2);
      }

      const double coefficient; ///< C (N (s/m)^a)
      const double exponent;    ///< a
      const double smoothing;   ///< s (m/s)
    };

    const Quantity power_law_coefficient{
      "Force at unit rate",
      "",
      "N",
      Range::positive(),
      "Force at a rate of extension of 1 m/s."};

    const Quantity power_law_exponent{
      "Exponent",
      "",
      "1",
      Range::open(0, 10),
      "Power of the rate of extension: 2 for orifices, 0.1 to 0.5 for dampers "
      "of buildings."};

    const Quantity smoothing_rate{
      "Smoothing rate",
      "0.1 mm/s",
      "m/s",
      Range::positive(),
      "Rate of extension far below which the dashpot is linear, so that its "
      "tangent at rest is finite; modes see the damping there."};

    std::unique_ptr<ConnectorLaw>
    make_power_law_dashpot(ParameterValues &values)
    {
      return std::make_unique<PowerLawDashpot>(values[power_law_coefficient],
                                               values[power_law_exponent],
                                               values[smoothing_rate]);
    }
  } // namespace

  RegistryEntry<ConnectorLaw> power_law_dashpot_entry()
  {
    return {"power-law-dashpot",
            "Dashpot whose force is a power of the rate of extension.",
            {power_law_coefficient, power_law_exponent, smoothing_rate},
            make_power_law_dashpot};
  }
} // namespace auxfem
