#include <auxfem/elements/rigid_part.h>

#include <cmath>

namespace auxfem
{
  template <>
  NaturalPosition natural_position<2>(const dealii::Point<3> &r0,
                                      const dealii::Point<3> &r1,
                                      const dealii::Point<3> &point)
  {
    const PlaneVector d        = in_dimension<2>(r1 - r0),
                      to_point = in_dimension<2>(point - r0);
    return {(to_point * d) / (d * d), (to_point * turned(d)) / (d * d)};
  }

  template <>
  NaturalPosition natural_position<3>(const dealii::Point<3> &r0,
                                      const dealii::Point<3> &r1,
                                      const dealii::Point<3> &point)
  {
    const dealii::Tensor<1, 3> d = r1 - r0;
    return {((point - r0) * d) / (d * d), 0};
  }

  template <>
  std::array<double, 4> shape<2>(const NaturalPosition &position,
                                 const unsigned int     component)
  {
    const auto [a, b] = position;
    if (component == 0)
      return {{1 - a, b, a, -b}};
    return {{-b, 1 - a, b, a}};
  }

  template <>
  std::array<double, 6> shape<3>(const NaturalPosition &position,
                                 const unsigned int     component)
  {
    std::array<double, 6> result = {};
    result[component]            = 1 - position.a;
    result[3 + component]        = position.a;
    return result;
  }

  template <int dim>
  std::array<double, 4 * dim * dim>
  rigid_mass_matrix(const double           mass,
                    const double           rotary_inertia,
                    const double           length,
                    const NaturalPosition &centre)
  {
    // Integrals over the mass of a, b and a^2 + b^2.
    const double first = mass * centre.a, skew = mass * centre.b,
                 second = mass * (centre.a * centre.a + centre.b * centre.b) +
      rotary_inertia / (length * length);
    const double m00 = mass - 2 * first + second, m01 = first - second;
    std::array<double, 4 *dim *dim> M = {};
    const auto set = [&M](const int i, const int j, const double value) {
      M[2 * dim * i + j] = M[2 * dim * j + i] = value;
    };
    for (int c = 0; c < dim; ++c)
      {
        set(c, c, m00);
        set(dim + c, dim + c, second);
        set(c, dim + c, m01);
      }
    if (dim == 2)
      {
        set(0, 3, -skew);
        set(1, 2, skew);
      }
    return M;
  }

  template std::array<double, 16>
  rigid_mass_matrix<2>(double, double, double, const NaturalPosition &);
  template std::array<double, 36>
  rigid_mass_matrix<3>(double, double, double, const NaturalPosition &);

  PlaneVector ClampConstraint::normal(const double rotation) const
  {
    const double c = std::cos(rotation), s = std::sin(rotation);
    PlaneVector  result;
    result[0] = -(s * rest[0] + c * rest[1]) / length;
    result[1] = (c * rest[0] - s * rest[1]) / length;
    return result;
  }
} // namespace auxfem
