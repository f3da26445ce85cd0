#ifndef auxfem_equations_solution_h
#define auxfem_equations_solution_h

#include <auxfem/equations/evaluation.h>

namespace auxfem
{
  /** An accepted state with the results of its evaluation. */
  struct Solution
  {
    State             state;
    EvaluationResults results;
  };
} // namespace auxfem

#endif
