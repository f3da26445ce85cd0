#ifndef auxfem_equations_equations_h
#define auxfem_equations_equations_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/model/lattice_model.h>

#include <memory>
#include <set>
#include <vector>

namespace auxfem
{
  /** An accepted state with the results of its evaluation. */
  struct Solution
  {
    State             state;
    EvaluationResults results;

    /** A place within a step. */
    struct Within
    {
      const Solution *from, *to; ///< ends of the step
      double          part;      ///< of the step that has gone by

      /** Linear between the ends. */
      double chord(const double at_from, const double at_to) const
      {
        return at_from + part * (at_to - at_from);
      }
    };

    /** Set where forces at an interpolated motion are far out of equilibrium:
     * those of this solution, energies included, are linear between the ends
     * of the step, and `results` do not serve. */
    std::optional<Within> forces_within = {};
  };

  class ConnectorForces;
  class PlateContact;
  class RigidPartGroup;
  class StrutContact;
  class StrutForces;
  struct ConnectorReport;

  /** A group of connectors among the effects. */
  struct ConnectorGroup
  {
    const ConnectorForces *forces;
    unsigned int effect; ///< index in EvaluationResults::effect_caches

    /** Counted connector @p i at @p state. */
    ConnectorReport report(unsigned int             i,
                           const State             &state,
                           const EvaluationResults &results) const;
  };

  /** Struts of one polynomial order among the effects. */
  struct StrutGroup
  {
    const StrutForces *forces;
    unsigned int       effect; ///< index in EvaluationResults::effect_caches
  };

  /** The effects that output asks for more than forces. */
  struct ReportingEffects
  {
    /** By ascending order, as DofNumbering::groups(); none if the scene has no
     * elastic struts. */
    std::vector<StrutGroup> struts;
    /** nullptr if the scene has no rigid parts. */
    const RigidPartGroup       *rigid_parts = nullptr;
    std::vector<ConnectorGroup> connectors;
    /** nullptr if the scene has no plates. */
    const PlateContact *plates        = nullptr;
    unsigned int        plates_effect = 0; ///< index of its results
    /** nullptr if struts may cross. */
    const StrutContact *strut_contact        = nullptr;
    unsigned int        strut_contact_effect = 0; ///< index of its results
    /** All constraints with multipliers: of rigid parts, of revolute hinges. */
    std::vector<const Constraints *> constraints;
  };

  /**
   * The equations of a model: the list of effects the scene calls for, and the
   * questions that can be asked of it: residual, tangent, energies. They keep
   * nothing of an answer.
   */
  class Equations
  {
  public:
    /**
     * @param model must outlive the object. Throws InputError for
     * contradictions only the model can show (a moment on a joint without
     * rotation).
     * @param further internal forces beside those of the scene
     */
    Equations(const LatticeModel                  &model,
              std::vector<std::unique_ptr<Effect>> further = {});

    const LatticeModel &model() const
    {
      return structure;
    }

    const StateLayout &layout() const
    {
      return state_layout;
    }

    const TangentPattern &pattern() const
    {
      return tangent_pattern;
    }

    const ReportingEffects &reporting() const
    {
      return reporting_effects;
    }

    /** Those of the model, with the ghosts that effects have asked for. */
    const Unknowns &unknowns() const
    {
      return with_ghosts ? *with_ghosts : structure.numbering.unknowns();
    }

    /** Whether one tangent serves all states (for a constant step). */
    bool is_linear() const;

    /** Those of the contact with plates, of a scene that has some. */
    const EffectCache &plate_results(const EvaluationResults &results) const
    {
      return *results.effect_caches[reporting_effects.plates_effect];
    }

    /** Those of the contact between struts, of a scene that has it. */
    const EffectCache &
    strut_contact_results(const EvaluationResults &results) const
    {
      return *results.effect_caches[reporting_effects.strut_contact_effect];
    }

    /** The state at t = 0: at rest or with the scene's initial velocities. */
    State initial_state() const;

