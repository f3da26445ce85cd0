#ifndef auxfem_model_strut_velocities_h
#define auxfem_model_strut_velocities_h

#include <auxfem/elements/rotation.h>
#include <auxfem/mesh/motion_components.h>

#include <deal.II/base/point.h>

#include <array>

namespace auxfem
{
  /** Velocity and angular velocity (m/s, rad/s), by component of motion. */
  using JointVelocity = std::array<double, n_motion_components>;

  /** What is known of one end of a strut at rest. */
  struct MovingEnd
  {
    dealii::Point<3> position; ///< m
    JointVelocity    velocity;
    /** Whether the strut turns freely there; about its chord it turns with the
     * velocity all the same. */
    bool is_released;
  };

  /**
   * Velocities inside a strut whose ends move: those of a slender beam along
   * the chord, which turns and stretches with its ends and is bent, by cubic
   * polynomials, where they turn against it. Sections stay plane and
   * perpendicular, so the rates of shear are zero; an arc's axis moves with
   * the sections of the chord. Ends that move as one rigid body give its
   * motion, to round-off.
   */
  class StrutVelocities
  {
  public:
    explicit StrutVelocities(const std::array<MovingEnd, 2> &ends);

    /** At the @p fraction in [0, 1] of the strut's length, at @p position (m). */
    JointVelocity at(double fraction, const dealii::Point<3> &position) const;

  private:
    dealii::Point<3> begin;
    SpaceVector      chord;
    /** Of the chord, that of its beginning and its lengthening in all. */
    SpaceVector angular_velocity, velocity, lengthening;
    /** Of the ends against the chord: across it and about it (rad/s). */
    std::array<SpaceVector, 2> bending, twist;
  };
} // namespace auxfem

#endif
