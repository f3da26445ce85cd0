#ifndef auxfem_loads_effects_applied_loads_h
#define auxfem_loads_effects_applied_loads_h

#include <auxfem/equations/effect.h>
#include <auxfem/loads/time_function.h>
#include <auxfem/model/numbering.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /** A fixed distribution over local unknowns times a function of time. */
  struct AppliedLoad
  {
    struct Weight
    {
      int    unknown;
      double weight;
    };
    TimeFunction        time_history;
    EnergyEntry         work; ///< ledger entry of its work; may be shared
    std::vector<Weight> weights;
  };

  /**
   * Makes the effect of dead loads: joint forces, line loads and gravity.
   * @param raised_from_zero whether the first step ramps the loads up from zero
   *   (statics from rest) even if their value at t = 0 is not zero
   */
  std::unique_ptr<Effect>
  make_applied_loads(const DofNumbering             &numbering,
                     bool                            raised_from_zero,
                     const std::vector<AppliedLoad> &loads);
} // namespace auxfem

#endif
