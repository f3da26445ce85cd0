#ifndef auxfem_output_singular_point_h
#define auxfem_output_singular_point_h

#include <auxfem/time/state.h>

#include <optional>

namespace auxfem
{
  /** What makes a point of a path of equilibria singular. */
  struct SingularPoint
  {
    enum class Kind
    {
      limit,      ///< the load factor turns round
      bifurcation ///< another branch crosses
    };
    Kind kind;
    /** What is known of the stiffness before and after it on the path. */
    PathPosition before, after;
    /** Of the stiffness there, of all local unknowns; its largest entry is
     * positive. */
    Vector null_vector;
    /** PathStepper::part_of_loads(). */
    std::optional<double> part_of_loads = {};

    /** How many directions become singular at once; 1 where that is not known.
     */
    unsigned long multiplicity() const
    {
      if (!before.n_negative || !after.n_negative)
        return 1;
      return *before.n_negative < *after.n_negative
        ? *after.n_negative - *before.n_negative
        : *before.n_negative - *after.n_negative;
    }

    /** Whether the equilibria after it are less stable than those before. */
    bool destabilizes() const
    {
      if (before.n_negative && after.n_negative)
        return *after.n_negative > *before.n_negative;
      return before.determinant_sign == 1 && after.determinant_sign == -1;
    }
  };
} // namespace auxfem

#endif
