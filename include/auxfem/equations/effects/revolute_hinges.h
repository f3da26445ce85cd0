#ifndef auxfem_equations_effects_revolute_hinges_h
#define auxfem_equations_effects_revolute_hinges_h

#include <auxfem/equations/constraints.h>
#include <auxfem/equations/node_rotations.h>

namespace auxfem
{
  /**
   * Revolute hinges in space: a rotation P_2 turns against a rotation P_1, or
   * the ground, about an axis a alone, given at rest, that turns with both.
   * With b_1, b_2 across a and a length l,
   * @code
   * g_i = l (P_1 b_i) . (P_2 a) = 0, i = 1, 2
   * @endcode
   * The moments between both are l lambda_i (P_1 b_i) x (P_2 a). With small
   * rotations the constraints are linearized about rest.
   */
  class RevoluteHinges : public Constraints
  {
  public:
    /** @param length l (m). */
    RevoluteHinges(const DofNumbering &numbering,
                   bool                large_rotation,
                   double              length);

    /**
     * Adds a hinge.
     * @param base, end local rotations of which the second turns against the
     *   first; base of -1: against the ground.
     * @param axis a (unit vector).
     */
    void add(const std::array<int, 3> &base,
             const std::array<int, 3> &end,
             const std::array<int, 2> &multipliers,
             const SpaceVector        &axis);

    bool is_linear() const override;
    void register_blocks(TangentPattern &pattern) override;
    void add_residual(const Evaluation &evaluation,
                      double           *residual,
                      EffectResults    *results) const override;
    void add_tangent(const Evaluation     &evaluation,
                     const EffectResults  *results,
                     const TangentFactors &factors,
                     TangentMatrix        &matrix) const override;
    void raise_forces(const Evaluation    &evaluation,
                      const EffectResults *results,
                      double              *forces) const override;
    void find_rates(const State &state, double *rates) const override;

  private:
    struct Hinge
    {
      std::array<int, 8> unknowns; ///< base, end, multipliers
      SpaceVector        axis;
      SpaceVector        across[2];
    };
    /** The hinge now: a of the end, and b_i of the base. */
    struct Axes
    {
      SpaceVector axis, across[2];

      /** dg_i = arm_i . (theta_1 - theta_2) / l. */
      SpaceVector arm(const unsigned int i) const
      {
        return dealii::cross_product_3d(across[i], axis);
      }
    };

    /** The axes @p hinge has in @p state. */
    Axes axes(const Hinge &hinge, const State &state) const;

    /**
     * Those along which moments act. Between two states the means over the
     * step: with them across . axis changes by its gradient times Cayley's
     * measures of the rotations, so that the moments do no work.
     */
    Axes acting_axes(const Hinge &hinge, const Evaluation &evaluation) const;
    /** Rotation of the base (0) or the end (1); none of the ground or if
     * rotations are small. */
    Quaternion
    rotation(const Hinge &hinge, unsigned int which, const State &state) const;
    /** Spatial values of @p vector at base (0) or end (1). */
    SpaceVector spatial(const Hinge  &hinge,
                        unsigned int  which,
                        const State  &state,
                        const Vector &vector) const;
    double      acceleration(const Hinge &hinge,
                             const Axes  &axes,
                             unsigned int i,
                             const State &state) const;

    const DofNumbering &numbering;
    const bool          large_rotation;
    const double        unit; ///< l
    std::vector<Hinge>  hinges;
    std::size_t         first_block = 0;
  };
} // namespace auxfem

#endif
