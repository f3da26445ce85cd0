#include <auxfem/algebra/krylov_solver.h>

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include <BelosBlockGmresSolMgr.hpp>
#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>

#include "tpetra_types.h"

namespace auxfem
{
  namespace
  {
    using Map    = TpetraMap;
    using Global = Map::global_ordinal_type;
    using LinearProblem =
      Belos::LinearProblem<double, TpetraVectors, TpetraOperator>;
    using Gradients =
      Belos::PseudoBlockCGSolMgr<double, TpetraVectors, TpetraOperator>;
    using Gmres =
      Belos::BlockGmresSolMgr<double, TpetraVectors, TpetraOperator>;
    using Teuchos::ParameterList;
    using Teuchos::RCP;
    using Teuchos::rcp;

    /** Restart length of GMRES. */
    constexpr unsigned int n_directions = 200;

    /**
     * Number of restarts when the true residual exceeds the estimate of the
     * method.
     */
    constexpr unsigned int n_refinements = 5;

    template <typename T, typename U>
    Teuchos::ArrayRCP<T> copied(const std::vector<U> &values)
    {
      Teuchos::ArrayRCP<T> copy(values.size());
      std::copy(values.begin(), values.end(), copy.begin());
      return copy;
    }

    double norm(const TpetraVectors &vector)
    {
      return vector.getVector(0)->norm2();
    }

    class BelosSolver : public KrylovSolver
    {
    public:
      explicit BelosSolver(const SolverParameters &parameters)
        : parameters(parameters)
      {}

      bool factorize(const SparseMatrix &entries,
                     const JointRows    &rows,
                     const bool          is_new_pattern,
                     const bool          may_be_definite) override
      {
        is_definite = may_be_definite;
        preconditioner.reset();
        n_negative_of_preconditioner.reset();
        if (is_new_pattern)
          make_matrix(entries);
        else
          replace_entries(entries.entries);
        bool is_made = true;
        try
          {
            if (parameters.preconditioner == "ilu")
              preconditioner = make_incomplete_factorization(matrix);
            else
              {
                const Multigrid multigrid =
                  make_multigrid(matrix, rows, entries.is_symmetric);
                preconditioner               = multigrid.cycle;
                n_negative_of_preconditioner = multigrid.n_negative;
              }
          }
        // Belos, Ifpack2 and MueLu throw std::logic_error or std::runtime_error
        // on breakdown.
        catch (const std::exception &)
          {
            is_made = false;
          }
        return entries.layout->largest(is_made ? 0. : 1.) == 0;
      }

      std::string solve(const double *g, double *z) override
      {
        const auto right_side = rcp(new TpetraVectors(row_map, 1)),
                   solution   = rcp(new TpetraVectors(row_map, 1));
        std::copy_n(g,
                    right_side->getLocalLength(),
                    right_side->getDataNonConst(0).begin());
        const double size = norm(*right_side);
        std::string  failure;
        if (!std::isfinite(size))
          failure = "the right-hand side is not finite";
        else if (size > 0)
          failure = iterate(right_side, solution, size);
        const auto values = solution->getData(0);
        std::copy(values.begin(), values.end(), z);
        return failure;
      }

      std::optional<unsigned long> n_negative() override
      {
        if (n_negative_of_preconditioner != 0)
          return n_negative_of_preconditioner;
        const bool has_converged = is_definite && solve_random_right_side();
        if (!is_definite)
          return 1;
        return has_converged ? std::optional(0ul) : std::nullopt;
      }

      unsigned long n_iterations() const override
      {
        return n_done;
      }

    private:
      void make_matrix(const SparseMatrix &entries)
      {
        row_map    = make_map(*entries.layout, entries.layout->n_owned());
        column_map = make_map(*entries.layout, entries.layout->n_local());
        matrix     = rcp(new TpetraMatrix(row_map,
                                      column_map,
                                      copied<std::size_t>(entries.first),
                                      copied<int>(entries.columns),
                                      copied<double>(entries.entries)));
        matrix->expertStaticFillComplete(row_map, row_map);
      }

      void replace_entries(const std::vector<double> &entries)
      {
        matrix->resumeFill();
        std::copy(entries.begin(),
                  entries.end(),
                  matrix->getLocalMatrixHost().values.data());
        matrix->fillComplete(row_map, row_map);
      }

      static RCP<ParameterList> settings(const unsigned int most,
                                         const double       tolerance)
      {
        const auto list = rcp(new ParameterList);
        list->set("Maximum Iterations", static_cast<int>(most));
        list->set("Convergence Tolerance", tolerance);
        return list;
      }

