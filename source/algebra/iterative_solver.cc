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

      FactorizationOutcome analyse(const SparseMatrix & /*matrix*/,
                                   const Unknowns &unknowns) override
      {
        n_multipliers = unknowns.n_of(UnknownKind::multiplier);
        Assert(n_multipliers == 0 || unknowns.layout.n_ranks() == 1,
               dealii::ExcMessage("Multipliers at boundaries between ranks "
                                  "would stay in the iteration."));
        n_before    = n_iterations();
        layout      = &unknowns.layout;
        elimination = std::make_unique<JointElimination>(unknowns);
        krylov      = load_krylov_solver(parameters);
        known_pattern.reset();
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
        const bool is_new = known_pattern != elimination->version();
        known_pattern.reset();
        if (!krylov->factorize(elimination->matrix(),
                               elimination->rows(),
                               is_new,
                               may_be_definite()))
          return FactorizationOutcome::singular;
        known_pattern = elimination->version();
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
        if (!n_negative_eliminated || *n_negative_eliminated < 0)
          return std::nullopt;
        if (*n_negative_eliminated > 0 || nothing_is_left())
          return *n_negative_eliminated;
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

      /** Negative pivots of all that is eliminated beyond one a multiplier;
       * nothing if @p matrix is not symmetric. */
      std::optional<long> count_negative(const SparseMatrix &matrix) const
      {
        const double negative      = elimination->n_negative(),
                     n_unsymmetric = matrix.is_symmetric ? 0 : 1;
        const std::vector<double> sums =
          layout->sum(std::vector<double>{negative, n_unsymmetric});
        return sums[1] == 0
          ? std::optional(std::lround(sums[0]) - n_multipliers)
          : std::nullopt;
      }

      /** Whether all that is eliminated allows conjugate gradients. */
      bool may_be_definite() const
      {
        return n_negative_eliminated && *n_negative_eliminated <= 0;
      }

      const SolverParameters            parameters;
      const UnknownLayout              *layout = nullptr;
      std::unique_ptr<JointElimination> elimination;
      std::unique_ptr<KrylovSolver>     krylov;
      /** Version of the elimination that the preconditioner was last made of;
       * none if it has failed. */
      std::optional<unsigned int> known_pattern;
      long                        n_multipliers = 0;
      std::optional<long> n_negative_eliminated; ///< see count_negative()
      unsigned long       n_before = 0;
      std::vector<double> left; ///< right-hand side of S, then its solution
    };
  } // namespace



  std::unique_ptr<LinearSolverMethod>
  make_iterative_solver(const SolverParameters &parameters)
  {
    return std::make_unique<IterativeSolver>(parameters);
  }
} // namespace auxfem
