#ifndef auxfem_equations_constraints_h
#define auxfem_equations_constraints_h

#include <auxfem/equations/effect.h>

namespace auxfem
{
  /**
   * Constraints g = 0 (m) on the motion, with their Lagrange multipliers lambda
   * (N): forces G^T lambda, and the constraints themselves in the rows of the
   * multipliers. In an evaluation of rates with inertia these rows hold
   * d2g/dt2, which determines consistent accelerations.
   */
  class Constraints : public Effect
  {
  public:
    /**
     * dg/dt (m/s) of the velocities of @p state, into the multipliers' entries
     * of @p rates (n_local entries).
     */
    virtual void find_rates(const State &state, double *rates) const = 0;

    /** Length (m) whose round-off is in the constraints besides that of
     * displacements. */
    virtual double length() const
    {
      return 0;
    }
  };
} // namespace auxfem

#endif
