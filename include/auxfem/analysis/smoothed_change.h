#ifndef auxfem_analysis_smoothed_change_h
#define auxfem_analysis_smoothed_change_h

#include <auxfem/algebra/vector.h>

#include <deque>
#include <optional>

namespace auxfem
{
  /**
   * Changes of a vector in steps of equal length, as means of the last three
   * with the weights 1/4, 1/2, 1/4. Of an oscillation that turns by an angle z
   * in a step cos^2(z/2) is left: nearly all of what steps follow, nearly
   * nothing of what changes sign from step to step.
   */
  class SmoothedChange
  {
  public:
    /** The mean that ends with @p change in a step of the length @p dt (s);
     * nothing if not all steps of it were as long. */
    std::optional<Vector> with(const Vector &change, double dt) const;

    /** The next step was accepted. */
    void add(const Vector &change, double dt);

    /** Begins anew. */
    void forget();

  private:
    std::deque<Vector> before; ///< the oldest first
    double             length = 0;
  };
} // namespace auxfem

#endif
