#include <auxfem/algebra/direct_solver.h>
#include <auxfem/algebra/linear_solver.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace auxfem
{
  namespace
  {
    const LinearSolverChoice mumps_with_pivoting =
      {LinearSolverType::mumps, "indefinite matrix that needs pivoting"};
  } // namespace

  LinearSolver::LinearSolver(const SolverParameters &parameters,
                             const TangentMatrix    &matrix)
    : parameters(parameters)
    , matrix(matrix)
    , n_prescribed(
        matrix.pattern().unknowns().n_of_kind(UnknownKind::prescribed))
    , n_multipliers(
        matrix.pattern().unknowns().n_of_kind(UnknownKind::multiplier))
    , condensation(matrix)
  {}

  FactorizationOutcome LinearSolver::factorize(const Exactness exactness)
  {
    FactorizationOutcome outcome = FactorizationOutcome::out_of_memory;
    try
      {
        outcome = try_to_factorize(exactness);
      }
    catch (const std::bad_alloc &)
      {
        // The other ranks are inside collective calls and cannot be notified.
        if (matrix.pattern().unknowns().layout.n_ranks() > 1)
          throw;
      }
    failure_reason = message(outcome);
    return outcome;
  }

  Symmetry LinearSolver::choose_symmetry(const Exactness exactness)
  {
    solves_given_matrix    = true;
    const double asymmetry = matrix.asymmetry();
    // The factorization detects NaN.
    if (!(asymmetry > TangentMatrix::symmetric_to_round_off))
      return Symmetry::given;
    if (exactness == Exactness::exact && matrix.is_symmetric())
      return Symmetry::enforced;
    const bool solves_unsymmetric = parameters.type != "cholmod";
    solves_given_matrix           = solves_unsymmetric &&
      !(exactness == Exactness::approximate &&
        symmetric_part_pays(parameters,
                            asymmetry,
                            matrix.pattern().unknowns().layout.n_global()));
    return solves_given_matrix ? Symmetry::none : Symmetry::enforced;
  }

  FactorizationOutcome LinearSolver::try_to_factorize(const Exactness exactness)
  {
    symmetry                     = choose_symmetry(exactness);
    FactorizationOutcome outcome = condensation.condense(symmetry);
    if (outcome != FactorizationOutcome::done)
      return outcome;
    const LinearSolverChoice choice =
      choose_linear_solver(parameters, equations_at_joints());
    outcome                       = factorize_joints(choice);
    const bool retries_with_mumps = parameters.type == "auto" &&
      ((outcome == FactorizationOutcome::singular &&
        choice.type == LinearSolverType::cholmod) ||
       (outcome == FactorizationOutcome::too_large &&
        choice.type != LinearSolverType::mumps));
    if (!retries_with_mumps)
      return outcome;
    if (outcome == FactorizationOutcome::too_large)
      return factorize_joints(
        {LinearSolverType::mumps,
         "factors too large for " + name_of(choice.type)});
    return factorize_joints(mumps_with_pivoting);
  }

  EquationsAtJoints LinearSolver::equations_at_joints() const
  {
    const UnknownLayout &layout = condensation.joints().layout;
    EquationsAtJoints    equations;
    equations.symmetry      = symmetry;
    equations.n_unknowns    = layout.n_global();
    equations.n_multipliers = n_multipliers;
    equations.n_ranks       = layout.n_ranks();
    equations.n_components  = condensation.joints().components.size();
    return equations;
  }

  std::unique_ptr<LinearSolverMethod>
  LinearSolver::make_method(const LinearSolverType type) const
  {
    return make_linear_solver_method(type, equations_at_joints(), parameters);
  }

  FactorizationOutcome
  LinearSolver::factorize_joints(const LinearSolverChoice &choice)
  {
    Analysed &analysed = methods[choice.type];
    if (!analysed.method)
      analysed.method = make_method(choice.type);
    current                = analysed.method.get();
    description_of_current = name_of(choice.type) + " (" + choice.reason + ")";
    if (analysed.version != condensation.version())
      {
        analysed.version.reset();
        const FactorizationOutcome outcome =
          current->analyse(condensation.matrix(), condensation.joints());
        if (outcome != FactorizationOutcome::done)
          return outcome;
        analysed.version = condensation.version();
      }
    return current->factorize(condensation.matrix());
  }

  std::string LinearSolver::message(const FactorizationOutcome outcome) const
  {
    switch (outcome)
      {
        case FactorizationOutcome::done:
          return "";
        case FactorizationOutcome::singular:
          return "the matrix is singular" +
            (condensation.description().empty()
               ? ""
               : " in " + condensation.description());
        case FactorizationOutcome::not_finite:
          return "the matrix has entries that are not finite" +
            (condensation.description().empty()
               ? ""
               : " in " + condensation.description());
        case FactorizationOutcome::out_of_memory:
          return "the factorization ran " + out_of_memory_text();
        case FactorizationOutcome::too_large:
          return "the factors have more entries than " +
            description_of_current +
            " can count. Set Solver/Type to `auto`, `mumps` or `gmres`, or "
            "start auxfem on more ranks (mpirun -n ...)";
      }
    Assert(false, dealii::ExcInternalError());
    return "";
  }

  std::optional<Inertia> LinearSolver::inertia()
  {
    const std::optional<Inertia> inner = condensation.inner_inertia();
    if (current == nullptr || !failure_reason.empty() || !inner)
      return std::nullopt;
    std::optional<Inertia> sum = current->inertia();
    // KLU does not compute inertia.
    const auto klu = methods.find(LinearSolverType::klu);
    if (!sum && klu != methods.end() && current == klu->second.method.get())
      sum = inertia_by_mumps();
    if (!sum)
      return std::nullopt;
    sum->negative += inner->negative;
    sum->positive += inner->positive;
    sum->positive -= n_prescribed;
    return sum;
  }

  std::optional<NegativeModes> LinearSolver::negative_modes()
  {
    const std::optional<Inertia> inner = condensation.inner_inertia();
    if (current == nullptr || !failure_reason.empty() || !inner)
      return std::nullopt;
    if (const std::optional<Inertia> all = inertia())
      return NegativeModes{all->negative -
                             std::min(all->negative, n_multipliers),
                           false};
    const std::optional<unsigned long> at_joints =
      current->n_negative_at_least();
    return at_joints
      ? std::optional(NegativeModes{inner->negative + *at_joints, true})
      : std::nullopt;
  }

  std::optional<int> LinearSolver::determinant_sign() const
  {
    if (current == nullptr || !failure_reason.empty() || !solves_given_matrix)
      return std::nullopt;
    std::optional<int> sign = current->determinant_sign();
    if (sign)
      *sign *= condensation.inner_determinant_sign();
    return sign;
  }

  std::optional<Inertia> LinearSolver::inertia_by_mumps() const
  {
    const std::unique_ptr<LinearSolverMethod> mumps =
      make_method(LinearSolverType::mumps);
    if (mumps->analyse(condensation.matrix(), condensation.joints()) !=
          FactorizationOutcome::done ||
        mumps->factorize(condensation.matrix()) != FactorizationOutcome::done)
      return std::nullopt;
    return mumps->inertia();
  }

  bool LinearSolver::solve(std::vector<double> &values)
  {
    Assert(current != nullptr, dealii::ExcMessage("Nothing was factorized."));
#ifdef DEBUG
    const std::vector<double> right_side = values;
#endif
    condensation.reduce(values, joint_values);
    failure_reason = current->solve(joint_values.data());
    if (!failure_reason.empty())
      {
        // Non-finite values make the next residual reveal the failure.
        std::fill(values.begin(),
                  values.end(),
                  std::numeric_limits<double>::quiet_NaN());
        return false;
      }
    condensation.expand(joint_values, values);
#ifdef DEBUG
    // Far above round-off, also with multipliers; far below the error of a
    // wrong factor.
    constexpr double largest_error = 1e-3;
    const bool       is_finite =
      std::all_of(right_side.begin(), right_side.end(), [](const double value) {
        return std::isfinite(value);
      });
    if (current->n_iterations() == 0 && matrix.has_entries() &&
        matrix.pattern().unknowns().layout.largest(is_finite ? 0. : 1.) == 0)
      {
        const double error =
          backward_error(matrix, values, right_side, symmetry);
        Assert(error < largest_error,
               dealii::ExcMessage("The solution leaves a backward error of " +
                                  std::to_string(error)));
      }
#endif
    return true;
  }

  unsigned long LinearSolver::n_iterations() const
  {
    unsigned long n = 0;
    for (const auto &[type, analysed] : methods)
      n += analysed.method->n_iterations();
    return n;
  }

  void LinearSolver::forget_pivots()
  {
    for (const auto &[type, analysed] : methods)
      analysed.method->forget_pivots();
  }

  std::size_t LinearSolver::memory() const
  {
    std::size_t sum = condensation.memory();
    for (const auto &[type, analysed] : methods)
      sum += analysed.method->memory();
    return sum;
  }
} // namespace auxfem
