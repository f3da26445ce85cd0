#ifndef auxfem_elements_rotation_rates_h
#define auxfem_elements_rotation_rates_h

#include <auxfem/elements/rotation.h>

namespace auxfem
{
  /**
   * Angular velocity (rad/s) and acceleration (rad/s2), material: W with
   * P' = P [W]x, and its rate.
   */
  struct AngularMotion
  {
    SpaceVector velocity, acceleration;
  };

  /**
   * T(Theta)^-1, by which a rotation vector changes when exp(Theta) turns:
   * d exp(Theta) = exp(Theta) [T dTheta]x; singular at |Theta| = 2 pi.
   */
  SpaceTensor inverse_tangent_operator(const SpaceVector &rotation_vector);

  /**
   * Of P = exp(phi(t)): W = T phi', W' = T phi'' + T' phi'.
   * @param rotation_vector phi (rad)
   * @param first, second phi' (rad/s), phi'' (rad/s2)
   */
  AngularMotion angular_motion(const SpaceVector &rotation_vector,
                               const SpaceVector &first,
                               const SpaceVector &second);

  /**
   * That of all rotation vectors of @p rotation, of any number of turns, which
   * is nearest to @p guess (rad).
   */
  SpaceVector rotation_vector_near(const Quaternion  &rotation,
                                   const SpaceVector &guess);
} // namespace auxfem

#endif
