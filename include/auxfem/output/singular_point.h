#ifndef auxfem_output_singular_point_h
#define auxfem_output_singular_point_h

#include <auxfem/algebra/vector.h>

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
    /** Negative eigenvalues of the stiffness before and after it on the path;
     * nothing where they are not known. */
    std::optional<unsigned long> n_negative_before, n_negative_after;
    /** Of the stiffness there, of all local unknowns; its largest entry is
     * positive. */
    Vector null_vector;

    /** How many directions become singular at once. */
    unsigned long multiplicity() const
    {
      if (!n_negative_before || !n_negative_after)
        return 1;
      return *n_negative_before < *n_negative_after
        ? *n_negative_after - *n_negative_before
        : *n_negative_before - *n_negative_after;
    }
  };
} // namespace auxfem

#endif
