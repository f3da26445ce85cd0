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

  /**
   * Velocities at t = 0 by local unknown (m/s, rad/s). A set moves as a rigid
   * body: its velocity plus the angular velocity about the mean of its joints;
   * of several sets with a joint the last counts. Struts whose ends both have
   * an initial velocity, by one set or two, move with them (StrutVelocities);
   * others are at rest but for the end. Rigid parts with a rotation of their
   * own turn with a set if all their joints belong to it.
   *
   * Throws InputError for a velocity that a support does not allow, and for an
   * angular velocity that turns nothing.
   */
  std::vector<std::pair<int, double>>
  initial_velocities(const RunPlan      &plan,
                     const Lattice      &lattice,
                     const DofNumbering &numbering);
} // namespace auxfem

#endif
