#ifndef auxfem_model_effect_decisions_h
#define auxfem_model_effect_decisions_h

#include <auxfem/mesh/lattice.h>
#include <auxfem/scene/scene.h>
#include <auxfem/time/records.h>

#include <optional>

namespace auxfem
{
  /** How much of the answer an effect is, found before the run. */
  struct EffectMeasure
  {
    /** Relative change expected if the effect is left out, at most 1. */
    double change;
    /** What @p change is a part of, for people: `the bending compliance`. */
    std::string of;
  };

  /** One line of "what is simulated": an effect, whether it is on, and why. */
  struct EffectDecision
  {
    std::string name;
    bool        on;
    std::string reason;
    /** None where the scene has nothing of the effect, or there is no measure.
     */
    std::optional<EffectMeasure> measure = {};

    /** Whether the effect changes the answer by more than @p tolerance; without
     * a measure whether it is on. */
    bool is_called_for(const double tolerance) const
    {
      return measure ? measure->change > tolerance : on;
    }
  };

  /** `0.52 %`, `1.8e-06`. */
  std::string part_text(double part);

  /** Which physics a run simulates. */
  struct SimulatedEffects
  {
    bool large_rotation, shear_flexibility, inertia, rotary_inertia,
      connector_viscosity, strut_damping, gravity, hinges, contact;
    /** Whether the program has decided on small displacements, and ends the run
     * where they are wrong (analysis/small_displacement_limit.h). */
    bool small_displacements_are_limited = false;

    /** The same in words, in the order of the `Effects` subsection. */
    std::vector<EffectDecision> decisions;
  };

  /**
   * Settles every `auto` from what the scene contains and from how much of the
   * answer that is: an effect below `Effects/Tolerance` is left out if that
   * saves time.
   * @param lattice of the scene
   */
  SimulatedEffects decide_effects(const Scene &scene, const Lattice &lattice);

  /** @name For runs that are resumed. */
  ///@{
  void           save(const EffectDecision &decision, Records &records);
  EffectDecision saved_decision(const std::string &effect,
                                const Records     &records);
  ///@}
} // namespace auxfem

#endif
