#include <auxfem/algebra/full_precision.h>
#include <auxfem/analysis/row_criterion.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /**
     * Residual of a single row over the tolerance of the norm of all rows.
     * @tuned observed: rows of sound scenes hardly ever ask for an iteration
     */
    constexpr double allowed_in_a_row = 300;
  } // namespace

  RowCriterion::RowCriterion(const Equations &equations, const double tolerance)
    : equations(equations)
    , tolerance(allowed_in_a_row * tolerance)
  {}

  double RowCriterion::excess(const Evaluation        &evaluation,
                              const EvaluationResults &results) const
  {
    State  &to     = evaluation.to;
    Vector &forces = to.largest_forces;
    forces         = evaluation.from.largest_forces;
    for (std::size_t i = 0; i < forces.size(); ++i)
      forces[i] = std::max(forces[i], std::abs(to.residual[i]));
    equations.raise_forces(evaluation, results, forces.data());
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
    const LatticeModel &model = equations.model();
    double              worst = 1;
    for (const std::vector<int> *rows :
         {&model.rows.free_translations, &model.rows.free_rotations})
      for (const int row : *rows)
        {
          const double size    = std::abs(state.residual[row]);
          const double allowed = tolerance * state.largest_forces[row] +
            (round_off ? round_off[row] : 0.) + least_of_full_precision;
          if (!(size <= worst * allowed))
            worst = size / allowed;
        }
    return model.numbering.layout().largest(worst);
  }
} // namespace auxfem
