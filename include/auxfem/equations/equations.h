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

    /** A position within a step. */
    struct Within
    {
      const Solution *from, *to; ///< ends of the step
      double          part;      ///< elapsed fraction of the step

      /** Linear interpolation between the ends. */
      double chord(const double at_from, const double at_to) const
      {
        return at_from + part * (at_to - at_from);
      }
    };

    /** Set if forces at the interpolated motion would be far from equilibrium.
     * Forces and energies are then interpolated linearly in the step, and
     * `results` are not valid. */
    std::optional<Within> forces_within = {};
  };

  class ConnectorForces;
  class PlateContact;
  class RigidPartGroup;
  class StrutContact;
  class StrutForces;
  struct ConnectorReport;

  /** Effect of a group of connectors. */
  struct ConnectorGroup
  {
    const ConnectorForces *forces;
    unsigned int effect; ///< index in EvaluationResults::effect_caches

    /** Report on connector @p i of this rank at @p state. */
    ConnectorReport report(unsigned int             i,
                           const State             &state,
                           const EvaluationResults &results) const;
  };

  /** Effect of the struts of one polynomial order. */
  struct StrutGroup
  {
    const StrutForces *forces;
    unsigned int       effect; ///< index in EvaluationResults::effect_caches
  };

  /** Effects from which output needs more than forces. */
  struct ReportingEffects
  {
    /** By ascending order, as DofNumbering::groups(); empty without elastic
     * struts. */
    std::vector<StrutGroup> struts;
    /** nullptr without rigid parts. */
    const RigidPartGroup       *rigid_parts = nullptr;
    std::vector<ConnectorGroup> connectors;
    /** nullptr without plates. */
    const PlateContact *plates        = nullptr;
    unsigned int        plates_effect = 0; ///< index of its results
    /** nullptr if struts may cross. */
    const StrutContact *strut_contact        = nullptr;
    unsigned int        strut_contact_effect = 0; ///< index of its results
    /** Constraints with multipliers: rigid parts, revolute hinges, linear
     * relations. */
    std::vector<const Constraints *> constraints;
  };

  /**
   * Discrete equations of a model: the list of its effects with residual,
   * tangent and energies. Evaluations leave no state here.
   */
  class Equations
  {
  public:
    /** @param model must outlive the object. Throws InputError for
     * contradictions visible only in the model, such as a moment on a joint
     * without rotation.
     * @param further additional internal forces */
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

    /** Unknowns of the model, with the ghosts requested by effects. */
    const Unknowns &unknowns() const
    {
      return with_ghosts ? *with_ghosts : structure.numbering.unknowns();
    }

    /** Whether the tangent is the same for all states and a constant step. */
    bool is_linear() const;

    /** Results of plate contact; requires plates. */
    const EffectCache &plate_results(const EvaluationResults &results) const
    {
      return *results.effect_caches[reporting_effects.plates_effect];
    }

    /** Results of strut contact; requires strut contact. */
    const EffectCache &
    strut_contact_results(const EvaluationResults &results) const
    {
      return *results.effect_caches[reporting_effects.strut_contact_effect];
    }

    /** State at t = 0: at rest or with initial velocities. */
    State initial_state() const;

    /** Allocates the results of evaluations. */
    EvaluationResults make_results() const;

    /** initial_state() with allocated results. */
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

    /** Adds the geometric stiffness of a change of internal forces to
     * @p matrix, without constraints; see
     * SmallMotionTerms::add_geometric_tangent(). */
    void add_geometric_tangent(const ForceChange &change,
                               TangentMatrix     &matrix) const;

    /**
     * Fills @p real and @p imaginary with the dynamic stiffness for motions
     * e^(s t), s in 1/s, about the equilibrium evaluation.to: K + s C + s^2 M
     * plus the complex stiffness of connectors. Both parts contain the
     * constraints.
     * @param results of residual() in the same evaluation
     */
    void dynamic_stiffness(const Evaluation        &evaluation,
                           const EvaluationResults &results,
                           std::complex<double>     s,
                           TangentMatrix           &real,
                           TangentMatrix           &imaginary) const;

    /** Ascending relaxation times (s) of Maxwell elements. Collective. */
    std::set<double> relaxation_times() const;

    /** Fills @p matrix with the stiffness E of the Maxwell elements of
     * relaxation time @p time (s); dynamic_stiffness() contains E s time / (1 +
     * s time). */
    void relaxing_stiffness(const Evaluation        &evaluation,
                            const EvaluationResults &results,
                            double                   time,
                            TangentMatrix           &matrix) const;

    /** Derivative of the residual with respect to time_of_loads() of
     * evaluation.to, by local unknown. */
    Vector load_derivative(const Evaluation &evaluation) const;

    /** Completes the history of @p solved .to, as accept() does. */
    void update_history(const Evaluation &solved) const;

    /**
     * Completes evaluation.to with history, work and energies. The step may
     * still be undone. Collective.
     * @param results of residual() in the same evaluation
     */
    void accept(const Evaluation        &evaluation,
                const EvaluationResults &results) const;

    /** Adds the work and dissipation of the step so far to the stage
     * evaluation.to; see StageTerms::account_stage().
     * @param results of residual() at the same state */
    void account_stage(const Evaluation        &stage,
                       const EvaluationResults &results) const;

    /** Whether find_stage_results() suffices for account_stage() and
     * find_internal_rates(), without a residual. */
    bool stages_need_no_residual() const;

    /** Computes only the effect results and internal variables that stages
     * need. */
    void find_stage_results(const Evaluation  &stage,
                            EvaluationResults &results) const;

    /**
     * Rates of internal variables, as StageTerms::find_internal_rates().
     * @param results of residual() at the state
     */
    std::vector<double>
    find_internal_rates(const State             &state,
                        const EvaluationResults &results) const;

    /** Updates the couplings of effects and the matrix pattern for an accepted
     * state. Returns true if @p accepted gained ghosts, which other states then
     * need too (State::extend_ghosts()). Collective. */
    bool update_couplings(State &accepted);

    /** As update_couplings(), independent of earlier states
     * (ChangingCouplings::restart_couplings()). */
    bool restart_couplings(State &accepted);

    /** Raises @p forces (n_local entries) to the row force bounds of all
     * effects and to the loads; see Effect::row_force_bounds(). */
    void row_force_bounds(const Evaluation        &evaluation,
                          const EvaluationResults &results,
                          double                  *forces) const;

    /** Round-off of the residual by row (N, N m), complete in owned rows.
     * Collective.
     * @param results of residual() in the same evaluation */
    Vector round_off(const Evaluation        &evaluation,
                     const EvaluationResults &results) const;

    /** Norm (N) below which the residual is round-off. Collective. */
    double round_off_floor(const Evaluation        &evaluation,
                           const EvaluationResults &results) const;

    /** Whether the forces of an effect may start abruptly. */
    bool has_contact_candidates() const;

    /** Reason to reject a solved step and repeat it in shorter ones; empty to
     * accept. Equal on all ranks; collective. */
    std::string rejection_reason(const Evaluation &step) const;

    /** Reason for a residual that is not finite; empty if unknown. Equal on all
     * ranks; collective. */
    std::string nonfinite_reason(const Evaluation        &evaluation,
                                 const EvaluationResults &results) const;

  private:
    void make_internal_forces();
    void make_contact();
    void make_constraints();
    void make_inertia();
    void make_loads();
    /** Throws InputError for a tolerance without an error estimate. */
    void refuse_unknown_errors() const;
    void enter_energies();
    void register_blocks();
    /** Updates displacements and velocities of ghosts in @p state. */
    void update_ghosts(State &state) const;
    /** StageTerms::account_stage() of all effects. */
    void add_stage(const Evaluation        &stage,
                   const EvaluationResults &results,
                   EnergyAccount           &account) const;
    using CouplingUpdate = bool (ChangingCouplings::*)(const State &,
                                                       std::vector<int> &);
    /** Updates couplings of all effects, then pattern and ghosts if these
     * change; returns whether @p accepted gained ghosts. */
    bool update_pattern(CouplingUpdate update, State &accepted);

    /** An effect that implements an additional interface. */
    template <class Terms>
    struct Implementation
    {
      unsigned int effect; ///< index in `effects`
      Terms       *terms;
    };

    /** All effects that implement Terms. */
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
    /** @name Effects by additional interface. */
    ///@{
    std::vector<Implementation<StageTerms>>        stage_terms;
    std::vector<Implementation<SmallMotionTerms>>  small_motion_terms;
    std::vector<Implementation<ChangingCouplings>> changing_couplings;
    ///@}
    /** Number of leading effects that are internal forces; their sum is the
     * force scale. */
    unsigned int n_internal = 0;
    /** Number of leading effects that are internal or inertia forces; the
     * others are loads. */
    unsigned int     n_balanced = 0;
    ReportingEffects reporting_effects;
    StateLayout      state_layout;
    /** Unknowns with additional ghosts; nullptr if there are none. */
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
   * Tolerance (m) of the constraints: their round-off. A looser tolerance would
   * appear as force errors, divided by the square of the step. Collective.
   */
  double constraint_tolerance(const Equations &equations, const State &state);

  /**
   * Describes a quantity of @p state that is not finite; empty if all are
   * finite. Equal on all ranks; collective.
   */
  std::string nonfinite_quantity(const LatticeModel &model, const State &state);

  /** Describes the unknown with the largest free residual over all ranks. */
  std::string unknown_with_largest_residual(const LatticeModel &model,
                                            const State        &state);
} // namespace auxfem

#endif
