#ifndef auxfem_time_schemes_time_scheme_h
#define auxfem_time_schemes_time_scheme_h

#include <auxfem/parameters/registry.h>
#include <auxfem/state/state.h>

#include <optional>
#include <string>

namespace auxfem
{
  /** Factors of the tangent: stiffness * K + damping * C + mass * M. */
  struct TangentFactors
  {
    double stiffness = 1;
    double damping   = 0; ///< 1/s
    double mass      = 0; ///< 1/s2
  };

  inline bool operator==(const TangentFactors &one, const TangentFactors &other)
  {
    return one.stiffness == other.stiffness && one.damping == other.damping &&
      one.mass == other.mass;
  }

  /**
   * The scheme of `Time/Scheme` with its parameters. It answers all questions
   * that the program asks about schemes, so that names are never compared.
   */
  class TimeScheme
  {
  public:
    /** @param name as in the table and in `Time/Scheme` */
    explicit TimeScheme(const std::string &name);

    virtual ~TimeScheme() = default;

    /** The word in `Time/Scheme`. */
    const std::string &name() const
    {
      return scheme_name;
    }

    /** Whether the scheme has inertia. */
    virtual bool is_dynamic() const
    {
      return true;
    }

    /** Note for users who simulate rigid parts; empty if there is none. */
    virtual std::optional<std::string> note_on_rigid_parts() const
    {
      return {};
    }

  private:
    const std::string scheme_name;
  };

  struct ButcherTableau;

  /**
   * Relates displacement, velocity and acceleration at the end of a step to
   * those at its start and to one unknown increment. It predicts, gives the
   * tangent factors of the increment, and corrects; it is independent of
   * elements.
   */
  class ImplicitScheme : public TimeScheme
  {
  public:
    using TimeScheme::TimeScheme;

    /**
     * Fills @p to (all but time and residual) with a predictor of the state @p
     * dt (s) after @p from.
     */
    virtual void predict(const State &from, double dt, State &to) const = 0;

    /**
     * Factors by which an increment of displacement changes displacement,
     * velocity and acceleration in a step of length @p dt (s) that begins with
     * @p from; of their means if the scheme balances means.
     */
    virtual TangentFactors factors(const State &from, double dt) const = 0;

    /**
     * Adds the increment (values at all local unknowns) to the trial state, @p
     * dt (s) after @p from.
     */
    virtual void correct(const State  &from,
                         const Vector &increment,
                         double        dt,
                         State        &trial) const = 0;

    /**
     * Whether mean forces of the step are balanced, by a discrete gradient,
     * and not those at its end. The acceleration is then the mean one and does
     * not enter the next step.
     */
    virtual bool uses_discrete_gradient() const
    {
      return false;
    }

    /**
     * Damping factor chi of a discrete-gradient scheme for the highest
     * frequencies of struts (struts/beam_dispatch.h); 0: no damping.
     */
    virtual double high_frequency_damping() const
    {
      return 0;
    }

    /**
     * Whether errors of velocity and acceleration alternate in sign without
     * damping or feedback by an algorithmic acceleration. Restoring consistent
     * rates after a step then removes them.
     */
    virtual bool propagates_alternating_errors() const
    {
      return false;
    }

    /**
     * Whether rates of unknowns without mass (State::is_massless) are kept
     * from growing.
     */
    virtual bool keeps_massless_in_equilibrium() const
    {
      return false;
    }

    /**
     * Error constant c: the local error of displacement is c dt^2 times the
     * change of acceleration in a step. Empty if the error is not estimated
     * this way.
     */
    virtual std::optional<double> error_constant() const
    {
      return {};
    }

    /** Whether the local error is estimated, by error_constant() or stages. */
    virtual bool estimates_errors() const
    {
      return error_constant().has_value();
    }

    /**
     * For schemes with stages: amplification of an oscillation of phase @p
     * angle (rad) in a step.
     */
    virtual double amplification(const double /*angle*/) const
    {
      return 1;
    }

    /**
     * For schemes with stages: local error of an oscillation of phase @p angle
     * (rad) in a step, over the difference from the embedded scheme.
     */
    virtual double error_by_difference(const double /*angle*/) const
    {
      return 1;
    }

    /**
     * Relative error of an oscillation's phase in a step, given that of the
     * trapezoidal rule, whose error follows from third differences of
     * displacements.
     */
    virtual double missed_phase(const double by_trapezoidal_rule) const
    {
      return by_trapezoidal_rule;
    }

    /** Order of convergence. */
    virtual unsigned int order() const
    {
      return 2;
    }

    /**
     * Stages of a step, each of which is a step of this scheme (see
     * RungeKutta); nullptr: the step is a single one.
     */
    virtual const ButcherTableau *stages() const
    {
      return nullptr;
    }

    /** Whether the state must have the algorithmic acceleration. */
    virtual bool uses_algorithmic_acceleration() const
    {
      return false;
    }
  };

  /**
   * One line of the table of time schemes. The subsection `Time` lists
   * parameters of all schemes; those of the chosen one are used.
   */
  struct TimeSchemeEntry : RegistryEntry<TimeScheme>
  {
    /**
     * Models whose scenes may choose it. With Model::lattice it makes an
     * ImplicitScheme.
     */
    std::vector<Model> models;

    bool serves(Model model) const;
  };

  /** All time schemes, the default first (time/schemes/time_scheme.cc). */
  const std::vector<TimeSchemeEntry> &time_scheme_registry();

  /** The line of the scheme @p name, which must be in the table. */
  const TimeSchemeEntry &time_scheme_entry(const std::string &name);

  /** The first scheme of the table with default parameters. */
  std::shared_ptr<const TimeScheme> default_time_scheme();

  /**
   * @name Table entries of the schemes, one per file
   * source/time/schemes/<name>.cc.
   */
  ///@{
  TimeSchemeEntry newmark_entry();
  TimeSchemeEntry hht_entry();
  TimeSchemeEntry generalized_alpha_entry();
  TimeSchemeEntry energy_momentum_entry();
  TimeSchemeEntry esdirk_entry();
  TimeSchemeEntry static_entry();
  ///@}

  /**
   * @name The same for schemes of the reduced cell alone, one per file
   * source/reduced_cell/<name>.cc.
   */
  ///@{
  TimeSchemeEntry central_difference_entry();
  TimeSchemeEntry as_printed_entry();
  TimeSchemeEntry arkode_entry();
  ///@}
} // namespace auxfem

#endif
