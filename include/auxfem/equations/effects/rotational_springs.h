#ifndef auxfem_equations_effects_rotational_springs_h
#define auxfem_equations_effects_rotational_springs_h

#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>

namespace auxfem
{
  /** Linear springs between two rotations of one joint: M = K' (phi_2 - phi_1).
   */
  class RotationalSprings : public Effect
  {
  public:
    explicit RotationalSprings(const DofNumbering &numbering);

    /**
     * Adds a spring of @p stiffness (N m/rad) between two local rotations;
     * @p first = -1: between the ground and the second.
     */
    void add(int first, int second, double stiffness);

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
    void raise_uncertain_forces(const Evaluation    &evaluation,
                                const EffectResults *results,
                                double               largest_displacement,
                                double               largest_rotation,
                                double              *forces) const override;

  private:
    struct Spring
    {
      int    unknowns[2];
      double stiffness;
    };
    /** phi_2 - phi_1 (rad). */
    static double angle(const Spring &spring, const double *u);

    /** Over a step between two states. */
    void add_mean_moments(const Evaluation &evaluation, double *residual) const;

    const DofNumbering &numbering;
    std::vector<Spring> springs;
    std::size_t         first_block  = 0;
    unsigned int        strain_entry = 0;
  };
} // namespace auxfem

#endif
