#ifndef auxfem_equations_effect_h
#define auxfem_equations_effect_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/equations/energy_account.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <algorithm>
#include <complex>
#include <string>

namespace auxfem
{
  /** Raises the entry of a local unknown to @p size; none of -1 (ground). */
  inline void raise(double *sizes, const int unknown, const double size)
  {
    if (unknown >= 0)
      sizes[unknown] = std::max(sizes[unknown], size);
  }

  /** Bounds of what moves, over all ranks: motions, and their rates (0 where
   * the state has none). */
  struct LargestMotion
  {
    double displacement = 0; ///< m
    double rotation     = 0; ///< rad
    double velocity     = 0; ///< m/s
    double spin         = 0; ///< rad/s
  };

  /** Forces that act at a state: `factor` times those by which `to` differs
   * from `from`. */
  struct ForceChange
  {
    const State             &state, &from, &to;
    const EvaluationResults &at_state, &at_from, &at_to;
    double                   factor;
  };

  /**
   * One kind of physics: struts, inertia, a group of connectors, a load. The
   * scene makes a list of these; what is not in the list costs nothing. Called
   * once per evaluation for all elements of the kind.
   *
   * An effect keeps nothing of an evaluation: what it produces goes into the
   * state and the results that the caller owns.
   */
  class Effect
  {
  public:
    virtual ~Effect() = default;

    /** True if force is linear in displacement, velocity and acceleration. */
    virtual bool is_linear() const = 0;

    /**
     * Asks for what the effect needs of the state and enters its energies.
     * Called once, when the equations are made.
     */
    virtual void register_in(StateLayout & /*layout*/)
    {}

    /**
     * Registers the blocks, besides those of elements, in which this effect
     * couples unknowns. Called again when the pattern changes.
     */
    virtual void register_blocks(TangentPattern & /*pattern*/)
    {}

    /** Room for the results of an evaluation; nullptr: there are none. */
    virtual std::unique_ptr<EffectCache> make_results() const
    {
      return nullptr;
    }

    /**
     * Adds internal or inertia force, or minus the applied force, at
     * evaluation.to to @p residual (n_local entries).
     * @param results as made by make_results(), to be overwritten
     */
    virtual void add_residual(const Evaluation &evaluation,
                              double           *residual,
                              EffectCache      *results) const = 0;

    /**
     * Adds the derivative of the residual to @p matrix.
     * @param results of add_residual() in the same evaluation
     */
    virtual void add_tangent(const Evaluation & /*evaluation*/,
                             const EffectCache * /*results*/,
                             const TangentFactors & /*factors*/,
                             TangentMatrix & /*matrix*/) const
    {}

    /** Adds the derivative of the residual by time_of_loads() (n_local
     * entries). */
    virtual void add_load_derivative(const Evaluation & /*evaluation*/,
                                     double * /*derivative*/) const
    {}

    /**
     * Takes down the energies there are at evaluation.to. The step may still be
     * undone.
     * @param results of add_residual() in the same evaluation
     */
    virtual void account(const Evaluation & /*evaluation*/,
                         const EffectCache * /*results*/,
                         EnergyAccount & /*account*/) const
    {}

    /**
     * The same for dissipation and work in a solved step, or at an instant, as
     * of impulses; writes the internal variables that follow from them.
     */
    virtual void account_step(const Evaluation & /*step*/,
                              const EffectCache * /*results*/,
                              EnergyAccount & /*account*/) const
    {}

    /**
     * Raises @p forces (N, N m in rows of rotations, n_local entries) to the
     * forces that the parts of the effect exert in each row at evaluation.to,
     * which may cancel there: what residuals are measured by.
     * @param results of add_residual() in the same evaluation
     */
    virtual void row_force_bounds(const Evaluation & /*evaluation*/,
                                  const EffectCache * /*results*/,
                                  double * /*forces*/) const
    {}

    /**
     * Raises @p forces, as row_force_bounds() does, to those whose last digit is
     * uncertain in the residual: machine precision times these is the
     * residual's round-off. With motions that are at most as large as @p
     * largest.
     */
    virtual void roundoff_force_bounds(const Evaluation  &evaluation,
                                       const EffectCache *results,
                                       const LargestMotion & /*largest*/,
                                       double *forces) const
    {
      row_force_bounds(evaluation, results, forces);
    }

    /**
     * What has no finite force in an evaluation, and why, in the user's words;
     * empty: nothing, or the effect does not know.
     */
    virtual std::string nonfinite_reason(const Evaluation & /*evaluation*/,
                                         const EffectCache * /*results*/) const
    {
      return "";
    }
  };

  /**
   * Implemented by effects whose forces couple other unknowns as the structure
   * moves, as in contact.
   */
  class ChangingCouplings
  {
  public:
    virtual ~ChangingCouplings() = default;

    /**
     * Brings what couples unknowns up to date with an accepted state, between
     * steps. Returns whether blocks must be registered anew.
     * @param required_unknowns receives global numbers of unknowns that the effect needs
     *   from now on; they are local when blocks are registered. Collective.
     */
    virtual bool update_couplings(const State & /*accepted*/,
                                  std::vector<int> & /*required_unknowns*/)
    {
      return false;
    }

