#ifndef auxfem_joints_effects_relative_angles_h
#define auxfem_joints_effects_relative_angles_h

#include <auxfem/connectors/connector_law.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/mathematics/rotation.h>

#include <array>
#include <string>
#include <vector>

/**
 * @file
 * Angles between two rotations for RotationalLaws. Rows of a member are those
 * of its base, -1 for the ground, and of its end.
 */
namespace auxfem
{
  /** Angles phi_2 - phi_1 between rotations in the plane. */
  class PlaneAngles
  {
  public:
    static constexpr unsigned int n_rows = 2;
    using Rows                           = std::array<int, n_rows>;
    using Directions                     = std::array<double, n_rows>;

    explicit PlaneAngles(const std::vector<Rows> &rows) : all_rows(rows)
    {}

    const std::vector<Rows> &rows() const
    {
      return all_rows;
    }

    void register_in(StateLayout & /*layout*/)
    {}

    /** Angle (rad) and its rate; writes the history. */
    ConnectorMotion motion(unsigned int i, const Evaluation &evaluation) const;

    /** Rate of the angle in @p state (rad/s). */
    double rate(unsigned int i, const State &state) const;

    /** Moments in the rows per moment of the law; in discrete-gradient steps
     * those whose work is the moment times the change of the angle. */
    Directions directions(unsigned int i, const Evaluation &evaluation) const;

    /** Derivatives of the angle by the rows. */
    Directions derivatives(unsigned int i, const Evaluation &evaluation) const;

    /** Adds the derivative of directions() times @p moment to a block. */
    void add_turning(const unsigned int /*i*/,
                     const Evaluation & /*evaluation*/,
                     const double /*moment*/,
                     double (&/*block*/)[n_rows * n_rows]) const
    {}

  private:
    const std::vector<Rows> all_rows;
  };

  /** A revolute hinge in space, about whose axis a law acts. */
  struct AxisPair
  {
    std::array<int, 3> base, end; ///< local spins; base of -1: ground
    SpaceVector        axis;      ///< unit vector at rest
    unsigned int       number;    ///< among the members of all ranks
  };

  /**
   * Angles about the axis P_1 a = P_2 a of revolute hinges. With b_1, b_2
   * across the axis at rest, c = P_1 b_1 . P_2 b_1 and s = P_1 b_2 . P_2 b_1
   * the angle is atan2(s, c), nearest to that of the step before. In a step
   * with Cayley's increments c_1, c_2 of both rotations
   * @code
   * angle' - angle = d / sin(d) (c_m u_m x v_2m - s_m u_m x v_1m) . (c_2 - c_1)
   * @endcode
   * holds exactly for d = angle' - angle, u = P_2 b_1, v_i = P_1 b_i and means
   * (m) over the step.
   */
  class AxisAngles
  {
  public:
    static constexpr unsigned int n_rows = 6;
    using Rows                           = std::array<int, n_rows>;
    using Directions                     = std::array<double, n_rows>;

    /** @param name of the group in records */
    AxisAngles(const DofNumbering          &numbering,
               bool                         large_rotation,
               const std::string           &name,
               const std::vector<AxisPair> &pairs);

    const std::vector<Rows> &rows() const
    {
      return all_rows;
    }

    /** Requests the angle and its change in the last step. */
    void register_in(StateLayout &layout);

    /** @name As PlaneAngles */
    ///@{
    ConnectorMotion motion(unsigned int i, const Evaluation &evaluation) const;
    double          rate(unsigned int i, const State &state) const;
    Directions directions(unsigned int i, const Evaluation &evaluation) const;
    Directions derivatives(unsigned int i, const Evaluation &evaluation) const;
    void       add_turning(unsigned int      i,
                           const Evaluation &evaluation,
                           double            moment,
                           double (&block)[n_rows * n_rows]) const;
    ///@}

  private:
    struct Pair
    {
      SpaceVector  axis, across[2];
      unsigned int number;
    };

    /** b_1 of the end, b_1 and b_2 of the base, rotated. */
    struct Arms
    {
      SpaceVector end, base[2];
    };

    Quaternion
         rotation(unsigned int i, unsigned int side, const State &state) const;
    Arms arms(unsigned int i, const State &state) const;
    SpaceVector axis(unsigned int i, const State &state) const;
    double      angle(unsigned int i, const State &state, double nearest) const;

    /** Minus @p axis for the base, @p axis for the end. */
    static Directions directions(const SpaceVector &axis);

    const DofNumbering &numbering;
    const NodeRotations rotations;
    const bool          is_large;
    const std::string   name;
    std::vector<Rows>   all_rows;
    std::vector<Pair>   pairs;
    std::size_t         first_angle = 0;
  };
} // namespace auxfem

#endif
