#ifndef auxfem_analysis_row_criterion_h
#define auxfem_analysis_row_criterion_h

#include <auxfem/equations/equations.h>

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
} // namespace auxfem

#endif
