#ifndef auxfem_equations_node_rotations_h
#define auxfem_equations_node_rotations_h

#include <auxfem/equations/effect.h>
#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/mathematics/rotation.h>
#include <auxfem/model/numbering.h>
#include <auxfem/state/state.h>

namespace auxfem
{
  /**
   * Large rotations P of the nodes in space, kept as quaternions in
   * State::rotations (Lie-group form of time stepping, Bruels & Cardona 2010,
   * Journal of Computational and Nonlinear Dynamics 5, 031002):
   *
   * - In State::displacement the three entries of a rotation sum up the
   *   material rotation vectors Theta of the steps, P_{n+1} = P_n exp(Theta).
   *   Velocities and accelerations are material too: W = P^T omega and W'. An
   *   integrator may thus treat them like all other unknowns.
   * - Rows of the residual (moments) and increments of Newton's method (spins
   *   theta, P <- exp(theta) P) are in the global frame.
   *
   * Does nothing in the plane and for small rotations, where State::rotations
   * is empty.
   */
  class NodeRotations
  {
  public:
    explicit NodeRotations(const DofNumbering &numbering);

    /** Turns evaluation.to.rotations to where evaluation.to.displacement says.
     */
    void follow(const Evaluation &evaluation) const;

    /**
     * Turns evaluation.to.rotations by the spins in @p increment and replaces these
     * by changes of Theta.
     */
    void rotate(const Evaluation &evaluation, Vector &increment) const;

    /** Replaces spatial values at the rotations in @p vector by material ones of @p state. */
    void make_material(const State &state, Vector &vector) const;

    /**
     * The increment of rotation @p i in the step as a vector in the global frame:
     * P_n Theta (rad). A constant moment's work in the step is its product with
     * this.
     */
    SpaceVector spatial_increment(const Evaluation &evaluation,
                                  unsigned int      i) const;

    /**
     * Velocity of the local unknown @p unknown in the global frame (m/s, rad/s),
     * which of large rotations in space is material in @p state.
     */
    double spatial_rate(const State &state, int unknown) const;

    /** Theta of rotation @p i. */
    SpaceVector material_increment(const Evaluation &evaluation,
                                   unsigned int      i) const;

    /** Sets evaluation.to.displacement such that Theta is @p increment. */
    void set_material_increment(const Evaluation  &evaluation,
                                unsigned int       i,
                                const SpaceVector &rotate) const;

    /** dTheta / dtheta = T^-1(Theta) P^T: how a spin changes rates; between two
     * states that of Cayley's measure of Theta. */
    SpaceTensor increment_by_spin(const Evaluation &evaluation,
                                  unsigned int      i) const;

    /** Values of @p vector at rotation @p i. */
    SpaceVector values(const Vector &vector, unsigned int i) const;

    /** Sets them. */
    void
    set_values(const SpaceVector &values, unsigned int i, Vector &vector) const;

  private:
    const DofNumbering &numbering;
  };

  /** @p state with @p factor times @p shape added, of all local unknowns;
   * rotations as vectors in the global frame. */
  State displaced(const State        &state,
                  const DofNumbering &numbering,
                  const Vector       &shape,
                  double              factor);

  /**
   * How far unknowns move in a step between two states, as forces and moments
   * in the residual see it: large rotations by Cayley's measure.
   */
  class StepTravel
  {
  public:
    /** The arguments must outlive the object. */
    StepTravel(const Evaluation &step, const DofNumbering &numbering)
      : step(step)
      , u0(step.from.displacement.data())
      , u1(step.to.displacement.data())
      , has_plane_rotations(!step.to.plane_rotations->empty())
      , numbering(numbering)
      , rotations(numbering)
    {}

    /** What a force or moment on @p unknown does work on (m, rad). */
    double of(const int unknown) const
    {
      if (const int i = space_rotation(unknown); i >= 0)
        return rotations.spatial_increment(
                 step,
                 i)[numbering.rotations().axis(unknown)] /
          angle_per_cayley_rotation(rotation_angle(i));
      const double moved = u1[unknown] - u0[unknown];
      return is_plane_rotation(unknown) ? cayley_rotation(moved) : moved;
    }

    /** Increment of @p unknown over what of() says. */
    double increment_per_travel(const int unknown) const
    {
      if (const int i = space_rotation(unknown); i >= 0)
        return angle_per_cayley_rotation(rotation_angle(i));
      return is_plane_rotation(unknown)
        ? angle_per_cayley_rotation(u1[unknown] - u0[unknown])
        : 1.;
    }

  private:
    bool is_plane_rotation(const int unknown) const
    {
      return has_plane_rotations && numbering.unknowns().is_rotation[unknown];
    }

    /** The large rotation in space of which @p unknown is part, or -1. */
    int space_rotation(const int unknown) const
    {
      return step.to.rotations.empty() ? -1
                                       : numbering.rotations().with(unknown);
    }

    /** Angle of rotation @p i in the step (rad). */
    double rotation_angle(const unsigned int i) const
    {
      return rotations.material_increment(step, i).norm();
    }

    const Evaluation   &step;
    const double       *u0, *u1;
    const bool          has_plane_rotations;
    const DofNumbering &numbering;
    const NodeRotations rotations;
  };
} // namespace auxfem

#endif
