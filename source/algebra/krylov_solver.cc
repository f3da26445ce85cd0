#include <auxfem/algebra/joint_elimination.h>
#include <auxfem/algebra/krylov_solver.h>
#include <auxfem/algebra/linear_solver_method.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>
#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

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
        Assert(unknowns.n_of_kind(UnknownKind::multiplier) == 0,
               dealii::ExcMessage("Multipliers require a direct solver."));
        n_before       = n_iterations();
        layout         = &unknowns.layout;
        elimination    = std::make_unique<JointElimination>(matrix, unknowns);
        krylov         = make_krylov_solver(parameters);
        is_new_pattern = true;
        return FactorizationOutcome::done;
      }

      FactorizationOutcome factorize(const SparseMatrix &matrix) override
      {
        const bool has_nonfinite =
          std::any_of(matrix.entries.begin(),
                      matrix.entries.end(),
                      [](const double entry) { return !std::isfinite(entry); });
        if (layout->largest(has_nonfinite ? 1. : 0.) > 0)
          return FactorizationOutcome::not_finite;
        if (!elimination->factorize(matrix))
          return FactorizationOutcome::singular;
        n_negative_eliminated = count_negative(matrix);
        if (is_fully_eliminated())
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
        joint_values.resize(elimination->rows().layout().n_owned());
        elimination->reduce(x, joint_values.data());
        std::string failure;
        if (!is_fully_eliminated())
          failure = krylov->solve(joint_values.data(), joint_values.data());
        elimination->expand(joint_values.data(), x);
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
        if (n_negative_eliminated != 0 || is_fully_eliminated())
          return n_negative_eliminated;
        return krylov->n_negative();
      }

      std::optional<int> determinant_sign() const override
      {
        return std::nullopt;
      }

    private:
      bool is_fully_eliminated() const
      {
        return elimination->rows().layout().n_global() == 0;
      }

      /**
       * Number of eliminated negative eigenvalues over all ranks; none if @p
       * matrix is unsymmetric. If it is zero, conjugate gradients may solve the
       * rest.
       */
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
      /** Whether the preconditioner for the pattern is still to be built. */
      bool                         is_new_pattern = true;
      std::optional<unsigned long> n_negative_eliminated;
      unsigned long                n_before = 0;
      std::vector<double>
        joint_values; ///< right-hand side of S, then its solution
    };
  } // namespace



  std::unique_ptr<LinearSolverMethod>
  make_iterative_solver(const SolverParameters &parameters)
  {
    return std::make_unique<IterativeSolver>(parameters);
  }

  namespace
  {
    using OwnedVector = dealii::LinearAlgebra::distributed::Vector<double>;

    /**
     * A TangentMatrix as an operator of deal.II, with identity columns for
     * prescribed unknowns.
     */
    class FreeOperator
    {
    public:
      explicit FreeOperator(const TangentMatrix &matrix)
        : matrix(matrix)
        , unknowns(matrix.pattern().unknowns())
        , local(unknowns.layout.n_local())
        , owned(unknowns.layout.n_owned())
      {}

      void vmult(OwnedVector &image, const OwnedVector &x) const
      {
        for (unsigned int i = 0; i < owned.size(); ++i)
          local[i] = is_prescribed(i) ? 0. : x.local_element(i);
        unknowns.layout.update_ghosts(local.data());
        matrix.multiply(local.data(), owned.data());
        for (unsigned int i = 0; i < owned.size(); ++i)
          image.local_element(i) =
            is_prescribed(i) ? x.local_element(i) : owned[i];
      }

    private:
      bool is_prescribed(const unsigned int i) const
      {
        return unknowns.kinds[i] == UnknownKind::prescribed;
      }

      const TangentMatrix        &matrix;
      const Unknowns             &unknowns;
      mutable std::vector<double> local, owned;
    };

    OwnedVector make_vector(const UnknownLayout &layout)
    {
      const int        begin = layout.first_of(layout.rank());
      dealii::IndexSet range(layout.n_global());
      range.add_range(begin, begin + layout.n_owned());
      return OwnedVector(range, layout.communicator());
    }
  } // namespace

  bool solve_by_conjugate_gradients(const TangentMatrix &matrix,
                                    std::vector<double> &values)
  {
    // A mass matrix needs some ten iterations; the error then is negligible
    // beside that of the first step.
    constexpr double       tolerance          = 1e-13;
    constexpr unsigned int maximum_iterations = 1000;
    const Unknowns        &unknowns           = matrix.pattern().unknowns();
    const UnknownLayout   &layout             = unknowns.layout;

    // deal.II would raise an internal error for non-finite numbers.
    const std::vector<double> diagonal = matrix.diagonal();
    bool                      is_valid = true;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      is_valid = is_valid && std::isfinite(values[i]) &&
        std::isfinite(diagonal[i]) && diagonal[i] > 0;
    if (layout.largest(is_valid ? 0. : 1.) > 0)
      return false;
    OwnedVector b = make_vector(layout), x = b;
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      b.local_element(i) = values[i];
    const double size = b.l2_norm();

    // Free rows contain columns of prescribed unknowns: they move to the
    // right-hand side, which makes the operator symmetric.
    std::vector<double> prescribed(layout.n_local(), 0.),
      image(layout.n_owned());
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      if (unknowns.kinds[i] == UnknownKind::prescribed)
        prescribed[i] = values[i];
    layout.update_ghosts(prescribed.data());
    matrix.multiply(prescribed.data(), image.data());
    OwnedVector inverse(b);
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      {
        if (unknowns.kinds[i] == UnknownKind::prescribed)
          x.local_element(i) = values[i];
        else
          b.local_element(i) -= image[i];
        inverse.local_element(i) = 1 / diagonal[i];
      }

    const FreeOperator                  free(matrix);
    dealii::DiagonalMatrix<OwnedVector> preconditioner;
    preconditioner.reinit(inverse);
    dealii::SolverControl control(maximum_iterations,
                                  tolerance * size,
                                  /*log_history=*/false,
                                  /*log_result=*/false);
    try
      {
        dealii::SolverCG<OwnedVector>(control).solve(free,
                                                     x,
                                                     b,
                                                     preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        // Round-off may make the residual miss the tolerance slightly.
        OwnedVector residual(b);
        free.vmult(residual, x);
        residual -= b;
        if (!(residual.l2_norm() <= 10 * tolerance * size))
          return false;
      }
    for (unsigned int i = 0; i < layout.n_owned(); ++i)
      values[i] = x.local_element(i);
    layout.update_ghosts(values.data());
    return true;
  }

  namespace
  {
    using DistributedVector =
      dealii::LinearAlgebra::distributed::Vector<double>;

    /** Distributed vector of the ranks' rows, in order of ranks. */
    DistributedVector make_vector(const OperatorEquations &equations)
    {
      namespace MPI                = dealii::Utilities::MPI;
      const dealii::IndexSet owned = MPI::create_ascending_partitioning(
        equations.communicator,
        equations.n_owned)[MPI::this_mpi_process(equations.communicator)];
      return DistributedVector(owned, equations.communicator);
    }

    struct EquationsOperator
    {
      const OperatorEquations &equations;

      void vmult(DistributedVector &y, const DistributedVector &x) const
      {
        equations.multiply(x.begin(), y.begin());
      }
    };

    struct Preconditioner
    {
      const OperatorEquations &equations;

      void vmult(DistributedVector &y, const DistributedVector &x) const
      {
        y = x;
        if (!equations.precondition(y.begin()))
          throw dealii::SolverControl::NoConvergence(0, 0.);
      }
    };
  } // namespace

  std::string solve_by_gmres(const OperatorEquations   &equations,
                             const std::vector<double> &b,
                             const double               tolerance,
                             std::vector<double>       &x)
  {
    constexpr unsigned int most_iterations = 400, n_directions = 120;
    DistributedVector right_side = make_vector(equations), solution(right_side),
                      preconditioned(right_side);
    std::copy(b.begin(), b.end(), right_side.begin());
    std::copy(x.begin(), x.end(), solution.begin());
    const EquationsOperator matrix{equations};
    const Preconditioner    preconditioner{equations};
    try
      {
        preconditioner.vmult(preconditioned, right_side);
        dealii::SolverControl                  control(most_iterations,
                                      tolerance * preconditioned.l2_norm());
        dealii::SolverGMRES<DistributedVector> solver(
          control,
          dealii::SolverGMRES<DistributedVector>::AdditionalData(n_directions +
                                                                 2));
        solver.solve(matrix, solution, right_side, preconditioner);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        return "GMRES has not converged in " + std::to_string(most_iterations) +
          " iterations";
      }
    std::copy(solution.begin(), solution.end(), x.begin());
    return "";
  }
} // namespace auxfem
