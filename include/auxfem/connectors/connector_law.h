#ifndef auxfem_connectors_connector_law_h
#define auxfem_connectors_connector_law_h

#include <auxfem/parameters/registry.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace auxfem
{
  /** Motion of one connector in a step, the input of its law (SI). */
  struct ConnectorMotion
  {
    /** Extension at the end of the step (m). */
    double extension;
    /** Rate of extension at the end of the step (m/s). */
    double rate;
    /** Extension at the start of the step (m). */
    double previous_extension;
    /** Length of the step (s), 0 if no time passes. */
    double dt;
  };

  /** Force and tangents of one connector at the end of a step. */
  struct ConnectorResponse
  {
    /** Force (N), positive in tension. */
    double force;
    /** d force / d extension (N/m), at fixed rate. */
    double stiffness;
    /** d force / d rate (N s/m), at fixed extension. */
    double damping;
  };

  /** Energies of one connector in an accepted step (J). */
  struct ConnectorEnergy
  {
    /** Energy in the springs at the end of the step. */
    double stored;
    /** Energy lost in dashpots and friction during the step. */
    double dissipated;
  };

  /** Force, energy and power of one connector at an instant. */
  struct ContinuousResponse
  {
    /** Force (N), positive in tension. */
    double force;
    /** Energy in the springs (J). */
    double stored;
    /** Power lost in dashpots and friction (W). */
    double lost_power;
  };

  /**
   * The law of a connector: extension history to force. One object serves all
   * connectors of a group and holds parameters only. Internal variables are
   * stored in a flat array, n_history() numbers per connector, all zero at
   * rest.
   */
  class ConnectorLaw
  {
  public:
    virtual ~ConnectorLaw() = default;

    /** Number of internal variables per connector. */
    virtual unsigned int n_history() const
    {
      return 0;
    }

    /** Whether the force depends on rates: the law has a dashpot. */
    virtual bool is_viscous() const = 0;

    /** Whether the law loses energy. */
    virtual bool dissipates() const
    {
      return is_viscous();
    }

    /** Whether internal variables follow the extension by a return mapping
     * instead of a differential equation, as in friction. */
    virtual bool slips() const
    {
      return false;
    }

    /** Whether tangents jump or grow without bounds at some motions, so that
     * Newton's method needs a line search. */
    virtual bool has_kinks() const
    {
      return false;
    }

    /** Whether the force is linear in extension, rate and internal variables,
     * so that tangents are constant. */
    virtual bool is_linear() const = 0;

    /**
     * Computes force and tangents of @p n connectors at once.
     * @param committed n * n_history() internal variables at the start of the
     *   step
     * @param trial receives those at its end
     */
    virtual void evaluate(unsigned int           n,
                          const ConnectorMotion *motion,
                          const double          *committed,
                          double                *trial,
                          ConnectorResponse     *response) const = 0;

    /**
     * Same as evaluate() at a stage of a Runge-Kutta step. The internal
     * variables follow from @p base by Euler's backward rule, z = z_base +
     * motion.dt z', with z' from continuous(). Without internal variables this
     * is evaluate().
     */
    virtual void evaluate_stage(const unsigned int     n,
                                const ConnectorMotion *motion,
                                const double          *base,
                                double                *trial,
                                ConnectorResponse     *response) const
    {
      evaluate(n, motion, base, trial, response);
    }

    /**
     * Computes mean forces over a step with linear extension; arguments as in
     * evaluate(). Their work equals the change of energy(). The stiffness in @p
     * response is the derivative of the mean force by the extension at the end;
     * the damping is zero.
     */
    virtual void evaluate_mean(unsigned int           n,
                               const ConnectorMotion *motion,
                               const double          *committed,
                               double                *trial,
                               ConnectorResponse     *response) const = 0;

    /** Response (rate 0) of a connector that was extended from rest to @p
     * extension (m) and relaxed completely. */
    virtual ConnectorResponse relaxed(double extension) const = 0;

    /** Same as evaluate() in a static equilibrium after complete relaxation, in
     * which Maxwell elements carry nothing. */
    virtual void evaluate_relaxed(const unsigned int     n,
                                  const ConnectorMotion *motion,
                                  const double * /*committed*/,
                                  double            *trial,
                                  ConnectorResponse *response) const
    {
      for (unsigned int i = 0; i < n; ++i)
        response[i] = relaxed(motion[i].extension);
      std::fill_n(trial, std::size_t(n) * n_history(), 0.);
    }

    /** Energies of one connector in a step; arguments as in evaluate(). */
    virtual ConnectorEnergy energy(const ConnectorMotion &motion,
                                   const double          *committed,
                                   const double          *trial) const = 0;

    /**
     * The law of one connector as ordinary differential equations, for
     * integrators with their own steps. evaluate() with small steps converges
     * to its solution.
     * @param internal n_history() internal variables
     * @param internal_rates receives their rates
     */
    virtual ContinuousResponse continuous(double        extension,
                                          double        rate,
                                          const double *internal,
                                          double *internal_rates) const = 0;

    /** The elastic law that remains when the scene leaves out viscosity. Only
     * called for viscous laws. */
    virtual std::unique_ptr<ConnectorLaw> without_viscosity() const;

    /**
     * Complex stiffness (N/m): force over extension for small motions e^(s t),
     * s in 1/s, about a relaxed state.
     * @param extension of that state (m)
     */
    virtual std::complex<double> dynamic_stiffness(std::complex<double> s,
                                                   double extension) const = 0;

    /** Terms k s tau / (1 + s tau) of dynamic_stiffness(): k (N/m) by
     * relaxation time tau (s). */
    virtual std::map<double, double> relaxing_stiffnesses() const
    {
      return {};
    }
  };

  /** Registry of all laws (source/connectors/connector_law.cc). */
  const Registry<ConnectorLaw> &connector_law_registry();

  /** Linear spring (N/m). */
  std::unique_ptr<ConnectorLaw> make_spring_law(double stiffness);

  /**
   * @name Registry entries of the laws, one per file in source/connectors/.
   */
  ///@{
  RegistryEntry<ConnectorLaw> spring_entry();
  RegistryEntry<ConnectorLaw> dashpot_entry();
  RegistryEntry<ConnectorLaw> kelvin_voigt_entry();
  RegistryEntry<ConnectorLaw> maxwell_entry();
  RegistryEntry<ConnectorLaw> standard_linear_solid_entry();
  RegistryEntry<ConnectorLaw> generalized_maxwell_entry();
  RegistryEntry<ConnectorLaw> cubic_entry();
  RegistryEntry<ConnectorLaw> bilinear_entry();
  RegistryEntry<ConnectorLaw> gap_entry();
  RegistryEntry<ConnectorLaw> hook_entry();
  RegistryEntry<ConnectorLaw> tabulated_entry();
  RegistryEntry<ConnectorLaw> buckling_link_entry();
  RegistryEntry<ConnectorLaw> power_law_dashpot_entry();
  RegistryEntry<ConnectorLaw> friction_slider_entry();
  RegistryEntry<ConnectorLaw> expression_entry();
  ///@}

  /** Spring @p stiffness (N/m) and dashpot @p damping (N s/m) in parallel: F =
   * K u + C du/dt. Either may be zero. */
  std::unique_ptr<ConnectorLaw> make_kelvin_voigt_law(double stiffness,
                                                      double damping);
} // namespace auxfem

#endif
