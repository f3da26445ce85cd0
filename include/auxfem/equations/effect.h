#ifndef auxfem_equations_effect_h
#define auxfem_equations_effect_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/equations/energy_account.h>
#include <auxfem/time/schemes/time_scheme.h>

#include <algorithm>
#include <complex>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Sets the entry of a local unknown to at least @p size; ignores -1 (ground).
   */
  inline void raise_bound(double *sizes, const int unknown, const double size)
  {
    if (unknown >= 0)
      sizes[unknown] = std::max(sizes[unknown], size);
  }

  /**
   * Largest motions and rates over all ranks; rates are 0 if the state has
   * none.
   */
  struct LargestMotion
  {
    double displacement = 0; ///< m
    double rotation     = 0; ///< rad
    double velocity     = 0; ///< m/s
    double spin         = 0; ///< rad/s
  };

  /**
   * Forces at a state: `factor` times the difference of the forces at `to` and
   * `from`.
   */
  struct ForceChange
  {
    const State             &state, &from, &to;
    const EvaluationResults &at_state, &at_from, &at_to;
    double                   factor;
  };

  /**
   * One kind of physics: struts, inertia, a group of connectors, a load.
   * Equations hold the list of effects of a scene and call each once per
   * evaluation for all its elements.
   *
   * Effects are stateless: an evaluation writes to the state and to the results
   * owned by the caller.
   */
  class Effect
  {
  public:
    virtual ~Effect() = default;

    /** Whether the force is linear in displacement, velocity and
     * acceleration. */
    virtual bool is_linear() const = 0;

    /** Registers the state variables and energies of the effect. Called once,
     * when the equations are made. */
    virtual void register_in(StateLayout & /*layout*/)
    {}

    /** Registers the couplings of this effect besides those of elements. Called
     * again when the pattern changes. */
    virtual void register_blocks(TangentPattern & /*pattern*/)
    {}

    /** Allocates the results of an evaluation; nullptr if there are none. */
    virtual std::unique_ptr<EffectCache> make_results() const
    {
      return nullptr;
    }

    /** Adds internal or inertia force, or minus the applied force, at
     * evaluation.to to @p residual (n_local entries).
     * @param results from make_results(), overwritten */
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

    /** Adds the derivative of the residual with respect to time_of_loads()
     * (n_local entries). */
    virtual void add_load_derivative(const Evaluation & /*evaluation*/,
                                     double * /*derivative*/) const
    {}

    /** Adds the energies at evaluation.to. The step may still be undone.
     * @param results of add_residual() in the same evaluation */
    virtual void account(const Evaluation & /*evaluation*/,
                         const EffectCache * /*results*/,
                         EnergyAccount & /*account*/) const
    {}

    /** Writes the history at the end of a solved step to solved.to, where
     * residuals have not done so. Called before account_step(); the step may
     * still be undone. */
    virtual void update_history(const Evaluation & /*solved*/) const
    {}

    /** Adds struts whose elements owned by this rank break at the end of a @p
     * solved step. */
    virtual void add_failures(const Evaluation & /*solved*/,
                              std::vector<unsigned int> & /*struts*/) const
    {}

    /** Lets sorted @p struts, found on any rank, lose their forces from the end
     * of a @p solved step on. */
    virtual void break_struts(const std::vector<unsigned int> & /*struts*/,
                              const Evaluation & /*solved*/) const
    {}

    /** Adds dissipation and work of a solved step or an impulse, and updates
     * dependent internal variables. */
    virtual void account_step(const Evaluation & /*step*/,
                              const EffectCache * /*results*/,
                              EnergyAccount & /*account*/) const
    {}

    /** Raises @p forces (N; N m in rows of rotations; n_local entries) to the
     * forces that the parts of the effect exert in each row, before
     * cancellation. They scale the residual.
     * @param results of add_residual() in the same evaluation */
    virtual void row_force_bounds(const Evaluation & /*evaluation*/,
                                  const EffectCache * /*results*/,
                                  double * /*forces*/) const
    {}

    /** Raises @p forces to the forces whose rounding enters the residual:
     * machine precision times these bounds the round-off. Motions are at most
     * @p largest. */
    virtual void roundoff_force_bounds(const Evaluation  &evaluation,
                                       const EffectCache *results,
                                       const LargestMotion & /*largest*/,
                                       double *forces) const
    {
      row_force_bounds(evaluation, results, forces);
    }

    /** Explains to the user which part has no finite force, and why; empty if
     * unknown. */
    virtual std::string nonfinite_reason(const Evaluation & /*evaluation*/,
                                         const EffectCache * /*results*/) const
    {
      return "";
    }
  };

  /**
   * Implemented by effects whose couplings change with the motion, such as
   * contact.
   */
  class ChangingCouplings
  {
  public:
    virtual ~ChangingCouplings() = default;

    /** Updates the couplings for an accepted state. Returns whether blocks must
     * be registered again.
     * @param required_unknowns receives global numbers of unknowns that become
     *   ghosts before blocks are registered. Collective. */
    virtual bool update_couplings(const State & /*accepted*/,
                                  std::vector<int> & /*required_unknowns*/)
    {
      return false;
    }

    /** As update_couplings(), but independent of earlier states. */
    virtual bool restart_couplings(const State & /*accepted*/,
                                   std::vector<int> & /*required_unknowns*/)
    {
      return false;
    }

    /** Whether forces may start or end abruptly within a step, as in contact.
     * Equal on all ranks. */
    virtual bool has_contact_candidates() const
    {
      return false;
    }

    /** Reason, for the user, to reject a solved step and repeat it in shorter
     * ones; empty to accept. One rank may give it. Collective. */
    virtual std::string rejection_reason(const Evaluation & /*step*/) const
    {
      return "";
    }
  };

  /**
   * Implemented by effects with dissipation, work or internal variables, for
   * schemes with stages.
   */
  class StageTerms
  {
  public:
    virtual ~StageTerms() = default;

    /** Adds dissipation and work of a stage: power times evaluation.weight.
     * Replaces Effect::account_step().
     * @param results of Effect::add_residual() in the same evaluation */
    virtual void account_stage(const Evaluation & /*stage*/,
                               const EffectCache * /*results*/,
                               EnergyAccount & /*account*/) const
    {}

    /** Input that account_stage() and find_internal_rates() need. */
    enum class StageNeeds
    {
      state,   ///< no forces
      results, ///< results of this effect
      residual ///< residual of all effects
    };

    /** Independent of the state. */
    virtual StageNeeds stage_needs() const
    {
      return StageNeeds::state;
    }

    /** Writes the rates of integrated internal variables
     * (StateLayout::integrated) to @p rates, of the size of State::history.
     * @param results of Effect::add_residual() at the same state */
    virtual void find_internal_rates(const State & /*state*/,
                                     const EffectCache * /*results*/,
                                     double * /*rates*/) const
    {}
  };

  /**
   * Implemented by effects that contribute more than a stiffness to small
   * motions about a state: modes, buckling, frequency responses.
   */
  class SmallMotionTerms
  {
  public:
    virtual ~SmallMotionTerms() = default;

    /** Adds the geometric stiffness of a force change: the derivative of the
     * residual at change.state with these forces fixed in their local axes.
     * Constraints get it through their multipliers.
     * @param effect index of the effect in EvaluationResults::effect_caches */
    virtual void add_geometric_tangent(const ForceChange & /*change*/,
                                       const unsigned int /*effect*/,
                                       TangentMatrix & /*matrix*/) const
    {}

    /** Adds the frequency-dependent part of the stiffness for motions e^(s t),
     * s in 1/s, besides static stiffness, damping and inertia: real and
     * imaginary part.
     * @param results of Effect::add_residual() in the same evaluation */
    virtual void add_viscous_stiffness(const Evaluation & /*evaluation*/,
                                       const EffectCache * /*results*/,
                                       const std::complex<double> /*s*/,
                                       TangentMatrix & /*real*/,
                                       TangentMatrix & /*imaginary*/) const
    {}

    /** Appends the relaxation times (s) of the Maxwell elements owned by this
     * rank whose motion @p unknowns do not prescribe. */
    virtual void add_relaxation_times(const Unknowns & /*unknowns*/,
                                      std::vector<double> & /*times*/) const
    {}

    /** Adds the stiffness E of the Maxwell elements with the relaxation time
     * @p time (s); add_viscous_stiffness() adds E s time / (1 + s time). */
    virtual void add_relaxing_stiffness(const Evaluation & /*evaluation*/,
                                        const EffectCache * /*results*/,
                                        double /*time*/,
                                        TangentMatrix & /*matrix*/) const
    {}
  };

  /**
   * Constraints g = 0 (m) with Lagrange multipliers lambda (N): forces G^T
   * lambda, and g in the rows of the multipliers. For consistent rates with
   * inertia these rows hold d2g/dt2, which determines the accelerations.
   */
  class Constraints : public Effect
  {
  public:
    /** Writes dg/dt (m/s) for the velocities of @p state to the rows of the
     * multipliers in @p rates (n_local entries). */
    virtual void find_rates(const State &state, double *rates) const = 0;

    /** Length (m) whose round-off enters the constraints besides
     * displacements. */
    virtual double length() const
    {
      return 0;
    }
  };

  /** Base of inertia effects: energies from the mass matrix. */
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
    /** x.M y of the share of this rank, for values of all local unknowns. */
    virtual double mass_product(const Vector &x, const Vector &y) const = 0;

    unsigned int kinetic_entry = 0;
  };
} // namespace auxfem

#endif
