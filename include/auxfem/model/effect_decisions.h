#ifndef auxfem_model_effect_decisions_h
#define auxfem_model_effect_decisions_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/run_plan.h>

namespace auxfem
{
  /** `0.52 %`, `1.8e-06`. */
  std::string part_text(double part);

  /**
   * Settles every `auto` of the effects of @p plan from what the scene contains
   * and from how much of the answer that is: an effect below
   * `Effects/Tolerance` is left out if that saves time.
   * @param lattice of the scene
   */
  SimulatedEffects decide_effects(const RunPlan &plan, const Lattice &lattice);
} // namespace auxfem

#endif
