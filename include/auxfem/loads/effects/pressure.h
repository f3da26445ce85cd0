#ifndef auxfem_loads_effects_pressure_h
#define auxfem_loads_effects_pressure_h

#include <auxfem/equations/effect.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/model/numbering.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /** A pressure on one side of struts in the plane. */
  struct PressureLoad
  {
    /** An element and the pressure on it over that of the load. */
    struct Element
    {
      unsigned int number; ///< in the numbering
      /** Integrals of N_a N_b' times the distribution over the element, a
       * row by node a. */
      std::vector<double> integrals;
      /** Positions of the nodes at rest: x, y (m). */
      std::vector<double> positions;
    };
    TimeFunction         history; ///< force per current length (N/m)
    EnergyEntry          work;
    std::vector<Element> elements;
  };

  /**
   * Makes the effect of pressures. On the current length ds the force p n ds
   * acts, n to the left of the axis x: with n ds = e_z x dx, nodes get the
   * force p sum_b (int N_a N_b' ds) e_z x x_b, linear in their positions.
   * Closed or held all around, the pressure has the potential -p times the
   * enclosed area; otherwise the tangent is unsymmetric.
   * @param large_rotation false: the force stays that at rest
   * @param raised_from_zero as for make_applied_loads()
   */
  std::unique_ptr<Effect> make_pressures(const DofNumbering &numbering,
                                         bool                large_rotation,
                                         bool                raised_from_zero,
                                         std::vector<PressureLoad> loads);
} // namespace auxfem

#endif
