#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/time/row_criterion.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Residual allowed in a single row over the tolerance of the norm of all
     * rows.
     * @tuned observed: rows of sound scenes hardly ever need an extra
     *   iteration
     */
    constexpr double row_tolerance_factor = 300;
  } // namespace

  RowCriterion::RowCriterion(const Equations &equations, const double tolerance)
    : equations(equations)
    , tolerance(row_tolerance_factor * tolerance)
  {}

  double RowCriterion::excess(const Evaluation        &evaluation,
                              const EvaluationResults &results) const
  {
    State  &to     = evaluation.to;
    Vector &forces = to.largest_forces;
    forces         = evaluation.from.largest_forces;
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i] = std::max(forces[i], std::abs(to.residual[i]));
    equations.row_force_bounds(evaluation, results, forces.data());
    return largest_excess(to, nullptr);
  }

  double
  RowCriterion::excess_beyond_round_off(const Evaluation        &evaluation,
                                        const EvaluationResults &results) const
  {
    return largest_excess(evaluation.to,
                          equations.round_off(evaluation, results).data());
  }

  double RowCriterion::largest_excess(const State  &state,
                                      const double *round_off) const
  {
    const LatticeModel &model  = equations.model();
    double              excess = 1;
    for (const std::vector<int> *rows :
         {&model.rows.free_translations, &model.rows.free_rotations})
      for (const int row : *rows)
        {
          const double norm    = std::abs(state.residual[row]);
          const double allowed = tolerance * state.largest_forces[row] +
            (round_off ? round_off[row] : 0.) + smallest_full_precision;
          if (!(norm <= excess * allowed))
            excess = norm / allowed;
        }
    return model.numbering.layout().largest(excess);
  }
} // namespace auxfem
