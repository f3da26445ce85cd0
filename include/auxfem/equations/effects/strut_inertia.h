#ifndef auxfem_equations_effects_strut_inertia_h
#define auxfem_equations_effects_strut_inertia_h

#include <auxfem/elements/beam_shape.h>
#include <auxfem/elements/section.h>
#include <auxfem/equations/effect.h>

namespace auxfem
{
  /** Which inertia of struts is simulated. */
  struct InertiaModel
  {
    bool large_rotation = true;
    bool rotary_inertia = true;
    bool damping        = false; ///< mass-proportional
  };

  /** What mass-proportional damping of struts takes from the motion. */
  EnergyEntry mass_damping_entry();

  /**
   * Inertia of the struts, with mass-proportional damping where a section has
   * it.
   */
  std::unique_ptr<Effect>
  make_strut_inertia(const Lattice              &lattice,
                     const DofNumbering         &numbering,
                     const std::vector<Section> &sections,
                     const InertiaModel         &model);

  /** The same for lattices in space. */
  std::unique_ptr<Effect>
  make_space_strut_inertia(const Lattice              &lattice,
                           const DofNumbering         &numbering,
                           const std::vector<Section> &sections,
                           const InertiaModel         &model);
} // namespace auxfem

#endif