      /**
       * Returns whether conjugate gradients reach @p tolerance relative to the
       * right-hand side; sets is_definite to false at negative curvature.
       */
      bool run_gradients(const RCP<LinearProblem> &problem,
                         const unsigned int        most,
                         const double              tolerance)
      {
        const auto list = settings(most, tolerance);
        list->set("Residual Scaling", "Norm of RHS");
        Gradients gradients(problem, list);
        try
          {
            const bool has_converged = gradients.solve() == Belos::Converged;
            n_done += gradients.getNumIters();
            return has_converged;
          }
        // Belos::CGIterateFailure if the matrix is not positive definite.
        catch (const std::exception &)
          {
            is_definite = false;
            return false;
          }
      }

      /**
       * Solves for a random right-hand side, which excites all modes; returns
       * as run_gradients().
       */
      bool solve_random_right_side()
      {
        const auto right_side = rcp(new TpetraVectors(row_map, 1)),
                   solution   = rcp(new TpetraVectors(row_map, 1));
        {
          std::mt19937 generator(1 + row_map->getMinGlobalIndex());
          for (double &entry : right_side->getDataNonConst(0))
            entry = 2. * generator() / generator.max() - 1;
        }
        const auto problem =
          rcp(new LinearProblem(matrix, solution, right_side));
        problem->setLeftPrec(preconditioner);
        problem->setProblem();
        // Each mode has about a thousandth of the right-hand side of a million
        // unknowns.
        constexpr double tolerance = 1e-8;
        return run_gradients(problem, parameters.maximum_iterations, tolerance);
      }

      std::string iterate(const RCP<TpetraVectors> &right_side,
                          const RCP<TpetraVectors> &solution,
                          const double              size)
      {
        const auto problem =
          rcp(new LinearProblem(matrix, solution, right_side));
        if (is_definite)
          problem->setLeftPrec(preconditioner);
        else
          problem->setRightPrec(preconditioner);

        TpetraVectors residual(row_map, 1);
        double        error = size;
        unsigned int  n     = 0;
        for (unsigned int i = 0; i <= n_refinements; ++i)
          {
            problem->setProblem();
            const unsigned long before = n_done;
            run_method(problem, parameters.maximum_iterations - n);
            n += n_done - before;
            matrix->apply(*solution, residual);
            residual.update(1., *right_side, -1.);
            error = norm(residual);
            if (error <=
                std::max(parameters.tolerance * size, round_off(*solution)))
              return "";
            if (!std::isfinite(error) || n >= parameters.maximum_iterations)
              break;
          }
        return failure_message(error / size, n);
      }

      /** Iterates at most @p most times. */
      void run_method(const RCP<LinearProblem> &problem,
                      const unsigned int        most)
      {
        if (is_definite)
          {
            run_gradients(problem, most, parameters.tolerance);
            if (is_definite)
              return;
            problem->setLeftPrec(Teuchos::null);
            problem->setRightPrec(preconditioner);
            problem->setProblem();
          }
        const auto list = settings(most, parameters.tolerance);
        list->set("Implicit Residual Scaling", "Norm of RHS");
        list->set("Explicit Residual Scaling", "Norm of RHS");
        list->set("Num Blocks",
                  static_cast<int>(
                    std::min(n_directions, parameters.maximum_iterations)));
        list->set("Maximum Restarts", static_cast<int>(most));
        Gmres gmres(problem, list);
        gmres.solve();
        n_done += gmres.getNumIters();
      }

      /** Residual due to rounding of any solution. */
      double round_off(const TpetraVectors &solution) const
      {
        return std::numeric_limits<double>::epsilon() *
          matrix->getFrobeniusNorm() * norm(solution);
      }

      std::string failure_message(const double       relative_residual,
                                  const unsigned int n) const
      {
        std::ostringstream message;
        message << (is_definite ? "conjugate gradients" : "GMRES")
                << " reached a relative residual of " << relative_residual
                << " in " << n
                << " iterations (Solver/Tolerance = " << parameters.tolerance
                << ", Maximum iterations = " << parameters.maximum_iterations
                << ", Preconditioner = " << parameters.preconditioner
                << "; the direct solver, Type = auto, may serve better)";
        return message.str();
      }

      const SolverParameters parameters;
      /** Whether the matrix may be positive definite. */
      bool                is_definite = false;
      RCP<const Map>      row_map, column_map;
      RCP<TpetraMatrix>   matrix;
      RCP<TpetraOperator> preconditioner;
      /** Negative eigenvalues of the preconditioner, if known. */
      std::optional<unsigned long> n_negative_of_preconditioner;
      unsigned long                n_done = 0;
    };
  } // namespace



  Teuchos::RCP<const TpetraMap> make_map(const UnknownLayout &layout,
                                         const unsigned int   n)
  {
    std::vector<Global> globals(n);
    for (unsigned int i = 0; i < n; ++i)
      globals[i] = layout.global(i);
    return rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                       Teuchos::ArrayView<const Global>(globals),
                       0,
                       rcp(new Teuchos::MpiComm<int>(layout.communicator()))));
  }

  std::unique_ptr<KrylovSolver>
  make_krylov_solver(const SolverParameters &parameters)
  {
    return std::make_unique<BelosSolver>(parameters);
  }
} // namespace auxfem
