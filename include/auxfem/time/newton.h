#ifndef auxfem_time_newton_h
#define auxfem_time_newton_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/time/row_criterion.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * An equation with one unknown of its own, solved together with the lattice;
   * path following uses one for the load factor.
   */
  class AddedEquation
  {
  public:
    virtual ~AddedEquation() = default;

    /**
     * Completes @p increment, which solves the lattice equations for a fixed
     * added unknown, so that the added equation holds too. Updates that
     * unknown in evaluation.to. Returns false if @p solver, whose tangent is
     * factorized, fails. Collective.
     */
    virtual bool complete(TangentSolver    &solver,
                          const Evaluation &evaluation,
                          Vector           &increment) = 0;

    /**
     * Undoes the @p part of the last complete(); @p reversed_increment stands
     * for the increment.
     */
    virtual void undo_increment(const Evaluation &evaluation,
                                const Vector     &reversed_increment,
                                double            part) = 0;
  };

  /**
   * Newton's method for one step, with Jacobian reuse.
   *
   * A step is solved when three conditions hold. Free force rows are below
   * tolerance * F + floor, moment rows below (tolerance * F + floor) * l.
   * Every row meets RowCriterion. Constraints hold to their own round-off. F
   * (N) is the largest internal force of this iterate and of all accepted
   * steps, l (m) the mean strut length, floor (N) the round-off of the
   * residual.
   *
   * With NewtonParameters::estimates_stages, a stage whose convergence is
   * predicted after one iteration needs no further residual.
   */
  class Newton
  {
  public:
    /** @param solver must outlive the object. */
    Newton(TangentSolver &solver, const NewtonParameters &parameters);

    /** Outcome of solve(). */
    struct Result
    {
      bool         converged  = false;
      unsigned int iterations = 0;
      /** Residual norm over the force scale. */
      double relative_residual = 0;
      /** Why Newton's method did not converge; empty if it did. */
      std::string reason;
    };

    /**
     * Solves for evaluation.to, which the scheme has predicted. On convergence
     * also sets its State::largest_force and State::largest_forces.
     * @param added solved as well unless it is nullptr
     */
    Result solve(const ImplicitScheme &scheme,
                 const Evaluation     &evaluation,
                 EvaluationResults    &results,
                 AddedEquation        *added = nullptr);

    /**
     * Reuses the tangent of @p evaluation with @p factors, which the solver
     * has factorized.
     */
    void adopt_factorization(const Evaluation     &evaluation,
                             const TangentFactors &factors);

    /**
     * Factorizes the tangent at the start of a step, before prediction, if
     * later steps can reuse it. The tangent of a predicted state may suit no
     * other step.
     */
    void factorize_ahead(const ImplicitScheme &scheme,
                         const Evaluation     &evaluation,
                         EvaluationResults    &results);

    /** Drops the factorization, for instance after the state jumped. */
    void drop_factorization()
    {
      stored.reset();
    }

    /**
     * Called when no static step from @p start has a solution. From an
     * unstressed state, later increments are limited to small rotations: a
     * straight cable resists by tension only, and its tangent predicts
     * arbitrary motions. Returns whether another attempt is worthwhile.
     */
    bool allow_slack(const State &start);

    /**
     * First Newton increment of the last static step, along the tangent at its
     * start (m, rad).
     */
    const Vector &predicted_increment() const
    {
      return first_increment;
    }

    /**
     * Resets everything remembered of earlier steps, so that later steps
     * depend on the state alone. Linear equations keep their factorization, as
     * another one would have equal digits.
     */
    void restart();

  private:
    /** A stored factorization and the step that it belongs to. */
    struct StoredFactorization
    {
      Evaluation::Kind kind;
      double           dt;
      TangentFactors   factors;
      unsigned long    pattern_version;
      bool             is_exact;
      /** Whether only the last iteration has used it. */
      bool is_fresh;
      /**
       * Residual reduction by one iteration, if the last evaluation needed
       * only one. Empty if it needed more or made this tangent.
       */
      std::optional<double> reduction = {};
    };

    /** Whether factorizations serve later iterations. Not in statics with
     * struts that yield: without inertia their tangents change too much. */
    bool keeps_factorization(const ImplicitScheme &scheme) const;

    /**
     * Factorizes unless the stored factorization can be reused; false if
     * singular.
     */
    bool prepare(const ImplicitScheme    &scheme,
                 const Evaluation        &evaluation,
                 const EvaluationResults &results,
                 double                   reduction);
    /**
     * Whether the residual norm @p norm (N) is small against the largest force
     * @p scale (N).
     */
    bool is_small(const Evaluation        &evaluation,
                  const EvaluationResults &results,
                  double                   norm,
                  double                   scale,
                  bool                     stagnates) const;
    /**
     * Whether one iteration is predicted to suffice, so that no residual is
     * needed. The prediction scales @p norm (N), the residual before it, with
     * the last reduction.
     */
    bool   can_skip_residual(const Evaluation &evaluation,
                             double            norm,
                             double            scale) const;
    bool   meets_constraints(const EvaluationResults &results,
                             const State             &state) const;
    double in_force_units(const EvaluationResults &results) const;
    /**
     * Starts from the positions at the start of the step if the residual @p
     * norm (N) of the predicted state exceeds all forces so far and theirs is
     * smaller: predicted waves along struts would let fibres yield that do not.
     * Returns the residual norm (N).
     */
    double try_old_positions(const ImplicitScheme &scheme,
                             const Evaluation     &evaluation,
                             EvaluationResults    &results,
                             double                norm);
    /**
     * Line search: halves the last increment until the residual norm is below
     * @p before (N). If it never is, restores the full length or, with inertia,
     * that of the least norm. Returns the residual norm (N).
     * @param full norm with the whole increment (N)
     */
    double backtrack(const ImplicitScheme &scheme,
                     const Evaluation     &evaluation,
                     EvaluationResults    &results,
                     AddedEquation        *added,
                     double                before,
                     double                full);
    /**
     * Undoes the @p part of the last increment; returns the residual norm (N).
     */
    double undo_increment(const ImplicitScheme &scheme,
                          const Evaluation     &evaluation,
                          EvaluationResults    &results,
                          AddedEquation        *added,
                          double                part);
    /**
     * Solves for the increment and applies it. Returns why it failed, or
     * nothing.
     */
    std::string iterate(const ImplicitScheme &scheme,
                        const Evaluation     &evaluation,
                        AddedEquation        *added);

    TangentSolver         &solver;
    const NewtonParameters parameters;
    const RowCriterion     rows;
    const bool             is_linear, yields, has_kinked_laws, supports_rest;
    /** Whether residuals of stages can be predicted. */
    const bool          estimates_stages;
    const NodeRotations rotations;
    Vector              increment;
    /** The last increment, for line search; rotations in space are spins. */
    Vector                             last_increment;
    Vector                             first_increment;
    std::optional<StoredFactorization> stored;
    Exactness                          exactness = Exactness::exact;
    /**
     * Whether the last attempt failed; the next one then uses exact tangents.
     */
    bool has_failed = false;
    /** Whether the last step needed at most one new tangent after its first
     * iteration, so that the next one begins with its last. */
    bool earlier_tangent_serves = true;
    /** Whether forces may change abruptly in the step: contact may begin, or
     * struts may yield. */
    bool has_kinks = false;
    /**
     * Whether rotations of increments are limited, in general and in this
     * step.
     */
    bool allows_slack = false, is_slack = false;
  };
} // namespace auxfem

#endif
