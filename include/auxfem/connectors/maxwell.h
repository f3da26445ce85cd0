#ifndef auxfem_connectors_maxwell_h
#define auxfem_connectors_maxwell_h

#include <auxfem/connectors/connector_law.h>

#include <vector>

namespace auxfem
{
  /**
   * A spring and a dashpot in series,
   *
   *   dF/dt + F / tau = k du/dt,   tau = c / k,
   *
   * with its force F (N) as internal variable. All functions below take the
   * rate of the extension u to be linear in the step, with the increment and
   * the rate at its end as given; mean() takes it to be constant. For such
   * motion they are exact for every step length from zero to infinity and every
   * relaxation time >= 0 (zero: the dashpot offers no resistance and F = 0).
   */
  struct MaxwellElement
  {
    /** Stiffness k of the spring (N/m), > 0. */
    double stiffness;

    /** Relaxation time tau (s), >= 0. */
    double relaxation_time;

    /** What a step makes of the force:
     * F_new = decay F_old + stiffness du + damping v, v the rate at the end.
     * With g = 1 - e^(-a) and l = 2 (a - g) / a^2 - g / a, which is a / 6 for
     * short steps and 1 / a for long ones: */
    struct Step
    {
      double decay;     ///< e^(-a), with a = dt / tau
      double stiffness; ///< k (g / a - l) (N/m)
      double damping;   ///< k l dt (N s/m)
    };

    /** Coefficients of a step of length @p dt (s). */
    Step step(double dt) const;

    /** Of Euler's backward rule, which a stage of a Runge-Kutta step goes by:
     * F_new = decay F_base + damping v, v the rate at the stage. */
    struct Stage
    {
      double decay;   ///< 1 / (1 + dt / tau)
      double damping; ///< decay k dt (N s/m)
    };

    /** Coefficients of a stage over @p dt (s). */
    Stage stage(double dt) const;

    /** Force (N) at the end of a step of length @p dt (s) that starts with
     * @p force (N) and adds @p extension_increment (m) at a constant rate. */
    double
    at_constant_rate(double force, double extension_increment, double dt) const;

    /** Of a mean force: F_mean = decay F_old + stiffness du. */
    struct Mean
    {
      double decay;     ///< g / a
      double stiffness; ///< k (a - g) / a^2 (N/m)
    };

    /** Mean force over a step of length @p dt (s) at a constant rate. */
    Mean mean(double dt) const;

    /** Force over extension (N/m) where both go as e^(s t):
     * k s tau / (1 + s tau). */
    std::complex<double> dynamic_stiffness(std::complex<double> s) const
    {
      return stiffness * s * relaxation_time / (1. + s * relaxation_time);
    }

    /** Energy in the spring (J) under @p force (N): F^2 / (2 k). */
    double stored_energy(double force) const;

    /**
     * dF/dt = k du/dt - F / tau (N/s) under @p force (N), the extension growing
     * at @p extension_rate (m/s); 0 if the dashpot offers no resistance.
     */
    double force_rate(double force, double extension_rate) const;

    /** Power lost in the dashpot (W) under @p force (N): F^2 / c, c = k tau. */
    double lost_power(double force) const;

    /**
     * Energy lost in the dashpot (J), the integral of F^2 / c over the step
     * that @p motion describes and that starts with @p force (N).
     */
    double dissipated_energy(double force, const ConnectorMotion &motion) const;
  };

  /**
   * A spring (possibly of zero stiffness) side by side with Maxwell elements,
   *
   *   F = Kinf u + sum_i F_i,   dF_i/dt + F_i / tau_i = k_i du/dt,
   *
   * (Prony series of the relaxation function). With one element this is the
   * standard linear solid, without the spring the Maxwell law. The internal
   * variables of a connector are the forces F_i in the order of @p elements.
   */
  std::unique_ptr<ConnectorLaw>
  make_generalized_maxwell_law(double                      long_time_stiffness,
                               std::vector<MaxwellElement> elements);
} // namespace auxfem

#endif
