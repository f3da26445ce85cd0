#ifndef auxfem_system_effects_rigid_part_conditions_h
#define auxfem_system_effects_rigid_part_conditions_h

#include <auxfem/system/effect.h>
#include <auxfem/system/rigid_bodies.h>

namespace auxfem
{
  /** What a rigid part does at one time. */
  struct RigidPartReport
  {
    /** Number in Lattice::rigid_parts. */
    unsigned int part;
    /** Displacements (m) and velocities (m/s) x, y of its base joints. */
    std::array<double, 4> base_displacement, base_velocity;
    /**
     * Force (N) that each of its joints, in the order of RigidPart::joints,
     * exerts on the part: what hinges, struts, connectors, loads and supports
     * there pass on to it.
     */
    std::vector<PlaneVector> forces;
  };

  /**
   * The conditions that keep rigid parts rigid, with their Lagrange multipliers
   * lambda: forces G^T lambda on the joints, and the conditions g = 0
   * themselves in the rows of the multipliers (m). In an evaluation at rest in
   * time (dt = 0) of a dynamic scene these rows hold d2g/dt2, which determines
   * consistent accelerations.
   *
   * With small displacements (large_rotation false) the conditions are
   * linearized about rest.
   */
  class RigidPartConditions : public Effect
  {
  public:
    /** @param gravity for the reported forces (m/s2), zero if it is left out. */
    RigidPartConditions(const std::vector<RigidBody> &bodies,
                        const Lattice                &lattice,
                        const DofNumbering           &numbering,
                        bool                          large_rotation,
                        const dealii::Tensor<1, 3>   &gravity);

    bool   is_linear() const override;
    void   register_blocks(TangentMatrix &matrix) override;
    void   add_residual(const Step &step, double *residual) override;
    void   add_tangent(const Step           &step,
                       const TangentFactors &factors,
                       TangentMatrix        &matrix) const override;
    double round_off_scale(double largest_displacement,
                           double largest_rotation) const override;

    /** dg/dt (m/s) of the velocities of @p state, into the multipliers' entries of @p rates (n_local entries). */
    void find_rates(const State &state, double *rates) const;

    /** Number of parts this rank reports on. */
    unsigned int n_reported() const;

    /** Number in Lattice::rigid_parts of part @p i of this rank. */
    unsigned int part(unsigned int i) const;

    /**
     * Rotation of part @p i of this rank (rad), counterclockwise; in (-pi, pi]
     * with large rotations.
     */
    double rotation(unsigned int i, const State &state) const;

    /** Report on part @p i of this rank, from displacements, accelerations and multipliers of @p state. */
    RigidPartReport report(unsigned int i, const State &state) const;

  private:
    /** Distance of the base joints of one body. */
    struct Base
    {
      std::array<int, 5> unknowns; ///< base, multiplier
      DistanceCondition  condition;
    };
    /** Place of another joint. */
    struct Joint
    {
      unsigned int       place_in_part; ///< index into RigidPart::joints
      std::array<int, 8> unknowns;      ///< joint's two, base, two multipliers
      std::array<std::array<double, 4>, 2> shapes;
    };
    struct Clamp
    {
      std::array<int, 6> unknowns; ///< base, rotation, multiplier
      ClampCondition     condition;
    };

    PlaneVector gradient(const Base &base, const double *u) const;
    /** dg / d(r1 - r0) and dg / dphi. */
    std::pair<PlaneVector, double> gradient(const Clamp  &clamp,
                                            const double *u) const;

    void add_base_rows(const Step &step, double *residual) const;
    void add_joint_rows(const Step &step, double *residual) const;
    void add_clamp_rows(const Step &step, double *residual) const;

    const std::vector<RigidBody> bodies;
    const Lattice               &lattice;
    const DofNumbering          &numbering;
    const bool                   large_rotation;
    const dealii::Tensor<1, 3>   gravity;

    std::vector<Base>  bases; ///< one a body
    std::vector<Joint> joints;
    std::vector<Clamp> clamps;
    /** Those of body b: from [b] to [b + 1]. */
    std::vector<unsigned int> joint_begin, clamp_begin;
    std::vector<unsigned int> reported; ///< bodies
    std::size_t               first_block = 0;
    /** Of the state last evaluated (N). */
    double largest_multiplier = 0;
  };
} // namespace auxfem

#endif
