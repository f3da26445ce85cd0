#ifndef auxfem_model_initial_velocities_h
#define auxfem_model_initial_velocities_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/model/numbering.h>
#include <auxfem/scene/run_plan.h>

#include <deal.II/base/point.h>

#include <array>

namespace auxfem
{
  /** Velocity and angular velocity (m/s, rad/s) by motion component. */
  using JointVelocity = std::array<double, n_motion_components>;

  /** Position and velocity of one end of a strut. */
  struct MovingEnd
  {
    dealii::Point<3> position; ///< m
    JointVelocity    velocity;
    /** Whether the end is released; twist about the chord still follows the
     * velocity. */
    bool is_released;
  };

  /**
   * Velocity field inside a strut from its end velocities: a slender beam on
   * the chord with cubic bending and no shear rate. The axis of an arc follows
   * the sections of the chord. Rigid end motions are reproduced to round-off.
   */
  class StrutVelocities
  {
  public:
    explicit StrutVelocities(const std::array<MovingEnd, 2> &ends);

    /** Velocity at the @p fraction in [0, 1] of the length, at @p position
     * (m). */
    JointVelocity at(double fraction, const dealii::Point<3> &position) const;

  private:
    dealii::Point<3> begin;
    SpaceVector      chord;
    /** Angular velocity of the chord, velocity of its start, rate of its
     * length. */
    SpaceVector angular_velocity, velocity, lengthening;
    /** Angular velocities of the ends relative to the chord (rad/s). */
    std::array<SpaceVector, 2> bending, twist;
  };

  /**
   * Velocities at t = 0 by local unknown (m/s, rad/s). A set moves as a rigid
   * body about the mean of its joints; later sets override earlier ones. Struts
   * with two moving ends follow StrutVelocities, other struts are at rest
   * inside. Rigid parts rotate with a set that contains all their joints.
   *
   * Throws InputError for a velocity that contradicts a support and for an
   * angular velocity without effect.
   */
  std::vector<std::pair<int, double>>
  initial_velocities(const RunPlan      &plan,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);
} // namespace auxfem

#endif
