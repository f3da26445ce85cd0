#ifndef auxfem_equations_node_rotations_h
#define auxfem_equations_node_rotations_h

#include <auxfem/elements/rotation_rates.h>
#include <auxfem/equations/effect.h>
#include <auxfem/model/numbering.h>

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
} // namespace auxfem

#endif