    /** Room for the results of evaluations. */
    EvaluationResults make_results() const;

    /** initial_state() with room for its results. */
    Solution initial_solution() const
    {
      return {initial_state(), make_results()};
    }

    /**
     * Fills the residual and the internal variables of evaluation.to, and
     * @p results. Collective.
     */
    void residual(const Evaluation  &evaluation,
                  EvaluationResults &results) const;

    /**
     * Fills @p matrix with the tangent at evaluation.to.
     * @param results of residual() in the same evaluation
     */
    void tangent(const Evaluation        &evaluation,
                 const EvaluationResults &results,
                 const TangentFactors    &factors,
                 TangentMatrix           &matrix) const;

    /** Adds to @p matrix what a change of internal forces adds to the tangent,
     * see SmallMotionTerms::add_geometric_tangent(); that of constraints is not
     * among it.
     */
    void add_geometric_tangent(const ForceChange &change,
                               TangentMatrix     &matrix) const;

    /**
     * Fills @p real and @p imaginary with the two parts of the stiffness for
     * small motions about evaluation.to, an equilibrium, that go as e^(s t), s
     * in 1/s: K + s C + s^2 M and the complex stiffness of connectors.
     * Constraints are in both.
     * @param results of residual() in the same evaluation
     */
    void dynamic_stiffness(const Evaluation        &evaluation,
                           const EvaluationResults &results,
                           std::complex<double>     s,
                           TangentMatrix           &real,
                           TangentMatrix           &imaginary) const;

    /** Relaxation times (s) of Maxwell elements, rising. Collective. */
    std::set<double> relaxation_times() const;

    /** @p matrix becomes the stiffness E of the Maxwell elements with the
     * relaxation time @p time (s), of which dynamic_stiffness() has E s time /
     * (1 + s time). */
    void relaxing_stiffness(const EvaluationResults &results,
                            double                   time,
                            TangentMatrix           &matrix) const;

    /** Derivative of the residual by time_of_loads() of evaluation.to through
     * the loads, of local unknowns. */
    Vector load_derivative(const Evaluation &evaluation) const;

    /**
     * Completes evaluation.to with history, work and energies. The step may
     * still be undone. Collective.
     * @param results of residual() in the same evaluation
     */
    void accept(const Evaluation        &evaluation,
                const EvaluationResults &results) const;

    /**
     * Completes evaluation.to, a stage, with the work done and the energy
     * dissipated in the step so far, as StageTerms::account_stage().
     * @param results of residual() at the same state
     */
    void account_stage(const Evaluation        &stage,
                       const EvaluationResults &results) const;

    /** Whether account_stage() and find_internal_rates() can do without a
     * residual: find_stage_results() is enough for them. */
    bool stages_need_no_residual() const;

    /** Of residual() what they need: results of effects and internal variables.
     */
    void find_stage_results(const Evaluation  &stage,
                            EvaluationResults &results) const;

    /**
     * Rates of internal variables at @p state, as StageTerms::find_internal_rates().
     * @param results of residual() at the state
     */
    std::vector<double>
    find_internal_rates(const State             &state,
                        const EvaluationResults &results) const;

    /**
     * Brings the couplings of the effects up to date with an accepted state.
     * Where they change, the pattern does; where they reach unknowns of other
     * ranks, @p accepted gains them as ghosts, and other states must
     * (State::take_ghosts()): then true is returned. Collective.
     */
    bool update_couplings(State &accepted);

    /** As update_couplings(), from the state alone
     * (ChangingCouplings::restart_couplings()). */
    bool restart_couplings(State &accepted);

    /**
     * Raises @p forces (n_local entries) to those that all effects exert in each
     * row, as Effect::row_force_bounds(), and to the loads.
     */
    void row_force_bounds(const Evaluation        &evaluation,
                          const EvaluationResults &results,
                          double                  *forces) const;

