#include <auxfem/elements/rigid_part.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    PlaneVector in_plane(const dealii::Tensor<1, 3> &v)
    {
      PlaneVector result;
      result[0] = v[0];
      result[1] = v[1];
      return result;
    }
  } // namespace

  NaturalPlace natural_place(const dealii::Point<3> &r0,
                             const dealii::Point<3> &r1,
                             const dealii::Point<3> &point)
  {
    const PlaneVector d = in_plane(r1 - r0), to_point = in_plane(point - r0);
    return {(to_point * d) / (d * d), (to_point * turned(d)) / (d * d)};
  }

  std::array<double, 4> shape(const NaturalPlace &place,
                              const unsigned int  component)
  {
    const auto [a, b] = place;
    if (component == 0)
      return {{1 - a, b, a, -b}};
    return {{-b, 1 - a, b, a}};
  }

  std::array<double, 16> rigid_mass_matrix(const double        mass,
                                           const double        rotary_inertia,
                                           const double        length,
                                           const NaturalPlace &centre)
  {
    // Integrals over the mass of a, b and a^2 + b^2.
    const double first = mass * centre.a, skew = mass * centre.b,
                 second = mass * (centre.a * centre.a + centre.b * centre.b) +
      rotary_inertia / (length * length);
    const double m00 = mass - 2 * first + second, m01 = first - second;
    return {{m00,
             0,
             m01,
             -skew, //
             0,
             m00,
             skew,
             m01, //
             m01,
             skew,
             second,
             0, //
             -skew,
             m01,
             0,
             second}};
  }

  PlaneVector ClampCondition::normal(const double rotation) const
  {
    const double c = std::cos(rotation), s = std::sin(rotation);
    PlaneVector  result;
    result[0] = -(s * rest[0] + c * rest[1]) / length;
    result[1] = (c * rest[0] - s * rest[1]) / length;
    return result;
  }
} // namespace auxfem
