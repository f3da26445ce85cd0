#ifndef auxfem_system_effects_space_springs_h
#define auxfem_system_effects_space_springs_h

#include <auxfem/system/node_rotations.h>

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
    /** @param layout of which the springs' history follows that of others. */
    SpaceSprings(const DofNumbering &numbering, const StateLayout &layout);

    /**
     * Adds a spring of @p stiffness (N m/rad) between two of
     * DofNumbering::spatial_rotations(); @p first = -1: between the ground and
     * the second. Extends @p layout.
     */
    void add(int first, int second, double stiffness, StateLayout &layout);

    bool   is_linear() const override;
    void   register_blocks(TangentMatrix &matrix) override;
    void   add_residual(const Step &step, double *residual) override;
    void   add_tangent(const Step           &step,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override;
    void   add_energies(const State &state, Energies &energies) const override;
    double round_off_scale(double largest_displacement,
                           double largest_rotation) const override;

  private:
    struct Spring
    {
      std::array<int, 6> unknowns; ///< spins of both; -1: ground
      int                first, second;
      double             stiffness;
      /** psi of the state last evaluated (rad). */
      SpaceVector angle;
    };
    Quaternion base_rotation(const Spring &spring, const State &state) const;
    /** P_1^-1 psi. */
    SpaceVector material_angle(unsigned int i, const Step &step) const;

    const DofNumbering &numbering;
    const unsigned int  first_history;
    std::vector<Spring> springs;
    std::size_t         first_block = 0;
  };
} // namespace auxfem

#endif
