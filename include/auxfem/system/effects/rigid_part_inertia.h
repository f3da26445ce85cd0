#ifndef auxfem_system_effects_rigid_part_inertia_h
#define auxfem_system_effects_rigid_part_inertia_h

#include <auxfem/system/effect.h>
#include <auxfem/system/rigid_bodies.h>

namespace auxfem
{
  /** Inertia of rigid parts: constant mass matrices on the unknowns of their
   * bases. */
  class RigidPartInertia : public Effect
  {
  public:
    explicit RigidPartInertia(std::vector<RigidBody> bodies);

    bool is_linear() const override;
    void register_blocks(TangentMatrix &matrix) override;
    void add_residual(const Step &step, double *residual) override;
    void add_tangent(const Step           &step,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void add_energies(const State &state, Energies &energies) const override;

  private:
    const std::vector<RigidBody> bodies;
    std::size_t                  first_block = 0;
  };
} // namespace auxfem

#endif
