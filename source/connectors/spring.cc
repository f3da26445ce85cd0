#include <auxfem/connectors/laws.h>

namespace auxfem
{
  namespace
  {
    /** Linear spring: F = K u. */
    class Spring : public ConnectorLaw
    {
    public:
      explicit Spring(const double stiffness) : stiffness(stiffness)
      {}

      bool is_linear() const override
      {
        return true;
      }

      bool is_viscous() const override
      {
        return false;
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double * /*committed*/,
                    double * /*trial*/,
                    ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          response[i] = {stiffness * motion[i].extension, stiffness, 0};
      }

      void evaluate_mean(const unsigned int     n,
                         const ConnectorMotion *motion,
                         const double * /*committed*/,
                         double * /*trial*/,
                         ConnectorResponse *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          response[i] = {stiffness *
                           (motion[i].previous_extension +
                            motion[i].extension) /
                           2,
                         stiffness / 2,
                         0};
      }

      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double * /*committed*/,
                             const double * /*trial*/) const override
      {
        return {0.5 * stiffness * motion.extension * motion.extension, 0};
      }

      ContinuousResponse continuous(const double extension,
                                    const double /*rate*/,
                                    const double * /*internal*/,
                                    double * /*internal_rates*/) const override
      {
        return {stiffness * extension,
                0.5 * stiffness * extension * extension,
                0};
      }

      double long_time_stiffness() const override
      {
        return stiffness;
      }

      std::complex<double>
      dynamic_stiffness(const std::complex<double> /*s*/) const override
      {
        return stiffness;
      }

    private:
      const double stiffness; ///< K (N/m)
    };

    const Quantity spring_stiffness{"Spring stiffness",
                                    "",
                                    "N/m",
                                    Range::non_negative(),
                                    "Stiffness of the spring."};

    std::unique_ptr<ConnectorLaw> make_spring(ParameterValues &values)
    {
      return make_spring_law(values[spring_stiffness]);
    }
  } // namespace

  std::unique_ptr<ConnectorLaw> make_spring_law(const double stiffness)
  {
    return std::make_unique<Spring>(stiffness);
  }

  RegistryEntry<ConnectorLaw> spring_entry()
  {
    return {"spring",
            "Linear spring: force = stiffness times extension.",
            {spring_stiffness},
            make_spring};
  }
} // namespace auxfem
