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
   * Internal forces of all struts of @p numbering, one effect per group of
   * elements.
   * @param model simulated effects and sections
   * @param high_frequency_damping as ImplicitScheme
   */
  std::vector<std::unique_ptr<StrutForces>>
  make_strut_forces(const LatticeModel &model,
                    const Lattice      &lattice,
                    const DofNumbering &numbering,
                    double              high_frequency_damping);

  /** Inertia of the same struts; empty if not simulated. */
  std::vector<std::unique_ptr<Effect>>
  make_strut_inertia(const LatticeModel &model,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);

  /**
   * Inertia of point masses and of rigid parts with a rotation. Throws
   * InputError for rotary inertia on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>> make_masses(const LatticeModel &model);

  /** Linear rotational springs of this rank; nullptr if the scene has no
   * springs. */
  std::unique_ptr<Effect> make_rotational_springs(const LatticeModel &model);

  /** Rotational springs by laws of connectors, one effect per `Joints/NAME`. */
  std::vector<std::unique_ptr<Effect>>
  make_rotational_laws(const LatticeModel &model);

  /**
   * Restrains the spin of bars between ball hinges without inertia; nullptr if
   * there are none.
   */
  std::unique_ptr<Effect> make_spin_holds(const LatticeModel &model);

  /** Revolute hinges; nullptr if the scene has none. */
  std::unique_ptr<Constraints> make_revolute_hinges(const LatticeModel &model);

  /** Linear relations; nullptr if the scene has no constraints. */
  std::unique_ptr<Constraints> make_relation_forces(const LatticeModel &model);

  /**
   * Joint loads, line loads and weight: dead loads and follower loads. Throws
   * InputError for a moment on a joint without rotation.
   */
  std::vector<std::unique_ptr<Effect>> make_loads(const LatticeModel &model);

  /** Only the line loads and weight of the struts of @p lattice. */
  std::vector<std::unique_ptr<Effect>>
  make_strut_loads(const LatticeModel &model,
                   const Lattice      &lattice,
                   const DofNumbering &numbering);
} // namespace auxfem

#endif
