#ifndef auxfem_struts_rotary_inertia_h
#define auxfem_struts_rotary_inertia_h

#include <auxfem/mathematics/cayley_rotation.h>
#include <auxfem/mathematics/rotation.h>

namespace auxfem
{
  /**
   * Rotary inertia of a node in space: Euler's equations. Tensors and angular
   * velocities are material: the global ones rotated back by the rotation P
   * since rest, W = P^T omega, P' = P [W]x.
   */
  namespace RotaryInertia
  {
    /** Rotation rates of a node. */
    using Motion = AngularMotion;

    /** Kinetic energy W . J W / 2 (J). */
    inline double kinetic_energy(const SpaceTensor &inertia,
                                 const SpaceVector &velocity)
    {
      return velocity * (inertia * velocity) / 2;
    }

    /**
     * Rate of the angular momentum P J W (N m, global frame):
     * P (J W' + W x J W).
     * @param inertia J at rest (kg m2)
     */
    inline SpaceVector torque(const SpaceTensor &inertia,
                              const Quaternion  &rotation,
                              const Motion      &motion)
    {
      return rotated(rotation,
                     inertia * motion.acceleration +
                       dealii::cross_product_3d(motion.velocity,
                                                inertia * motion.velocity));
    }

    /**
     * Mean torque over a step by the discrete gradient: the change of P J W
     * over @p dt, plus @p alpha (1/s) times its mean with mass-proportional
     * damping. Its work on Cayley's measure c of the rotation, dt times the
     * mean of W, is the change of kinetic energy, since P_0 c = P_1 c.
     * @param start, end P_0, P_1
     * @param momentum J (W_0 + W_1) / 2
     * @param rate J (W_1 - W_0) / dt
     */
    inline SpaceVector mean_torque(const Quaternion  &start,
                                   const Quaternion  &end,
                                   const SpaceVector &momentum,
                                   const SpaceVector &rate,
                                   const double       dt,
                                   const double       alpha)
    {
      // P_1 - P_0 is [c]x times their mean; a difference of P J W would cancel
      // digits.
      const SpaceVector turn = cayley_rotation(end * conjugate(start));
      const SpaceVector L = mean_over_rotation(turn, rotated(start, momentum)),
                        L_rate = mean_over_rotation(turn, rotated(start, rate));
      return L_rate + dealii::cross_product_3d(turn / dt, L) +
        alpha * (L + dealii::cross_product_3d(dt / 4 * turn, L_rate));
    }

    /** Derivatives of the torque. */
    struct Tangent
    {
      SpaceTensor by_spin; ///< theta, with P <- exp(theta) P at fixed W, W'
      SpaceTensor by_velocity, by_acceleration; ///< material
    };

    /** Tangent of torque(). The gyroscopic terms are P ([W]x J - [J W]x). */
    inline Tangent tangent(const SpaceTensor &inertia,
                           const Quaternion  &rotation,
                           const Motion      &motion)
    {
      return {-1. * cross_product_tensor(torque(inertia, rotation, motion)),
              rotated(rotation,
                      cross_product_tensor(motion.velocity) * inertia -
                        cross_product_tensor(inertia * motion.velocity)),
              rotated(rotation, inertia)};
    }
  } // namespace RotaryInertia
} // namespace auxfem

#endif
