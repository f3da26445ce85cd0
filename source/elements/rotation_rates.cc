#include <auxfem/elements/rotation_operators.h>
#include <auxfem/elements/rotation_rates.h>

#include <deal.II/base/numbers.h>

namespace auxfem
{
  SpaceTensor inverse_tangent_operator(const SpaceVector &rotation_vector)
  {
    return inverse_tangent_operator(InverseRotationCoefficients(
                                      rotation_vector),
                                    rotation_vector);
  }

  AngularMotion angular_motion(const SpaceVector &rotation_vector,
                               const SpaceVector &first,
                               const SpaceVector &second)
  {
    const RotationCoefficients c(rotation_vector);
    const SpaceTensor          T = tangent_operator(c, rotation_vector);
    return {T * first,
            T * second + tangent_derivative(c, rotation_vector, first) * first};
  }

  SpaceVector rotation_vector_near(const Quaternion  &rotation,
                                   const SpaceVector &guess)
  {
    const SpaceVector principal = rotation_vector(rotation);
    const double      angle     = principal.norm();
    // The axis of a rotation by zero or whole turns is that of the guess.
    const SpaceVector axis        = angle > 1e-8 ? principal / angle
             : guess.norm() > 0                  ? guess / guess.norm()
                                                 : SpaceVector();
    const double      full_circle = 2 * dealii::numbers::PI;
    return principal +
      full_circle * std::round((axis * (guess - principal)) / full_circle) *
      axis;
  }
} // namespace auxfem
