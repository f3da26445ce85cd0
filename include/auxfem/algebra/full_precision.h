#ifndef auxfem_algebra_full_precision_h
#define auxfem_algebra_full_precision_h

#include <limits>

namespace auxfem
{
  /** Numbers below have fewer digits than others, or what is subtracted from
   * them has: forces of a load that begins or ends as a Gaussian, say. */
  constexpr double least_of_full_precision =
    std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
} // namespace auxfem

#endif
