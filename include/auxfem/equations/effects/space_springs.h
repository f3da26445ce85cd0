#ifndef auxfem_equations_effects_space_springs_h
#define auxfem_equations_effects_space_springs_h

#include <auxfem/equations/node_rotations.h>

namespace auxfem
{
  /**
   * Isotropic springs between two large rotations in space. With psi the
   * rotation vector of P_2 P_1^-1 the energy is K' |psi|^2 / 2, the moment on
   * the second -K' psi, on the first K' psi. Whole turns count: of all vectors
   * psi that is taken which is nearest to the one at the start of the step,
   * kept in State::history as P_1^-1 psi, which does not change when both turn
   * together.
   */
  class SpaceSprings : public Effect
  {
  public:
    explicit SpaceSprings(const DofNumbering &numbering);

    /**
     * Adds a spring of @p stiffness (N m/rad) between two of
     * DofNumbering::spatial_rotations(); @p first = -1: between the ground and
     * the second.
     * @param number of the spring among those of all ranks
     */
    void add(int first, int second, double stiffness, unsigned int number);

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
      std::array<int, 6> unknowns; ///< spins of both; -1: ground
      int                first, second;
      double             stiffness;
      unsigned int       number; ///< among those of all ranks
    };
    Quaternion base_rotation(const Spring &spring, const State &state) const;
    /** P_1^-1 psi. */
    SpaceVector material_angle(unsigned int      i,
                               const Evaluation &evaluation) const;
    /** psi (rad). */
    SpaceVector angle(unsigned int i, const Evaluation &evaluation) const;

    /**
     * Moment on the second rotation between two states, of which the rotation
     * vector at the end is @p turned (material): the mean, corrected along the
     * relative turn such that its work is the change of energy (Gonzalez 1996)
     * (N m).
     */
    SpaceVector mean_moment(unsigned int       i,
                            const SpaceVector &turned,
                            const Evaluation  &step) const;

    const DofNumbering &numbering;
    std::vector<Spring> springs;
    std::size_t         first_history = 0, first_block = 0;
    unsigned int        strain_entry = 0;
  };
} // namespace auxfem

#endif