    /** As update_couplings(), from the state alone: what was found in states
     * before it is forgotten. */
    virtual bool restart_couplings(const State & /*accepted*/,
                                   std::vector<int> & /*required_unknowns*/)
    {
      return false;
    }

    /** Whether forces may begin or end all at once within a step, as where
     * things touch. The same on all ranks. */
    virtual bool has_contact_candidates() const
    {
      return false;
    }

    /**
     * Why a step that is solved must not be accepted but repeated in shorter
     * ones, in words for users; empty: it may. Words of one rank are enough.
     * Collective.
     */
    virtual std::string rejection_reason(const Evaluation & /*step*/) const
    {
      return "";
    }
  };

  /**
   * Implemented by effects with dissipation, work, or internal variables: what
   * steps with stages ask of them.
   */
  class StageTerms
  {
  public:
    virtual ~StageTerms() = default;

    /**
     * Takes down dissipation and work of a stage by their power, each times
     * evaluation.weight, in place of Effect::account_step().
     * @param results of Effect::add_residual() in the same evaluation
     */
    virtual void account_stage(const Evaluation & /*stage*/,
                               const EffectCache * /*results*/,
                               EnergyAccount & /*account*/) const
    {}

    /** What of an evaluation account_stage() and find_internal_rates() need. */
    enum class StageNeeds
    {
      state,   ///< no forces
      results, ///< those of this effect
      residual ///< that of all effects
    };

    /** The same whatever the state. */
    virtual StageNeeds stage_needs() const
    {
      return StageNeeds::state;
    }

    /**
     * Rates of the internal variables that obey differential equations
     * (StateLayout::integrated), written to @p rates, which has the size of
     * State::history.
     * @param results of Effect::add_residual() at the same state
     */
    virtual void find_internal_rates(const State & /*state*/,
                                     const EffectCache * /*results*/,
                                     double * /*rates*/) const
    {}
  };

  /**
   * Implemented by effects with more than a stiffness: what small motions about
   * a state (modes, buckling, frequency responses) ask of them.
   */
  class SmallMotionTerms
  {
  public:
    virtual ~SmallMotionTerms() = default;

    /**
     * Adds the geometric stiffness of a change of its forces: the derivative of
     * the residual by motions from change.state in which these stay as they
     * are, in the axes they have. Constraints have it by their multipliers.
     * @param effect index of the effect in EvaluationResults::effect_caches
     */
    virtual void add_geometric_tangent(const ForceChange & /*change*/,
                                       const unsigned int /*effect*/,
                                       TangentMatrix & /*matrix*/) const
    {}

    /**
     * Adds what the stiffness for small motions that go as e^(s t), s in 1/s,
     * has beside that of very slow ones, damping and inertia: real and
     * imaginary part.
     * @param results of Effect::add_residual() in the same evaluation
     */
    virtual void add_viscous_stiffness(const Evaluation & /*evaluation*/,
                                       const EffectCache * /*results*/,
                                       const std::complex<double> /*s*/,
                                       TangentMatrix & /*real*/,
                                       TangentMatrix & /*imaginary*/) const
    {}

    /**
     * Appends the relaxation times (s) of Maxwell elements in
     * add_viscous_stiffness() that this rank owns and @p unknowns let move.
     */
    virtual void add_relaxation_times(const Unknowns & /*unknowns*/,
                                      std::vector<double> & /*times*/) const
    {}

    /** Adds the stiffness E of the Maxwell elements with the relaxation time
     * @p time (s), of which add_viscous_stiffness() has E s time / (1 + s
     * time). */
    virtual void add_relaxing_stiffness(const EffectCache * /*results*/,
                                        double /*time*/,
                                        TangentMatrix & /*matrix*/) const
    {}
  };

  /**
   * Constraints g = 0 (m) on the motion, with their Lagrange multipliers lambda
   * (N): forces G^T lambda, and the constraints themselves in the rows of the
   * multipliers. In an evaluation of rates with inertia these rows hold
   * d2g/dt2, which determines consistent accelerations.
   */
  class Constraints : public Effect
  {
  public:
    /**
     * dg/dt (m/s) of the velocities of @p state, into the multipliers' entries
     * of @p rates (n_local entries).
     */
    virtual void find_rates(const State &state, double *rates) const = 0;

    /** Length (m) whose round-off is in the constraints besides that of
     * displacements. */
    virtual double length() const
    {
      return 0;
    }
  };

  /** What all inertia has: the energies that follow from its mass matrix. */
  class InertiaEffect : public Effect
  {
  public:
    void register_in(StateLayout &layout) override
    {
      kinetic_entry   = layout.energies.enter(kinetic_energy_entry());
      numerical_entry = layout.energies.enter(numerical_energy_entry());
    }

    void account(const Evaluation & /*evaluation*/,
                 const EffectCache * /*results*/,
                 EnergyAccount &account) const override
    {
      account.add_inertia(kinetic_entry,
                          numerical_entry,
                          [&](const Vector &x, const Vector &y) {
                            return mass_product(x, y);
                          });
    }

  protected:
    unsigned int numerical_entry = 0;

  private:
    /** x.M y of what this rank owns, of values of all local unknowns. */
    virtual double mass_product(const Vector &x, const Vector &y) const = 0;

    unsigned int kinetic_entry = 0;
  };
} // namespace auxfem

#endif
