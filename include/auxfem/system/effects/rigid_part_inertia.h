#ifndef auxfem_system_effects_rigid_part_inertia_h
#define auxfem_system_effects_rigid_part_inertia_h

#include <auxfem/system/effect.h>
#include <auxfem/system/rigid_bodies.h>

namespace auxfem
{
  /**
   * Inertia of rigid parts in natural coordinates: constant mass matrices on
   * the unknowns of their bases.
   */
  class RigidPartInertia : public Effect
  {
  public:
    /** @param bodies of which those with a rotation of their own are left out. */
    explicit RigidPartInertia(RigidBodies bodies);

    bool is_linear() const override;
    void register_blocks(TangentMatrix &matrix) override;
    void add_residual(const Step &step, double *residual) override;
    void add_tangent(const Step           &step,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void add_energies(const State &state, Energies &energies) const override;

  private:
    /** Calls @p action for all bodies in natural coordinates, in order. */
    template <class Action>
    void for_each(const Action &action) const
    {
      for (const NaturalBody<2> &body : bodies.in_plane)
        action(body);
      for (const NaturalBody<3> &body : bodies.bars)
        action(body);
    }

    const RigidBodies bodies;
    std::size_t       first_block = 0;
  };
} // namespace auxfem

#endif