    /**
     * What in each row of the residual is round-off (N, N m), complete in owned
     * rows. Collective.
     * @param results of residual() in the same evaluation
     */
    Vector round_off(const Evaluation        &evaluation,
                     const EvaluationResults &results) const;

    /** Norm (N) below which the residual is round-off. Collective. */
    double round_off_floor(const Evaluation        &evaluation,
                           const EvaluationResults &results) const;

    /** Whether any effect's forces may begin all at once. */
    bool has_contact_candidates() const;

    /**
     * Why a solved step must be repeated in shorter ones, in words; empty: it
     * need not. The same on all ranks; collective.
     */
    std::string rejection_reason(const Evaluation &step) const;

    /**
     * Why the residual of an evaluation is not finite, in words, where an
     * effect knows it. The same on all ranks; collective.
     */
    std::string nonfinite_reason(const Evaluation        &evaluation,
                                 const EvaluationResults &results) const;

  private:
    void make_internal_forces();
    void make_contact();
    void make_constraints();
    void make_inertia();
    void make_loads();
    /** Throws InputError if steps are to follow an error that is not known. */
    void refuse_unknown_errors() const;
    void enter_energies();
    void register_blocks();
    /** Of motions at @p state. */
    void update_ghosts(State &state) const;
    /** StageTerms::account_stage() of all effects. */
    void add_stage(const Evaluation        &stage,
                   const EvaluationResults &results,
                   EnergyAccount           &account) const;
    /** As update_couplings(), for what effects have changed and want. */
    bool couple(bool                    changed,
                const std::vector<int> &required_unknowns,
                State                  &accepted);

    /** An effect that implements a further interface. */
    template <class Terms>
    struct Implementation
    {
      unsigned int effect; ///< index in `effects`
      Terms       *terms;
    };

    /** All that do. */
    template <class Terms>
    std::vector<Implementation<Terms>> implementations() const
    {
      std::vector<Implementation<Terms>> found;
      for (unsigned int i = 0; i < effects.size(); ++i)
        if (auto *const terms = dynamic_cast<Terms *>(effects[i].get()))
          found.push_back({i, terms});
      return found;
    }

    const LatticeModel                  &structure;
    std::vector<std::unique_ptr<Effect>> effects;
    /** @name Those of them that have such terms. */
    ///@{
    std::vector<Implementation<StageTerms>>        stage_terms;
    std::vector<Implementation<SmallMotionTerms>>  small_motion_terms;
    std::vector<Implementation<ChangingCouplings>> changing_couplings;
    ///@}
    /**
     * The first n_internal effects are internal forces: their sum is the force
     * scale.
     */
    unsigned int n_internal = 0;
    /**
     * The first n_balanced effects are internal and inertia forces; the rest
     * are loads.
     */
    unsigned int     n_balanced = 0;
    ReportingEffects reporting_effects;
    StateLayout      state_layout;
    /** If they are more than the model's. */
    std::unique_ptr<Unknowns> with_ghosts;
    TangentPattern            tangent_pattern;
    /** Local unknown, value. */
    std::vector<std::pair<int, double>> initial_velocities;
  };

  /**
   * Largest |displacement| (m) and |rotation| (rad) over all ranks in
   * @p motion: displacements, an increment of them, or velocities (m/s, rad/s).
   */
  std::pair<double, double> largest_motion(const LatticeModel &model,
                                           const Vector       &motion);

  /**
   * Norm (m) up to which the constraints are met: their round-off. A looser
   * tolerance would return as forces, divided by the square of the step.
   * Collective.
   */
  double constraint_tolerance(const Equations &equations, const State &state);

  /**
   * What of @p state is not a finite number, in words: an unknown or its rates,
   * an internal variable, an energy; empty: all are. The same on all ranks;
   * collective.
   */
  std::string nonfinite_quantity(const LatticeModel &model, const State &state);

  /** Unknown with the largest free residual, in words, over all ranks. */
  std::string worst_unknown(const LatticeModel &model, const State &state);
} // namespace auxfem

#endif
