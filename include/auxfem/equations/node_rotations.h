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
   * - State::displacement accumulates the material rotation vectors Theta of
   *   the steps, P_{n+1} = P_n exp(Theta). Velocities and accelerations are
   *   material: W = P^T omega and W'. Time integrators thus treat rotations
   *   like other unknowns.
   * - Rows of the residual (moments) and increments of Newton's method (spins
   *   theta, P <- exp(theta) P) are in the global frame.
   *
   * No operation in the plane and for small rotations, where State::rotations
   * is empty.
   */
  class NodeRotations
  {
  public:
    explicit NodeRotations(const DofNumbering &numbering);

    /** Updates evaluation.to.rotations from evaluation.to.displacement. */
    void follow(const Evaluation &evaluation) const;

    /** Rotates evaluation.to.rotations by the spins in @p increment and
     * replaces the spins by changes of Theta. */
    void rotate(const Evaluation &evaluation, Vector &increment) const;

    /** Transforms spatial values at rotations in @p vector to material ones of
     * @p state. */
    void make_material(const State &state, Vector &vector) const;

    /** Increment of rotation @p i in the global frame: P_n Theta (rad). A
     * constant moment does work on it. */
    SpaceVector spatial_increment(const Evaluation &evaluation,
                                  unsigned int      i) const;

    /** Velocity of a local unknown in the global frame (m/s, rad/s). */
    double spatial_rate(const State &state, int unknown) const;

    /** Theta of rotation @p i (rad). */
    SpaceVector material_increment(const Evaluation &evaluation,
                                   unsigned int      i) const;

    /** Sets evaluation.to.displacement such that Theta is @p increment. */
    void set_material_increment(const Evaluation  &evaluation,
                                unsigned int       i,
                                const SpaceVector &rotate) const;

    /** dTheta / dtheta = T^-1(Theta) P^T: derivative with respect to a spin.
     * For discrete gradients that of the Cayley measure of Theta. */
    SpaceTensor increment_by_spin(const Evaluation &evaluation,
                                  unsigned int      i) const;

    /** Values of @p vector at rotation @p i. */
    SpaceVector values(const Vector &vector, unsigned int i) const;

    /** Sets the values at rotation @p i. */
    void
    set_values(const SpaceVector &values, unsigned int i, Vector &vector) const;

  private:
    const DofNumbering &numbering;
  };

  /**
   * @p state displaced by @p factor times @p shape on all local unknowns;
   * rotations in @p shape are vectors in the global frame.
   */
  State displaced(const State        &state,
                  const DofNumbering &numbering,
                  const Vector       &shape,
                  double              factor);

  /**
   * Increments work-conjugate to residual rows in a discrete-gradient step:
   * large rotations use the Cayley measure.
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

    /** Increment on which a force or moment at @p unknown does work (m,
     * rad). */
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

    /** Increment of @p unknown over of(). */
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

    /** Large rotation in space that contains @p unknown, or -1. */
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
