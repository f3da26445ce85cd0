#ifndef auxfem_equations_evaluation_h
#define auxfem_equations_evaluation_h

#include <auxfem/loads/time_function.h>
#include <auxfem/state/state.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * Input of an evaluation of the equations: the state `to`, reached from the
   * accepted state `from`, and the kind of step between them.
   */
  struct Evaluation
  {
    enum class Kind
    {
      /** End of a step with inertia; the time scheme gives velocities and
       * accelerations. */
      step,
      /** Stage of a step with inertia (RungeKutta). Backward Euler integrates
       * all differential equations from the base `from`. */
      stage,
      /** Step with inertia and mean forces whose work equals the energy change
       * (discrete gradient, Gonzalez 1996). Accelerations of `to` are means;
       * moments do work on the Cayley measure of rotation increments
       * (mathematics/cayley_rotation.h). */
      discrete_gradient,
      /** End of a step without inertia; rates are differences over the step. */
      static_step,
      /** Static equilibrium with fully relaxed viscosity. */
      equilibrium,
      /** An instant. With inertia the rows of constraints hold their second
       * time derivatives, which determine consistent accelerations. */
      consistent_rates
    };

    const State &from;
    /** Receives the residual and the internal variables. */
    State &to;
    Kind   kind;
    /** Length of the step (s); 0 for other kinds. */
    double dt = 0;
    /** Exact times (s) of events of the loads at `from` and `to`, and the side
     * on which loads at `to` are evaluated. A step starts with the values just
     * after an event. */
    std::optional<double>    event_at_from = {};
    std::optional<TimeLimit> event_at_to   = {};
    /** Whether this is the equilibrium at the start of a run, in which a
     * material may not have relaxed yet. */
    bool starts_run = false;
    /** Impulses (N s, N m s) at an instant where a support velocity jumps; they
     * turn the velocities of `from` into those of `to`. */
    const Vector *impulses = nullptr;
    /** Weight of the power of a stage in the step (s). */
    double weight = 0;
    /** Whether the step ends with this stage. */
    bool ends_step = false;

    /** Two vectors x, y of a product x.M y. */
    struct Pair
    {
      Vector first, second;
    };
    /** Set for the last stage of a step: the sum of first.M second is the
     * kinetic energy lost by the scheme for a constant mass matrix M; see
     * ButcherTableau::missed_growth(). */
    const std::vector<Pair> *kinetic_defect_terms = nullptr;

    /** A step with inertia of the length @p dt (s). */
    static Evaluation step(const State &from, State &to, const double dt)
    {
      return {from, to, Kind::step, dt};
    }

    /** A stage with the backward Euler length @p dt (s). */
    static Evaluation
    stage(const State &base, State &to, const double dt, const double weight)
    {
      Evaluation stage{base, to, Kind::stage, dt};
      stage.weight = weight;
      return stage;
    }

    /** A step with mean forces. */
    static Evaluation
    discrete_gradient(const State &from, State &to, const double dt)
    {
      return {from, to, Kind::discrete_gradient, dt};
    }

    /** A step without inertia of the length @p dt (s). */
    static Evaluation static_step(const State &from, State &to, const double dt)
    {
      return {from, to, Kind::static_step, dt};
    }

    /** Search of the static equilibrium @p to. */
    static Evaluation equilibrium(const State &from, State &to)
    {
      return {from, to, Kind::equilibrium};
    }

    /** The instant @p to; @p before is a copy of it. */
    static Evaluation consistent_rates(const State &before, State &to)
    {
      return {before, to, Kind::consistent_rates};
    }

    /** Whether rates of strains and extensions are differences over the step.
     */
    bool rates_are_differences() const
    {
      return kind == Kind::discrete_gradient || kind == Kind::static_step;
    }

    /** Whether the rows of constraints hold second derivatives. */
    bool has_constraint_accelerations() const
    {
      return kind == Kind::consistent_rates && to.acceleration;
    }
  };

  /**
   * Intermediate results of an effect besides forces. The caller keeps them for
   * the tangent, energies and output of the same evaluation.
   */
  struct EffectCache
  {
    virtual ~EffectCache() = default;
  };

  /** Results of an evaluation besides the residual and internal variables. */
  struct EvaluationResults
  {
    /** By effect, in the order of the equations. */
    std::vector<std::unique_ptr<EffectCache>> effect_caches;

    /** Norms of the residual in free rows, over all ranks. */
    double force      = 0; ///< N
    double moment     = 0; ///< N m
    double constraint = 0; ///< m

    /** Reference force (N) of the residual: norm of internal forces, or of
     * internal and inertia forces if larger. It includes prescribed rows, and
     * moments are divided by the mean strut length. Not finite if any force is
     * not. */
    double force_scale = 0;
  };
} // namespace auxfem

#endif
