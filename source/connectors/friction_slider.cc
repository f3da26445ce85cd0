#include <auxfem/connectors/connector_law.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Spring and friction slider in series, beside a spring: F = h u + f, f = k
     * (u - z), |f| <= F0 (Jenkins element). The internal variable is the slip
     * z.
     */
    class FrictionSlider : public ConnectorLaw
    {
    public:
      FrictionSlider(const double stiffness,
                     const double slip_force,
                     const double hardening)
        : stiffness(stiffness)
        , slip_force(slip_force)
        , hardening(hardening)
      {}

      unsigned int n_history() const override
      {
        return 1;
      }

      bool is_linear() const override
      {
        return false;
      }

      bool is_viscous() const override
      {
        return false;
      }

      bool dissipates() const override
      {
        return true;
      }

      bool slips() const override
      {
        return true;
      }

      bool has_kinks() const override
      {
        return true;
      }

      void evaluate(const unsigned int     n,
                    const ConnectorMotion *motion,
                    const double          *committed,
                    double                *trial,
                    ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const double u    = motion[i].extension;
            trial[i]          = slip(u, committed[i]);
            const bool sticks = trial[i] == committed[i];
            response[i]       = {hardening * u + stiffness * (u - trial[i]),
                                 hardening + (sticks ? stiffness : 0.),
                                 0};
          }
      }

      /** Mean over a linear course, which slips in its last part if at all. */
      void evaluate_mean(const unsigned int     n,
                         const ConnectorMotion *motion,
                         const double          *committed,
                         double                *trial,
                         ConnectorResponse     *response) const override
      {
        for (unsigned int i = 0; i < n; ++i)
          {
            const double from = motion[i].previous_extension,
                         to   = motion[i].extension;
            trial[i]          = slip(to, committed[i]);
            // The slider slips on the rest of the way.
            const double way     = to - from;
            const double slipped = trial[i] - committed[i];
            const double sticking =
              slipped == 0 ? 1. : std::clamp(1 - slipped / way, 0., 1.);
            const double end_force = stiffness * (to - trial[i]);
            response[i]            = {hardening * (from + to) / 2 + end_force -
                                        stiffness * way * sticking * sticking / 2,
                                      (hardening + stiffness * sticking * sticking) / 2,
                                      0};
          }
      }

      void evaluate_relaxed(const unsigned int     n,
                            const ConnectorMotion *motion,
                            const double          *committed,
                            double                *trial,
                            ConnectorResponse     *response) const override
      {
        evaluate(n, motion, committed, trial, response);
      }

      ConnectorEnergy energy(const ConnectorMotion &motion,
                             const double          *committed,
                             const double          *trial) const override
      {
        return {stored(motion.extension, *trial),
                slip_force * std::abs(*trial - *committed)};
      }

      ContinuousResponse continuous(const double  extension,
                                    const double  rate,
                                    const double *internal,
                                    double       *internal_rates) const override
      {
        const double f = stiffness * (extension - *internal);
        *internal_rates =
          std::abs(f) >= slip_force * (1 - few_round_offs) && f * rate > 0
          ? rate
          : 0.;
        return {hardening * extension + f,
                stored(extension, *internal),
                f * *internal_rates};
      }

      ConnectorResponse relaxed(const double extension) const override
      {
        const double z = slip(extension, 0);
        return {hardening * extension + stiffness * (extension - z),
                hardening + (z == 0 ? stiffness : 0.),
                0};
      }

      /** Small motions stick. */
      std::complex<double>
      dynamic_stiffness(const std::complex<double> /*s*/,
                        const double /*extension*/) const override
      {
        return hardening + stiffness;
      }

    private:
      /** Slip at @p extension (m) after the slip @p before; it does not creep
       * by round-off. */
      double slip(const double extension, const double before) const
      {
        const double force = stiffness * (extension - before);
        const double tolerance =
          few_round_offs * stiffness * (std::abs(extension) + std::abs(before));
        if (std::abs(force) <= slip_force + tolerance)
          return before;
        return extension - std::copysign(slip_force / stiffness, force);
      }

      double stored(const double extension, const double z) const
      {
        const double stretch = extension - z;
        return hardening / 2 * extension * extension +
          stiffness / 2 * stretch * stretch;
      }

      const double stiffness;  ///< k (N/m)
      const double slip_force; ///< F0 (N)
      const double hardening;  ///< h (N/m)
    };

    const Quantity slider_stiffness{
      "Spring stiffness",
      "",
      "N/m",
      Range::positive(),
      "Stiffness of the spring in series with the slider."};

    const Quantity slip_force{"Slip force",
                              "",
                              "N",
                              Range::positive(),
                              "Force at which the slider slips."};

    const Quantity hardening_stiffness{
      "Hardening stiffness",
      "0 N/m",
      "N/m",
      Range::non_negative(),
      "Stiffness of a spring beside both: the force rises with it during slip."};

    std::unique_ptr<ConnectorLaw> make_friction_slider(ParameterValues &values)
    {
      return std::make_unique<FrictionSlider>(values[slider_stiffness],
                                              values[slip_force],
                                              values[hardening_stiffness]);
    }
  } // namespace

  RegistryEntry<ConnectorLaw> friction_slider_entry()
  {
    return {
      "friction-slider",
      "Spring and friction slider in series (elastic, perfectly plastic), "
      "if wanted beside a spring.",
      {slider_stiffness, slip_force, hardening_stiffness},
      make_friction_slider};
  }
} // namespace auxfem
