#ifndef auxfem_equations_make_effects_h
#define auxfem_equations_make_effects_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/lattice_model.h>

#include <memory>
#include <vector>

namespace auxfem
{
  class StrutForces;

  /**
   * Internal forces of all struts of @p numbering, one effect for each group of
   * its elements.
   * @param model what is simulated, and the sections
   * @param high_frequency_damping see ImplicitScheme
   */
  std::vector<std::unique_ptr<StrutForces>>
  make_strut_forces(const LatticeModel &model,
                    const Lattice      &lattice,
                    const DofNumbering &numbering,
                    double              high_frequency_damping);

  /** Inertia of the same struts; none if it is not simulated. */
  std::vector<std::unique_ptr<Effect>>
  make_strut_inertia(const LatticeModel &model,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);

  /**
   * The scene's point masses and their rotary inertia, and those of the rigid
   * parts that have a rotation of their own, as effects. Throws InputError for
   * rotary inertia on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>> make_masses(const LatticeModel &model);

  /** The rotational springs of this rank. nullptr if the scene has none. */
  std::unique_ptr<Effect> make_rotational_springs(const LatticeModel &model);

  /** Holds bars between ball hinges where inertia does not. nullptr if
   * there are none. */
  std::unique_ptr<Effect> make_spin_holds(const LatticeModel &model);

  /** The revolute hinges. nullptr if the scene has none. */
  std::unique_ptr<Constraints> make_revolute_hinges(const LatticeModel &model);

  /**
   * Joint loads, line loads and weight of struts, rigid parts and point masses
   * as effects: dead loads, and loads that follow their joints. Throws
   * InputError for a moment on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>> make_loads(const LatticeModel &model);

  /** Of these the line loads and the weight of the struts of @p lattice alone.
   */
  std::vector<std::unique_ptr<Effect>>
  make_strut_loads(const LatticeModel &model,
                   const Lattice      &lattice,
                   const DofNumbering &numbering);
} // namespace auxfem

#endif
