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
   * T(Theta), by which a change of the rotation vector turns exp(Theta):
   * d exp(Theta) = exp(Theta) [T dTheta]x (Bruels & Cardona 2010, Journal of
   * Computational and Nonlinear Dynamics 5, 031002):
   * @code
   * T = I - (1 - cos t) / t^2 [Theta]x + (t - sin t) / t^3 [Theta]x [Theta]x
   * @endcode
   * with t = |Theta|.
   */
  SpaceTensor tangent_operator(const SpaceVector &rotation_vector);

  /**
   * The inverse of tangent_operator(), I + [Theta]x / 2 +
   * (1 - t / 2 cot(t / 2)) / t^2 [Theta]x [Theta]x; singular at t = 2 pi.
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
