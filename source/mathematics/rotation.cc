#include <auxfem/mathematics/rotation.h>
#include <auxfem/mathematics/rotation_operators.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

namespace auxfem
{
  namespace
  {
    SpaceVector axis_vector(const unsigned int axis)
    {
      SpaceVector result;
      result[axis] = 1;
      return result;
    }
  } // namespace

  bool nearly_parallel(const SpaceVector &a, const SpaceVector &b)
  {
    const double sine_of_five_degrees = 0.08715574274765817;
    return dealii::cross_product_3d(a, b).norm() <=
      sine_of_five_degrees * a.norm() * b.norm();
  }

  SpaceVector default_reference(const SpaceVector &tangent)
  {
    const SpaceVector z = axis_vector(2);
    return nearly_parallel(tangent, z) ? axis_vector(0) : z;
  }

  SpaceTensor section_frame(const SpaceVector &tangent,
                            const SpaceVector &reference)
  {
    SpaceVector axes[3];
    axes[0] = tangent / tangent.norm();
    axes[1] = dealii::cross_product_3d(reference, axes[0]);
    Assert(axes[1].norm() > 0,
           dealii::ExcMessage("The reference vector is along the strut."));
    axes[1] /= axes[1].norm();
    axes[2] = dealii::cross_product_3d(axes[0], axes[1]);
    SpaceTensor result;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 3; ++i)
        result[i][axis] = axes[axis][i];
    return result;
  }

  SpaceTensor section_frame(const SpaceVector        &tangent,
                            const SectionOrientation &orientation)
  {
    const auto &reference = orientation.reference;
    SpaceTensor frame =
      section_frame(tangent,
                    reference ? *reference : default_reference(tangent));
    if (orientation.principal_angle == 0)
      return frame;
    const double c = std::cos(orientation.principal_angle),
                 s = std::sin(orientation.principal_angle);
    for (int i = 0; i < 3; ++i)
      {
        const double drawn_2 = frame[i][1], drawn_3 = frame[i][2];
        frame[i][1] = c * drawn_2 + s * drawn_3;
        frame[i][2] = c * drawn_3 - s * drawn_2;
      }
    return frame;
  }

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
    // The identity has no axis of its own: take that of the guess.
    const SpaceVector axis        = angle > 1e-8 ? principal / angle
             : guess.norm() > 0                  ? guess / guess.norm()
                                                 : SpaceVector();
    const double      full_circle = 2 * dealii::numbers::PI;
    return principal +
      full_circle * std::round((axis * (guess - principal)) / full_circle) *
      axis;
  }
} // namespace auxfem
