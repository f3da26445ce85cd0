#ifndef auxfem_time_newton_h
#define auxfem_time_newton_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * Measures every free row of the residual by the forces that act in that row
   * alone, so that a weak part is solved as well as a strong one beside it.
   *
   * The forces of a row are those of the struts, connectors, springs and
   * multipliers that end there, and the loads, the largest of this iterate and
   * of all accepted steps. Inertia is what balances these.
   */
  class RowCriterion
  {
  public:
    /**
     * @param equations must outlive the object.
     * @param tolerance of the norm of all rows; a row of its own is granted
     *   some hundred times as much.
     */
    RowCriterion(const Equations &equations, double tolerance);

    /**
     * Largest residual at evaluation.to as a multiple of what is allowed in its
     * row; 1 if all rows are allowed. Sets State::largest_forces of
     * evaluation.to. Collective.
     * @param results of the residual in the same evaluation
     */
    double excess(const Evaluation        &evaluation,
                  const EvaluationResults &results) const;

    /** The same after excess(), the round-off of each row allowed as well. */
    double excess_beyond_round_off(const Evaluation        &evaluation,
                                   const EvaluationResults &results) const;

  private:
    /** @param round_off by row, or nullptr. */
    double largest_excess(const State &state, const double *round_off) const;

    const Equations &equations;
    const double     tolerance;
  };

  /**
   * An unknown and an equation beside those of the lattice, solved together
   * with them.
   */
  class AddedEquation
  {
  public:
    virtual ~AddedEquation() = default;

    /**
     * Completes @p increment, which solves the equations of the lattice at
     * evaluation.to with the unknown as it is, such that the added equation
     * holds too, and changes the unknown in evaluation.to. Returns false if
     * @p solver, which has the tangent factorized, fails. Collective.
     */
    virtual bool complete(TangentSolver    &solver,
                          const Evaluation &evaluation,
                          Vector           &increment) = 0;

    /** Takes back the @p part of what complete() has changed last, with
     * @p reversed_increment in place of the increment. */
    virtual void undo_increment(const Evaluation &evaluation,
                                const Vector     &reversed_increment,
                                double            part) = 0;
  };

  /**
   * Newton's method for one step, with the factorization kept as long as it
   * serves.
   *
   * A step is solved when the free force rows are below tolerance * F + floor
   * and the moment rows below (tolerance * F + floor) * l: F the largest
   * internal force of this iterate and of all accepted steps, l the mean strut
   * length, floor the round-off of the residual itself, below which no
   * iteration can go. And every row must be solved by the measure of the forces
   * that act in it (RowCriterion). The constraints of rigid parts must hold to
   * their own round-off.
   *
   * If NewtonParameters::estimates_stages, the residual at a stage within a
   * step is not computed where a single iteration is known to be enough by the
   * evaluation before.
   */
  class Newton
  {
  public:
    /** @param solver must outlive the object. */
    Newton(TangentSolver &solver, const NewtonParameters &parameters);

    /** What came of an attempt. */
    struct Result
    {
      bool         converged  = false;
      unsigned int iterations = 0;
      /** In units of the force scale. */
      double relative_residual = 0;
      /** Why it did not converge. */
      std::string reason;
    };

    /**
     * Solves evaluation.to, which the scheme has predicted; of a solved one
     * State::largest_force and State::largest_forces too.
     * @param added solved as well if it is not nullptr
     */
    Result solve(const ImplicitScheme &scheme,
                 const Evaluation     &evaluation,
                 EvaluationResults    &results,
                 AddedEquation        *added = nullptr);

    /** The solver has factorized the tangent of @p evaluation with @p factors.
     */
    void adopt_factorization(const Evaluation     &evaluation,
                             const TangentFactors &factors);

    /**
     * Factorizes the tangent of @p evaluation, of a step that has not moved yet,
     * if following steps use it: that at a predicted state may serve none.
     */
    void factorize_ahead(const ImplicitScheme &scheme,
                         const Evaluation     &evaluation,
                         EvaluationResults    &results);

    /** Forgets the factorization (the state jumped). */
    void drop_factorization()
    {
      stored.reset();
    }

    /**
     * No static step from @p start has a solution. If it is without forces,
     * increments from there are shortened to small turns from now on: a
     * straight cable resists by tension only, and its tangent predicts any
     * motion. Returns whether another attempt is worth while.
     */
    bool allow_slack(const State &start);

    /** First increment of the last static step, along the tangent at its start
     * (m, rad). */
    const Vector &predicted_increment() const
    {
      return first_increment;
    }

    /**
     * Forgets what earlier steps have left, so that the steps from here on
     * depend on the state alone. Linear equations keep their factorization:
     * another one of theirs would be equal to the last digit.
     */
    void restart();

  private:
    /** What a kept factorization belongs to. */
    struct StoredFactorization
    {
      Evaluation::Kind kind;
      double           dt;
      TangentFactors   factors;
      unsigned long    pattern_version;
      bool             is_exact;
      /** Whether no iteration has used it yet but the last. */
      bool is_fresh;
      /** Factor by which an iteration with it has reduced the residual of the
       * last evaluation, if that needed no other; none: it needed more, or is
       * the one whose tangent this is. */
      std::optional<double> reduction = {};
    };

    /** Factorizes unless the kept factorization serves; false if singular. */
    bool prepare(const ImplicitScheme    &scheme,
                 const Evaluation        &evaluation,
                 const EvaluationResults &results,
                 double                   reduction);
    /** Whether the residual is small beside the largest force @p scale (N). */
    bool is_small(const Evaluation        &evaluation,
                  const EvaluationResults &results,
                  double                   size,
                  double                   scale,
                  bool                     stagnates) const;
    /** Whether the residual, of @p size (N) before the first iteration, is small
     * enough after it as those of evaluations before were, and nothing else
     * needs it. */
    bool   can_skip_residual(const Evaluation &evaluation,
                             double            size,
                             double            scale) const;
    bool   meets_constraints(const EvaluationResults &results,
                             const State             &state) const;
    double in_force_units(const EvaluationResults &results) const;
    /**
     * Line search: shortens the last increment until the residual is smaller
     * than
     * @p before (N); if none of some attempts is, it has its length again. Returns
     * the size of the residual (N).
     */
    double backtrack(const ImplicitScheme &scheme,
                     const Evaluation     &evaluation,
                     EvaluationResults    &results,
                     AddedEquation        *added,
                     double                before);
    /** Takes back the @p part of the last increment; returns the size of the
     * residual (N). */
    double undo_increment(const ImplicitScheme &scheme,
                          const Evaluation     &evaluation,
                          EvaluationResults    &results,
                          AddedEquation        *added,
                          double                part);
    /** Solves for the increment and applies it; empty, or why it failed. */
    std::string iterate(const ImplicitScheme &scheme,
                        const Evaluation     &evaluation,
                        AddedEquation        *added);

    TangentSolver         &solver;
    const NewtonParameters parameters;
    const RowCriterion     rows;
    const bool             is_linear, supports_rest;
    /** Whether residuals of stages can be estimated. */
    const bool          estimates_stages;
    const NodeRotations rotations;
    Vector              increment;
    /** The last one that line search may shorten, rotations in space as spins.
     */
    Vector                             last_increment;
    Vector                             first_increment;
    std::optional<StoredFactorization> stored;
    Exactness                          exactness = Exactness::exact;
    /** Whether the last attempt did, so that the next one takes more care. */
    bool has_failed = false;
    /** Whether forces of contact may begin in the step. */
    bool has_contact_candidates = false;
    /** Whether increments are shortened, and whether they are in this step. */
    bool allows_slack = false, is_slack = false;
  };
} // namespace auxfem

#endif
