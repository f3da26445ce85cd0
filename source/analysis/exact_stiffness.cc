#include <auxfem/analysis/exact_stiffness.h>
#include <auxfem/analysis/small_motions/mode_space.h>
#include <auxfem/parameters/errors.h>

namespace auxfem
{
  namespace
  {
    const std::string stiffness_record =
                        "error of small displacements, stiffness",
                      rest_record = stiffness_record + " at rest";
  } // namespace

  ExactStiffness::ExactStiffness(TangentSolver &solver, const double inertia)
    : solver(solver)
    , inertia(inertia)
  {}

  State ExactStiffness::at_rest() const
  {
    State rest = solver.equations().initial_state();
    for (std::optional<Vector> *rates : {&rest.velocity, &rest.acceleration})
      if (*rates)
        (*rates)->assign((*rates)->size(), 0.);
    return rest;
  }

  void ExactStiffness::assemble_at_rest()
  {
    const State       before     = at_rest();
    State             now        = before;
    EvaluationResults results    = solver.equations().make_results();
    const Evaluation  evaluation = Evaluation::equilibrium(before, now);
    solver.residual(evaluation, results);
    solver.assemble(evaluation, results, {1., 0., inertia});
  }

  bool ExactStiffness::take_that_of_rest()
  {
    if (is_of_rest())
      return true;
    forget();
    try
      {
        assemble_at_rest();
      }
    catch (const ComputationError &)
      {
        // A load that is no number at t = 0: the run will tell.
        return false;
      }
    if (solver.factorize(Exactness::approximate))
      factorized = Factorized::at_rest;
    return is_of_rest();
  }

  bool ExactStiffness::factorize(const Evaluation        &evaluation,
                                 const EvaluationResults &results)
  {
    solver.assemble(evaluation, results, {1., 0., inertia});
    // The symmetric part serves as well, for less, and has an inertia.
    factorized = solver.factorize(Exactness::approximate)
      ? Factorized::at_another_state
      : Factorized::nothing;
    return is_of_another();
  }

  std::optional<bool> ExactStiffness::is_positive(const Evaluation &evaluation)
  {
    EvaluationResults results = solver.equations().make_results();
    solver.residual(evaluation, results);
    if (!factorize(evaluation, results))
      return {};
    if (const auto modes = solver.new_negative_modes())
      return modes->n == 0;
    const std::optional<int> sign = ModeSpace(solver).determinant_sign();
    return sign ? std::optional<bool>(*sign > 0) : std::nullopt;
  }

  void ExactStiffness::end_look()
  {
    solver.matrix().release();
    if (is_of_another())
      forget();
  }

  void ExactStiffness::save(Records &records) const
  {
    solver.save(stiffness_record, /*with_factorization=*/false, records);
    records.keep(rest_record, {is_of_rest() ? 1. : 0.});
  }

  void ExactStiffness::resume(const Records &records)
  {
    solver.resume(stiffness_record, records);
    if (records.values(rest_record, 1)[0] == 0)
      return;
    assemble_at_rest();
    if (solver.factorize_again(Exactness::approximate))
      factorized = Factorized::at_rest;
    end_look();
  }
} // namespace auxfem
