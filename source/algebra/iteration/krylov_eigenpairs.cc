#include <auxfem/algebra/eigen_solver.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziTpetraAdapter.hpp>

#include "tpetra_types.h"

namespace auxfem
{
  namespace
  {
    using Teuchos::RCP;
    using Teuchos::rcp;
    using AnasaziProblem =
      Anasazi::BasicEigenproblem<double, TpetraVectors, TpetraOperator>;
    using KrylovSchur =
      Anasazi::BlockKrylovSchurSolMgr<double, TpetraVectors, TpetraOperator>;

    /**
     * Block size of the iteration: two vectors resolve pairs of equal
     * eigenvalues.
     */
    unsigned int size_of_block(const unsigned int n_finite)
    {
      return n_finite < 8 ? 1 : 2;
    }

    /** A function of one vector as an operator. */
    class FunctionOperator : public TpetraOperator
    {
    public:
      using Function = std::function<void(const double *x, double *y)>;

      FunctionOperator(const RCP<const TpetraMap> &map, Function function)
        : map(map)
        , function(std::move(function))
      {}

      RCP<const TpetraMap> getDomainMap() const override
      {
        return map;
      }

      RCP<const TpetraMap> getRangeMap() const override
      {
        return map;
      }

      void apply(const TpetraVectors &x,
                 TpetraVectors       &y,
                 Teuchos::ETransp /*mode*/,
                 double alpha,
                 double beta) const override
      {
        std::vector<double> image(map->getNodeNumElements());
        for (std::size_t j = 0; j < x.getNumVectors(); ++j)
          {
            const auto from = x.getData(j);
            function(from.get(), image.data());
            const auto to = y.getDataNonConst(j);
            for (std::size_t i = 0; i < image.size(); ++i)
              to[i] = (beta == 0 ? 0. : beta * to[i]) + alpha * image[i];
          }
      }

    private:
      const RCP<const TpetraMap> map;
      const Function             function;
    };

    /** Signals a failed solution through Anasazi. */
    struct SolutionFailed : public std::exception
    {};

    /** Pseudo-random numbers in [-1, 1], independent of the number of ranks. */
    void fill(const UnknownLayout &layout, double *values)
    {
      for (unsigned int i = 0; i < layout.n_owned(); ++i)
        {
          const double phase = 12.9898 * (layout.global(i) + 1);
          values[i]          = std::sin(43758.5453 * std::sin(phase));
        }
    }

    Teuchos::ParameterList parameters_for(const ShiftedEigenproblem &problem,
                                          const unsigned int         n)
    {
      const unsigned int block_size = size_of_block(problem.n_finite);
      const unsigned int n_basis =
        std::min(n_krylov_directions(n), problem.n_finite);
      Teuchos::ParameterList parameters;
      parameters.set("Which", problem.only_above ? "LR" : "LM");
      parameters.set("Block Size", int(block_size));
      parameters.set("Num Blocks", int(n_basis / block_size));
      parameters.set("Maximum Restarts", 100);
      // The norm of the stiffness keeps fewer digits than that of the mass.
      parameters.set("Convergence Tolerance",
                     problem.multiply_definite ? 1e-7 : 1e-12);
      parameters.set("Verbosity", int(Anasazi::Errors));
      return parameters;
    }
  } // namespace

  Eigenpairs krylov_eigenpairs(const ShiftedEigenproblem &problem,
                               const unsigned int         n)
  {
    Eigenpairs found;
    const auto map     = make_map(problem.layout, problem.layout.n_owned());
    const auto product = rcp(new FunctionOperator(map,
                                                  problem.multiply_definite
                                                    ? problem.multiply_definite
                                                    : problem.multiply_mass));
    // (K - sigma M)^-1 M
    const auto image = [&problem](const double *x, double *y) {
      problem.multiply_mass(x, y);
      if (!problem.solve(y))
        throw SolutionFailed();
    };
    const auto shifted_inverse = rcp(new FunctionOperator(map, image));
    try
      {
        const unsigned int n_together = size_of_block(problem.n_finite);
        // The start vector must not contain motions without mass.
        const auto          start = rcp(new TpetraVectors(map, n_together));
        std::vector<double> random(problem.layout.n_owned());
        fill(problem.layout, random.data());
        for (unsigned int j = 0; j < n_together; ++j)
          {
            std::vector<double> next(random.size());
            image(random.data(), next.data());
            std::copy(next.begin(),
                      next.end(),
                      start->getDataNonConst(j).begin());
            for (std::size_t i = 0; i < random.size(); ++i)
              random[i] *= std::cos(problem.layout.global(i));
          }
        const auto eigenproblem =
          rcp(new AnasaziProblem(shifted_inverse, product, start));
        eigenproblem->setHermitian(true);
        eigenproblem->setNEV(n);
        if (!eigenproblem->setProblem())
          {
            found.failure_reason = "the eigenproblem is not complete";
            return found;
          }
        auto        parameters = parameters_for(problem, n);
        KrylovSchur method(eigenproblem, parameters);
        if (method.solve() != Anasazi::Converged)
          found.failure_reason = "the Krylov-Schur method has not converged";
        const auto &solution = eigenproblem->getSolution();
        for (int j = 0; j < solution.numVecs; ++j)
          {
            // One more application removes the round-off in motions without
            // mass.
            std::vector<double> vector(random.size());
            image(solution.Evecs->getData(j).get(), vector.data());
            found.pairs.push_back(
              {problem.shift + 1 / solution.Evals[j].realpart,
               std::move(vector)});
          }
      }
    catch (const SolutionFailed &)
      {
        found.failure_reason = "a linear solution failed";
      }
    // Anasazi throws std::logic_error or std::runtime_error on breakdown.
    catch (const std::exception &error)
      {
        found.failure_reason =
          std::string("the Krylov-Schur method broke down: ") + error.what();
      }
    return found;
  }
} // namespace auxfem
