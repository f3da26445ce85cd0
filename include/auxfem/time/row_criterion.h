#ifndef auxfem_time_row_criterion_h
#define auxfem_time_row_criterion_h

#include <auxfem/equations/equations.h>

namespace auxfem
{
  /**
   * Row-wise convergence criterion of Newton: relates the residual of each
   * free row to the forces in that row, so that weak parts converge like
   * strong ones.
   *
   * The forces of a row are loads and those of struts, connectors, springs and
   * multipliers; the largest of this iterate and of all accepted steps count.
   * Inertia is not among them: it balances these forces.
   */
  class RowCriterion
  {
  public:
    /**
     * @param equations must outlive the object.
     * @param tolerance of the norm of all rows; a single row may have a few
     *   hundred times as much.
     */
    RowCriterion(const Equations &equations, double tolerance);

    /**
     * Largest residual at evaluation.to over the allowed one of its row, at
     * least 1. Sets State::largest_forces of evaluation.to. Collective.
     * @param results of the residual in the same evaluation
     */
    double excess(const Evaluation        &evaluation,
                  const EvaluationResults &results) const;

    /**
     * The same after excess(), with the round-off of each row allowed as well.
     */
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
