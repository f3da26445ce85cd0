#ifndef auxfem_equations_effects_rotary_masses_h
#define auxfem_equations_effects_rotary_masses_h

#include <auxfem/elements/rotary_inertia.h>
#include <auxfem/equations/node_rotations.h>

namespace auxfem
{
  /**
   * Rotary inertia at nodes in space: Euler's equations with their gyroscopic
   * terms, which are left out if rotations are small.
   */
  class RotaryMasses : public Effect
  {
  public:
    RotaryMasses(const DofNumbering &numbering, bool large_rotation);

    /** Adds @p inertia (kg m2, global frame at rest) to one of DofNumbering::spatial_rotations(). */
    void add(unsigned int rotation, const SpaceTensor &inertia);

    /** Whether no mass was added. */
    bool empty() const;

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
    void raise_forces(const Evaluation    &evaluation,
                      const EffectResults *results,
                      double              *forces) const override;

  private:
    struct Mass
    {
      unsigned int rotation;
      SpaceTensor  inertia;
    };
    RotaryInertia::Motion motion(const Mass &mass, const State &state) const;

    /** Between two states (N m). */
    SpaceVector mean_torque(const Mass &mass, const Evaluation &step) const;

    /** Its derivative by spins at the end. */
    SpaceTensor mean_tangent(const Mass           &mass,
                             const Evaluation     &step,
                             const TangentFactors &factors) const;

    const DofNumbering &numbering;
    const NodeRotations rotations;
    const bool          large_rotation;
    std::vector<Mass>   masses;
    std::size_t         first_block   = 0;
    unsigned int        kinetic_entry = 0, numerical_entry = 0;
  };
} // namespace auxfem

#endif
