#ifndef auxfem_time_schemes_time_scheme_h
#define auxfem_time_schemes_time_scheme_h

#include <auxfem/parameters/registry.h>
#include <auxfem/state/state.h>

#include <optional>
#include <string>

namespace auxfem
{
  /**
   * What a scheme wants of the tangent: stiffness * K + damping * C +
   * mass * M.
   */
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
   * What the user chose as `Time/Scheme`, with its parameters. It says of
   * itself whatever the rest of the program decides by the scheme, so that no
   * name is compared anywhere.
   */
  class TimeScheme
  {
  public:
    /** @param name is that of its line in the table, as the user writes it. */
    explicit TimeScheme(const std::string &name);

    virtual ~TimeScheme() = default;

    /** The word in `Time/Scheme`. */
    const std::string &name() const
    {
      return scheme_name;
    }

    /** Whether motion and time are related by inertia at all. */
    virtual bool is_dynamic() const
    {
      return true;
    }

    /**
     * What a user who computes rigid parts should know of the scheme; nothing
     * if there is nothing to say.
     */
    virtual std::optional<std::string> note_on_rigid_parts() const
    {
      return {};
    }

  private:
    const std::string scheme_name;
  };

  struct ButcherTableau;

  /**
   * A rule that ties displacement, velocity and acceleration at the end of a
   * step to those at its start and one unknown increment. It knows nothing of
   * elements: it predicts, says how the increment enters the tangent, and
   * corrects.
   */
  class ImplicitScheme : public TimeScheme
  {
  public:
    using TimeScheme::TimeScheme;

    /**
     * Fills @p to (all but time and residual) with a first guess of the state
     * @p dt (s) after @p from.
     */
    virtual void predict(const State &from, double dt, State &to) const = 0;

    /**
     * How an increment of displacement changes displacement, velocity and
     * acceleration in a step of length @p dt (s) that begins with @p from, means
     * if it balances these.
     */
    virtual TangentFactors factors(const State &from, double dt) const = 0;

    /**
     * Adds the increment (values at all local unknowns) to the trial state,
     * which is @p dt (s) after @p from.
     */
    virtual void correct(const State  &from,
                         const Vector &increment,
                         double        dt,
                         State        &trial) const = 0;

    /**
     * Whether forces are balanced in the mean over a step, not at its end. The
     * acceleration is the mean one then and does not enter the next step.
     */
    virtual bool balances_means() const
    {
      return false;
    }

    /**
     * The factor chi by which a scheme that balances means damps the highest
     * frequencies of struts (elements/increment_damping.h); 0: not at all.
     */
    virtual double high_frequency_damping() const
    {
      return 0;
    }

    /**
     * Whether errors of velocity and acceleration that change sign from step to
     * step are neither damped nor fed back by an algorithmic acceleration, so
     * that restoring consistent rates after a step removes them.
     */
    virtual bool propagates_alternating_errors() const
    {
      return false;
    }

    /**
     * Whether rates of unknowns without mass (State::is_massless) are kept from
     * growing.
     */
    virtual bool keeps_massless_in_equilibrium() const
    {
      return false;
    }

    /**
     * The number c with which c dt^2 times the change of acceleration in a step
     * is the error of displacement that it adds. Nothing if that is not how the
     * error is estimated.
     */
    virtual std::optional<double> error_constant() const
    {
      return {};
    }

    /** Whether the error of a step is estimated: by error_constant(), or of a
     * scheme with stages by these. */
    virtual bool estimates_errors() const
    {
      return error_constant().has_value();
    }

    /**
     * For a scheme with stages: the factor of the amplitude of an oscillation
     * that turns by @p angle (rad) in a step.
     */
    virtual double amplification(const double /*angle*/) const
    {
      return 1;
    }

    /**
     * For a scheme with stages: the error that a step adds to an oscillation
     * that turns by @p angle (rad) in it, over the difference from the embedded
     * scheme.
     */
    virtual double error_by_difference(const double /*angle*/) const
    {
      return 1;
    }

    /**
     * Part of its way that an oscillation misses in a step, of which the
     * trapezoidal rule, its error taken from third differences of displacements
     * at the ends of steps, would miss @p by_trapezoidal_rule.
     */
    virtual double missed_way(const double by_trapezoidal_rule) const
    {
      return by_trapezoidal_rule;
    }

    /** Power of the step's length with which the error of many steps goes. */
    virtual unsigned int order() const
    {
      return 2;
    }

    /**
     * The stages of a step, each of which is a step of this scheme (see
     * RungeKutta); nullptr: a step is one.
     */
    virtual const ButcherTableau *stages() const
    {
      return nullptr;
    }

    /** Whether the state must carry the algorithmic acceleration. */
    virtual bool uses_algorithmic_acceleration() const
    {
      return false;
    }
  };

  /**
   * One line of the table of time schemes. Parameters of all schemes stand side
   * by side in the subsection `Time`, those of the chosen one are used.
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

  /** All schemes the program knows (time/register.cc), the default first. */
  const std::vector<TimeSchemeEntry> &time_scheme_registry();

  /** The line of the scheme @p name, which must be in the table. */
  const TimeSchemeEntry &time_scheme_entry(const std::string &name);

  /** The first scheme of the table with the default values of its parameters.
   */
  std::shared_ptr<const TimeScheme> default_time_scheme();

  /**
   * @name Table entries of the schemes, one per file
   * source/time/<name>.cc.
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
