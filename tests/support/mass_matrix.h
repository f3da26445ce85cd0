#ifndef auxfem_tests_support_mass_matrix_h
#define auxfem_tests_support_mass_matrix_h

#include <auxfem/equations/equations.h>

#include <memory>

namespace auxfem
{
  namespace testing_support
  {
    /** The mass matrix of @p equations at @p state. */
    inline std::unique_ptr<TangentMatrix>
    mass_matrix(const Equations &equations, const State &state)
    {
      State             now     = state;
      EvaluationResults results = equations.make_results();
      const Evaluation  instant = Evaluation::consistent_rates(state, now);
      equations.residual(instant, results);
      auto matrix = std::make_unique<TangentMatrix>(equations.pattern());
      equations.tangent(instant, results, {0, 0, 1}, *matrix);
      return matrix;
    }
  } // namespace testing_support
} // namespace auxfem

#endif
