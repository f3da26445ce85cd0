#ifndef auxfem_contact_coulomb_friction_h
#define auxfem_contact_coulomb_friction_h

#include <deal.II/base/tensor.h>

namespace auxfem
{
  /** Friction at a point of contact. */
  struct FrictionForce
  {
    using Vector = dealii::Tensor<1, 3>;

    Vector force;      ///< on the first body (N)
    Vector slip;       ///< its velocity along the face of the other one (m/s)
    double recess = 0; ///< its velocity away from that (m/s)
    double scale  = 0; ///< sqrt(slip^2 + v0^2) (m/s); 0 without friction
    double limit  = 0; ///< N

    /** What is lost (W), at least 0. */
    double lost_power() const
    {
      return -(force * slip);
    }
  };

  /** Derivatives of minus the force of friction. */
  struct FrictionChange
  {
    dealii::Tensor<2, 3> by_velocity; ///< of the first body (N s/m)
    dealii::Tensor<2, 3> by_normal;   ///< for changes along the face (N)
    dealii::Tensor<1, 3> by_pressure; ///< 1
  };

  /**
   * Coulomb's friction, regularised: with @p v_t the velocity of a body along
   * the face of another one that presses on it with @p f, the force
   *
   *     -mu f v_t / sqrt(v_t^2 + v0^2).
   *
   * Theory: doc/theory.md, Contact, Friction.
   */
  struct CoulombFriction
  {
    double coefficient;   ///< mu
    double slip_velocity; ///< v0 (m/s)

    /**
     * @param velocity of the first body against the second (m/s)
     * @param normal of the face, of length 1, towards the first body
     * @param pressure force across the face (N)
     */
    FrictionForce force(const dealii::Tensor<1, 3> &velocity,
                        const dealii::Tensor<1, 3> &normal,
                        double                      pressure) const;

    /** @param normal, pressure those that @p force was found with */
    FrictionChange change(const FrictionForce        &force,
                          const dealii::Tensor<1, 3> &normal) const;
  };
} // namespace auxfem

#endif
