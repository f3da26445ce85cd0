#ifndef auxfem_connectors_connector_law_h
#define auxfem_connectors_connector_law_h

#include <auxfem/parameters/registry.h>

#include <complex>
#include <map>
#include <vector>

namespace auxfem
{
  /** What happens to one connector in a step, as its law needs it (SI). */
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

  /** Answer of a law for one connector at the end of a step. */
  struct ConnectorResponse
  {
    /** Force (N), positive in tension. */
    double force;
    /** d force / d extension (N/m), at fixed rate. */
    double stiffness;
    /** d force / d rate (N s/m), at fixed extension. */
    double damping;
  };

  /** Energies of one connector, evaluated once a step is accepted (J). */
  struct ConnectorEnergy
  {
    /** Energy in the springs at the end of the step. */
    double stored;
    /** Energy lost in the dashpots during the step. */
    double dissipated;
  };

  /** Answer of a law for one connector at an instant, without any step. */
  struct ContinuousResponse
  {
    /** Force (N), positive in tension. */
    double force;
    /** Energy in the springs (J). */
    double stored;
    /** Power lost in the dashpots (W), >= 0. */
    double lost_power;
  };

  /**
   * The law of a connector: extension history to force. One object serves all
   * connectors of a group and holds parameters only. Internal variables lie in
   * a flat array, n_history() numbers a connector, all zero at rest.
   */
  class ConnectorLaw
  {
  public:
    virtual ~ConnectorLaw() = default;

    /**
     * Internal variables a connector needs; 0 for laws without Maxwell
     * elements.
     */
    virtual unsigned int n_history() const
    {
      return 0;
    }

    /** Whether the law has a dashpot at all. */
    virtual bool is_viscous() const = 0;

    /**
     * Whether the force is linear in extension, rate and internal variables, so
     * that its tangents are the same everywhere.
     */
    virtual bool is_linear() const = 0;

    /**
     * Force and tangents for @p n connectors at once (one virtual call a group).
     * @p committed holds n * n_history() internal variables from the start of
     * the step; @p trial receives those of its end.
     */
    virtual void evaluate(unsigned int           n,
                          const ConnectorMotion *motion,
                          const double          *committed,
                          double                *trial,
                          ConnectorResponse     *response) const = 0;

    /**
     * The same at a stage of a Runge-Kutta step. The internal variables z
     * follow
     * from those of its base, @p base, by Euler's backward rule: z = z_base +
     * motion.dt z', with z' as in continuous(). This is evaluate() where there
     * are none.
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
     * Mean forces over the step, as evaluate(): of an extension that is linear
     * in it. Their work is the energy() that is stored and lost. The stiffness
     * in the @p response is the derivative of the mean force by the extension
     * at the end, the rest zero.
     */
    virtual void evaluate_mean(unsigned int           n,
                               const ConnectorMotion *motion,
                               const double          *committed,
                               double                *trial,
                               ConnectorResponse     *response) const = 0;

    /**
     * Answer once all viscous processes have come to rest at @p extension (m);
     * the internal variables are then zero.
     */
    ConnectorResponse relaxed(const double extension) const
    {
      return {long_time_stiffness() * extension, long_time_stiffness(), 0};
    }

    /** Energies of one connector over the step described by the same data. */
    virtual ConnectorEnergy energy(const ConnectorMotion &motion,
                                   const double          *committed,
                                   const double          *trial) const = 0;

    /**
     * The law of one connector as a system of ordinary differential equations,
     * for integrators that choose their own steps: from @p extension (m), its
     * @p rate (m/s) and the n_history() internal variables @p internal now to
     * the force and energies now and the @p internal_rates. Small steps of
     * evaluate() tend to its solution.
     */
    virtual ContinuousResponse continuous(double        extension,
                                          double        rate,
                                          const double *internal,
                                          double *internal_rates) const = 0;

    /**
     * The law with every dashpot gone and all Maxwell elements relaxed: the
     * spring that remains (N/m). Used when the scene leaves viscosity out.
     */
    virtual double long_time_stiffness() const = 0;

    /**
     * Force over extension (N/m) where both go as e^(s t), s in 1/s: the
     * complex stiffness at s = i omega. About rest, of a law that is not
     * linear.
     */
    virtual std::complex<double>
    dynamic_stiffness(std::complex<double> s) const = 0;

    /** The part sum k s tau / (1 + s tau) of dynamic_stiffness(): k (N/m) by
     * relaxation time tau (s). */
    virtual std::map<double, double> relaxing_stiffnesses() const
    {
      return {};
    }
  };

  /** All laws the program knows (connectors/register.cc). */
  const Registry<ConnectorLaw> &connector_law_registry();

  /** A plain linear spring, the stand-in when viscosity is left out. */
  std::unique_ptr<ConnectorLaw> make_spring_law(double stiffness);

  /**
   * @name Table entries of the laws, one per file source/connectors/<name>.cc.
   * Only register.cc needs them.
   */
  ///@{
  RegistryEntry<ConnectorLaw> spring_entry();
  RegistryEntry<ConnectorLaw> dashpot_entry();
  RegistryEntry<ConnectorLaw> kelvin_voigt_entry();
  RegistryEntry<ConnectorLaw> maxwell_entry();
  RegistryEntry<ConnectorLaw> standard_linear_solid_entry();
  RegistryEntry<ConnectorLaw> generalized_maxwell_entry();
  ///@}

  /**
   * Spring @p stiffness (N/m) and dashpot @p damping (N s/m) side by side:
   * F = K u + C du/dt. Either may be zero.
   */
  std::unique_ptr<ConnectorLaw> make_kelvin_voigt_law(double stiffness,
                                                      double damping);
} // namespace auxfem

#endif
