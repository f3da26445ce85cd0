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

    /** A place within a step. */
    struct Within
    {
      const Solution *from, *to; ///< ends of the step
      double          part;      ///< of the step that has gone by

      /** Linear between the ends. */
      double chord(const double at_from, const double at_to) const
      {
        return at_from + part * (at_to - at_from);
      }
    };

    /** Set where forces at an interpolated motion are far out of equilibrium:
     * those of this solution, energies included, are linear between the ends
     * of the step, and `results` do not serve. */
    std::optional<Within> forces_within = {};
  };
} // namespace auxfem

#endif
