#ifndef auxfem_equations_effects_rigid_part_inertia_h
#define auxfem_equations_effects_rigid_part_inertia_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/rigid_bodies.h>

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
    void register_blocks(TangentPattern &pattern) override;
    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override;
    void add_tangent(const Evaluation     &evaluation,
                     const EffectResults  *results,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void register_in(StateLayout &layout) override;
    void account(const Evaluation    &step,
                 const EffectResults *results,
                 EnergyAccount       &account) const override;

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
    std::size_t       first_block   = 0;
    unsigned int      kinetic_entry = 0, numerical_entry = 0;
  };
} // namespace auxfem

#endif
