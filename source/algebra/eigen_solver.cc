#include <auxfem/algebra/eigen_solver_dense.h>
#include <auxfem/algebra/krylov_eigenpairs.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    void scale(const ShiftedEigenproblem &problem, std::vector<double> &vector)
    {
      std::vector<double> weighted(vector.size());
      (problem.multiply_definite
         ? problem.multiply_definite
         : problem.multiply_mass)(vector.data(), weighted.data());
      double square = 0;
      for (std::size_t i = 0; i < weighted.size(); ++i)
        square += vector[i] * weighted[i];
      square = problem.layout.sum(square);
      for (double &value : vector)
        value /= std::sqrt(square);
    }
  } // namespace

  Eigenpairs nearest_eigenpairs(const ShiftedEigenproblem &problem,
                                const unsigned int         n)
  {
    /**
     * Size up to which eigenproblems with many equal eigenvalues, those
     * of mechanisms, are solved by dense matrices.
     * @tuned [unknowns] measured: these take some seconds
     */
    constexpr unsigned int most_dense = 1500;
    const bool are_few = problem.n_finite < 4 * n_krylov_directions(n);
    Eigenpairs found =
      are_few ? dense_eigenpairs(problem, n) : krylov_eigenpairs(problem, n);
    if (!are_few && !found.why.empty() &&
        problem.layout.n_global() <= most_dense)
      found = dense_eigenpairs(problem, n);
    std::sort(found.pairs.begin(),
              found.pairs.end(),
              [](const Eigenpair &one, const Eigenpair &other) {
                return one.value < other.value;
              });
    for (Eigenpair &pair : found.pairs)
      scale(problem, pair.vector);
    return found;
  }
} // namespace auxfem
