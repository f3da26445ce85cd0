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
    EnergyEntry         work; ///< keeps its work; loads may share it
    std::vector<Weight> weights;
  };

  /**
   * Dead loads. Joint forces, line loads and gravity all take this form.
   * @param raised_from_zero the first step raises the loads from nothing, even
   *   if they have a value at t = 0 (statics from rest); else they act from the
   *   start.
   */
  std::unique_ptr<Effect>
  make_applied_loads(const DofNumbering             &numbering,
                     bool                            raised_from_zero,
                     const std::vector<AppliedLoad> &loads);
} // namespace auxfem

#endif
