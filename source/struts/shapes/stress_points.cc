#include <auxfem/struts/shapes/stress_points.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;
    using Shear = StressPoint::Shear;

    /** Numbers of points along each side of a rectangle, along the radius and
     * around circles; odd or multiples of four, so that the middles and the
     * axes are among them. */
    constexpr unsigned int n_along_side = 9, n_along_radius = 5, n_around = 16;
    /** As n_along_side, in the plane, where there is one line of points. */
    constexpr unsigned int n_along_height = 33;

    /** Number @p i of @p n equally spaced numbers in [-1, 1]. */
    double spaced(const unsigned int i, const unsigned int n)
    {
      return n == 1 ? 0 : -1 + 2. * i / (n - 1);
    }

    /** Torque of a rectangle by a unit twist and shear modulus (m4), from the
     * series of its stresses: twice the volume below the stress function. */
    double torque_of_unit_twist(const double height, const double width)
    {
      const double b = std::max(height, width), t = std::min(height, width);
      double       sum = 0;
      for (unsigned int n = 1; n < 200; n += 2)
        sum += std::tanh(n * PI * b / (2 * t)) / std::pow(n, 5);
      return b * t * t * t / 3 * (1 - 192 / std::pow(PI, 5) * t / b * sum);
    }

    Shear scaled(const double factor, const Shear &shear)
    {
      return {{factor * shear[0], factor * shear[1]}};
    }
  } // namespace

  Shear twist_of_rectangle(const double y,
                           const double z,
                           const double height,
                           const double width)
  {
    // Terms fall with n^-2, and exponentially away from the sides z = +- b/2.
    Shear shear = {{0, 0}};
    for (int n = 1, sign = 1; n < 200; n += 2, sign = -sign)
      {
        const double a = n * PI / height;
        const double decay =
          std::exp(a * (std::abs(z) - width / 2)) / (1 + std::exp(-a * width));
        const double cosh = decay * (1 + std::exp(-2 * a * std::abs(z))),
                     sinh =
                       std::copysign(decay *
                                       (1 - std::exp(-2 * a * std::abs(z))),
                                     z);
        const double factor = sign * 8 * height / (PI * PI * n * n);
        shear[0] -= factor * sinh * std::cos(a * y);
        shear[1] += factor * (1 - cosh) * std::sin(a * y);
      }
    return shear;
  }

  StressPoints rectangle_stress_points(const double       height,
                                       const double       width,
                                       const unsigned int dimension)
  {
    StressPoints       result;
    const double       area     = height * width;
    const double       torque   = torque_of_unit_twist(height, width);
    const unsigned int n_across = dimension == 2 ? 1 : n_along_side;
    const unsigned int n_along = dimension == 2 ? n_along_height : n_along_side;
    for (unsigned int i = 0; i < n_along; ++i)
      for (unsigned int k = 0; k < n_across; ++k)
        {
          const double eta = spaced(i, n_along), zeta = spaced(k, n_across);
          StressPoint  point{eta * height / 2, zeta * width / 2};
          point.by_shear_2 = {{1.5 / area * (1 - eta * eta), 0}};
          point.by_shear_3 = {{0, 1.5 / area * (1 - zeta * zeta)}};
          if (dimension == 3)
            point.by_torque =
              scaled(1 / torque,
                     twist_of_rectangle(point.y, point.z, height, width));
          result.points.push_back(point);
        }
    return result;
  }

  namespace
  {
    /**
     * Stresses of a hollow circle by a unit force along y: the gradient of
     * (a r + b r^3 + c / r) cos(angle), whose Laplacian is -y / I and whose
     * normal derivative is zero at both radii.
     */
    Shear shear_of_tube(const double y,
                        const double z,
                        const double outer,
                        const double inner)
    {
      const double inertia = PI / 4 * (std::pow(outer, 4) - std::pow(inner, 4));
      const double b       = -1 / (8 * inertia);
      const double a       = -3 * b * (outer * outer + inner * inner),
                   c       = -3 * b * outer * outer * inner * inner;
      const double square  = y * y + z * z;
      // The last term is absent in a solid circle, whose centre is a point.
      const double by_bore = inner == 0 ? 0 : c / (square * square);
      return {{a + b * (3 * y * y + z * z) + by_bore * (z * z - y * y),
               2 * y * z * (b - by_bore)}};
    }
  } // namespace

  StressPoints tube_stress_points(const double outer, const double inner)
  {
    StressPoints result;
    result.is_axisymmetric = true;
    const double polar     = PI / 2 * (std::pow(outer, 4) - std::pow(inner, 4));
    for (unsigned int i = 0; i < n_along_radius; ++i)
      for (unsigned int k = 0; k < n_around; ++k)
        {
          const double radius =
            inner + (outer - inner) * i / (n_along_radius - 1);
          const double angle = 2 * PI * k / n_around;
          StressPoint point{radius * std::cos(angle), radius * std::sin(angle)};
          point.by_shear_2   = shear_of_tube(point.y, point.z, outer, inner);
          const Shear turned = shear_of_tube(point.z, point.y, outer, inner);
          point.by_shear_3   = {{turned[1], turned[0]}};
          point.by_torque    = {{-point.z / polar, point.y / polar}};
          result.points.push_back(point);
        }
    return result;
  }

  namespace
  {
    /** Stresses of an ellipse with half diameters @p a along y and @p b along
     * z by a unit force along y: the gradient of c (b^2 + 2 a^2 - k y^2 - z^2)
     * y, as for tubes. */
    Shear shear_of_ellipse(const double y,
                           const double z,
                           const double a,
                           const double b)
    {
      const double inertia = PI / 4 * a * a * a * b;
      const double c       = a * a / (inertia * (6 * a * a + 2 * b * b));
      const double k       = (b * b / (a * a) + 2) / 3;
      return {
        {c * (b * b + 2 * a * a - 3 * k * y * y - z * z), -2 * c * y * z}};
    }
  } // namespace

  StressPoints ellipse_stress_points(const double height, const double width)
  {
    const double a = height / 2, b = width / 2;
    StressPoints result;
    for (unsigned int i = 0; i < n_along_radius; ++i)
      for (unsigned int k = 0; k < 2 * n_around; ++k)
        {
          const double part  = double(i) / (n_along_radius - 1);
          const double angle = PI * k / n_around;
          StressPoint  point{part * a * std::cos(angle),
                            part * b * std::sin(angle)};
          point.by_shear_2   = shear_of_ellipse(point.y, point.z, a, b);
          const Shear turned = shear_of_ellipse(point.z, point.y, b, a);
          point.by_shear_3   = {{turned[1], turned[0]}};
          const double ab    = PI * a * b;
          point.by_torque    = {
               {-2 * point.z / (ab * b * b), 2 * point.y / (ab * a * a)}};
          result.points.push_back(point);
        }
    return result;
  }
} // namespace auxfem
