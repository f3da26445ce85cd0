#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/algebra/linear_solver_method.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    /** See make_iterative_solver(). */
    class IterativeSolver : public LinearSolverMethod
    {
    public:
      explicit IterativeSolver(const SolverParameters &parameters)
        : parameters(parameters)
      {}

      FactorizationOutcome analyse(const SparseMatrix &matrix,
                                   const Unknowns     &unknowns) override
      {
        Assert(unknowns.n_of(UnknownKind::multiplier) == 0,
               dealii::ExcMessage("Multipliers are left to direct solvers."));
        n_before       = n_iterations();
        layout         = &unknowns.layout;
        elimination    = std::make_unique<JointElimination>(matrix, unknowns);
        krylov         = make_krylov_solver(parameters);
        is_new_pattern = true;
        return FactorizationOutcome::done;
      }

      FactorizationOutcome factorize(const SparseMatrix &matrix) override
      {
        const bool has_wrong =
          std::any_of(matrix.entries.begin(),
                      matrix.entries.end(),
                      [](const double entry) { return !std::isfinite(entry); });
        if (layout->largest(has_wrong ? 1. : 0.) > 0)
          return FactorizationOutcome::not_finite;
        if (!elimination->factorize(matrix))
          return FactorizationOutcome::singular;
        n_negative_eliminated = count_negative(matrix);
        if (nothing_is_left())
          return FactorizationOutcome::done;
        if (!krylov->factorize(elimination->matrix(),
                               elimination->rows(),
                               is_new_pattern,
                               n_negative_eliminated == 0))
          return FactorizationOutcome::singular;
        is_new_pattern = false;
        return FactorizationOutcome::done;
      }

      std::string solve(double *x) override
      {
        left.resize(elimination->rows().layout().n_owned());
        elimination->reduce(x, left.data());
        std::string failure;
        if (!nothing_is_left())
          failure = krylov->solve(left.data(), left.data());
        elimination->expand(left.data(), x);
        return failure;
      }

      unsigned long n_iterations() const override
      {
        return krylov ? n_before + krylov->n_iterations() : 0;
      }

      std::size_t memory() const override
      {
        return elimination ? elimination->memory() : 0;
      }

      std::optional<Inertia> inertia() const override
      {
        return std::nullopt;
      }

      std::optional<unsigned long> n_negative_at_least() override
      {
        if (n_negative_eliminated != 0 || nothing_is_left())
          return n_negative_eliminated;
        return krylov->n_negative();
      }

      std::optional<int> determinant_sign() const override
      {
        return std::nullopt;
      }

    private:
      bool nothing_is_left() const
      {
        return elimination->rows().layout().n_global() == 0;
      }

      /** Negative eigenvalues of all that is eliminated; nothing if @p matrix is
       * not symmetric. Without any, conjugate gradients may serve the rest. */
      std::optional<unsigned long>
      count_negative(const SparseMatrix &matrix) const
      {
        const double negative      = elimination->n_negative(),
                     n_unsymmetric = matrix.is_symmetric ? 0 : 1;
        const std::vector<double> sums =
          layout->sum(std::vector<double>{negative, n_unsymmetric});
        return sums[1] == 0 ? std::optional<unsigned long>(std::lround(sums[0]))
                            : std::nullopt;
      }

      const SolverParameters            parameters;
      const UnknownLayout              *layout = nullptr;
      std::unique_ptr<JointElimination> elimination;
      std::unique_ptr<KrylovSolver>     krylov;
      /** Whether the preconditioner has not been made of the pattern yet. */
      bool                         is_new_pattern = true;
      std::optional<unsigned long> n_negative_eliminated;
      unsigned long                n_before = 0;
      std::vector<double> left; ///< right-hand side of S, then its solution
    };
  } // namespace



  std::unique_ptr<LinearSolverMethod>
  make_iterative_solver(const SolverParameters &parameters)
  {
    return std::make_unique<IterativeSolver>(parameters);
  }
} // namespace auxfem
