#ifndef auxfem_mathematics_maxwell_element_h
#define auxfem_mathematics_maxwell_element_h

#include <complex>

namespace auxfem
{
  /**
   * A spring and a dashpot in series,
   *
   *   dF/dt + F / tau = k du/dt,   tau = c / k,
   *
   * with its force F (N) as internal variable. The functions below assume an
   * extension rate that is linear in the step, with given increment and end
   * rate; mean() assumes a constant rate. They are then exact for any step
   * length and any relaxation time >= 0. At zero relaxation time the dashpot
   * has no resistance and F = 0.
   */
  struct MaxwellElement
  {
    /** Stiffness k of the spring (N/m), > 0. */
    double stiffness;

    /** Relaxation time tau (s), >= 0. */
    double relaxation_time;

    /**
     * Update of the force in a step: F_new = decay F_old + stiffness du +
     * damping v, v being the rate at the end. With g = 1 - e^(-a), l = 2 (a -
     * g) / a^2 - g / a, which is a / 6 for short steps and 1 / a for long ones:
     */
    struct Step
    {
      double decay;     ///< e^(-a), with a = dt / tau
      double stiffness; ///< k (g / a - l) (N/m)
      double damping;   ///< k l dt (N s/m)
    };

    /** Coefficients of a step of length @p dt (s). */
    Step step(double dt) const;

    /** Update by Euler's backward rule at a Runge-Kutta stage: F_new = decay
     * F_base + damping v, v being the rate at the stage. */
    struct Stage
    {
      double decay;   ///< 1 / (1 + dt / tau)
      double damping; ///< decay k dt (N s/m)
    };

    /** Coefficients of a stage over @p dt (s). */
    Stage stage(double dt) const;

    /** Force (N) at the end of a step of @p dt (s) that starts with @p force
     * (N) and adds @p extension_increment (m) at a constant rate. */
    double
    at_constant_rate(double force, double extension_increment, double dt) const;

    /** Mean force of a step: F_mean = decay F_old + stiffness du. */
    struct Mean
    {
      double decay;     ///< g / a
      double stiffness; ///< k (a - g) / a^2 (N/m)
    };

    /** Mean force over a step of length @p dt (s) at a constant rate. */
    Mean mean(double dt) const;

    /** Complex stiffness (N/m) for motions e^(s t): k s tau / (1 + s tau). */
    std::complex<double> dynamic_stiffness(std::complex<double> s) const
    {
      return stiffness * s * relaxation_time / (1. + s * relaxation_time);
    }

    /** Energy in the spring (J) under @p force (N): F^2 / (2 k). */
    double stored_energy(double force) const;

    /** Rate dF/dt = k du/dt - F / tau (N/s) under @p force (N) at @p
     * extension_rate (m/s); 0 if the dashpot has no resistance. */
    double force_rate(double force, double extension_rate) const;

    /** Power lost in the dashpot (W) under @p force (N): F^2 / c, c = k tau. */
    double lost_power(double force) const;

    /**
     * Energy dissipated in a step (J): integral of F^2 / c over a step of @p dt
     * (s) that starts with @p force (N) and adds @p increment (m).
     * @param end_rate rate of extension at the end (m/s)
     */
    double dissipated_energy(double force,
                             double increment,
                             double end_rate,
                             double dt) const;
  };
} // namespace auxfem

#endif
