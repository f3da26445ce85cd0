#ifndef auxfem_equations_evaluation_h
#define auxfem_equations_evaluation_h

#include <auxfem/loads/time_function.h>
#include <auxfem/state/state.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * What is asked of the equations: the forces at the state `to`, which was
   * reached from the accepted state `from` in the way its kind says.
   */
  struct Evaluation
  {
    enum class Kind
    {
      /**
       * The end of a step with inertia: velocities and accelerations are those
       * of the time scheme.
       */
      step,
      /**
       * A stage of a step with inertia (see RungeKutta): `from` is its base,
       * from which all that obeys a differential equation follows by Euler's
       * backward rule.
       */
      stage,
      /**
       * A step with inertia between two states: forces are means over it, whose
       * work on the increment is the change of energy and which do none on
       * rigid motions (a discrete gradient, Gonzalez 1996). Accelerations of
       * `to` are means too. Moments do work on Cayley's measure of the rotation
       * increment (elements/cayley_rotation.h).
       */
      discrete_gradient,
      /**
       * The end of a step without inertia: rates are differences over the step.
       */
      static_step,
      /** Static equilibrium, all viscous processes having come to rest. */
      equilibrium,
      /**
       * An instant: no time passes. With inertia the rows of constraints hold
       * their second derivatives, which determine consistent accelerations.
       */
      consistent_rates
    };

    const State &from;
    /** Receives the residual and the internal variables. */
    State &to;
    Kind   kind;
    /** Length of the step (s); 0 if the kind is no step. */
    double dt = 0;
    /**
     * Where functions of time may jump, or their derivatives, at the times of
     * `from` and `to`: when that is exactly, and of `to` the side from which
     * they are taken. A step begins with what they are just after (s).
     */
    std::optional<double>    event_at_from = {};
    std::optional<TimeLimit> event_at_to   = {};
    /**
     * Of an instant at which supports strike: their impulses (N s, N m s), by
     * which the velocities of `from` became those of `to`.
     */
    const Vector *impulses = nullptr;
    /** Of a stage: the time for which its power counts in the step (s). */
    double weight = 0;
    /** Of a stage: whether the step ends with it. */
    bool ends_step = false;

    /** Two vectors that are multiplied by way of a matrix between them. */
    struct Pair
    {
      Vector first, second;
    };
    /**
     * Of the last stage of a step: the sum of all first.M second is what the
     * scheme takes from the kinetic energy of a constant mass matrix M, see
     * ButcherTableau::missed_growth().
     */
    const std::vector<Pair> *taken_from_kinetic = nullptr;

    /** A step with inertia of the length @p dt (s). */
    static Evaluation step(const State &from, State &to, const double dt)
    {
      return {from, to, Kind::step, dt};
    }

    /** A stage for which the rule has the length @p dt (s). */
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

    /** The search for the static equilibrium @p to. */
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
    bool wants_constraint_accelerations() const
    {
      return kind == Kind::consistent_rates && to.acceleration;
    }
  };

  /**
   * What an effect produces beside forces when it is evaluated, kept by the
   * caller for the tangent, the energies and the output of the same evaluation.
   */
  struct EffectCache
  {
    virtual ~EffectCache() = default;
  };

  /** What an evaluation produces beside the residual and internal variables. */
  struct EvaluationResults
  {
    /** Of every effect that has some, in the order of the equations. */
    std::vector<std::unique_ptr<EffectCache>> effect_caches;

    /** Norms of the residual in free rows, over all ranks. */
    double force      = 0; ///< N
    double moment     = 0; ///< N m
    double constraint = 0; ///< m, of constraints

    /**
     * Force size against which the residual is judged (N): norm of the internal
     * forces or of internal and inertia forces, whichever is larger, prescribed
     * rows included, moments divided by the mean strut length. Not finite if a
     * force in any row is not.
     */
    double force_scale = 0;
  };
} // namespace auxfem

#endif
