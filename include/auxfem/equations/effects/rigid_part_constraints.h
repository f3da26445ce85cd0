#ifndef auxfem_equations_effects_rigid_part_constraints_h
#define auxfem_equations_effects_rigid_part_constraints_h

#include <auxfem/equations/effects/rigid_part_group.h>

namespace auxfem
{
  /** The constraints that keep rigid parts rigid, of all kinds there are. */
  class RigidPartConstraints : public RigidPartGroup
  {
  public:
    /** @param gravity for the reported forces (m/s2), zero if it is left out. */
    RigidPartConstraints(const RigidBodies          &bodies,
                         const Lattice              &lattice,
                         const DofNumbering         &numbering,
                         bool                        large_rotation,
                         const dealii::Tensor<1, 3> &gravity);

    bool   is_linear() const override;
    void   register_blocks(TangentPattern &pattern) override;
    void   add_residual(const Evaluation &evaluation,
                        double           *residual,
                        EffectResults    *results) const override;
    void   add_tangent(const Evaluation     &evaluation,
                       const EffectResults  *results,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override;
    void   raise_forces(const Evaluation    &evaluation,
                        const EffectResults *results,
                        double              *forces) const override;
    void   find_rates(const State &state, double *rates) const override;
    double length() const override;

    unsigned int    n_reported() const override;
    unsigned int    part(unsigned int i) const override;
    SpaceVector     rotation(unsigned int i, const State &state) const override;
    PointMotion     motion(unsigned int            i,
                           const dealii::Point<3> &point,
                           const State            &state) const override;
    RigidPartReport report(unsigned int i, const State &state) const override;

  private:
    const Lattice                               &lattice;
    const DofNumbering                          &numbering;
    const bool                                   large_rotation;
    std::vector<std::unique_ptr<RigidPartGroup>> groups;
    /** Of each part reported on: its group, its number there. */
    std::vector<std::pair<const RigidPartGroup *, unsigned int>> reported;
  };
} // namespace auxfem

#endif
