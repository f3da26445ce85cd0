#include <auxfem/contact/rigid_surface.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    using Vector3 = RigidSurface::Vector;
    using Lines   = std::vector<std::vector<Vector3>>;

    Vector3 unit_vector(const unsigned int direction)
    {
      Vector3 result;
      result[direction] = 1;
      return result;
    }

    /** Two unit vectors perpendicular to @p normal; in planar models the first
     * lies in the plane. */
    std::array<Vector3, 2> unit_vectors_across(const Vector3 &normal)
    {
      const unsigned int least = std::abs(normal[2]) < 0.9 ? 2 : 0;
      Vector3 first = dealii::cross_product_3d(unit_vector(least), normal);
      first /= first.norm();
      return {{first, dealii::cross_product_3d(normal, first)}};
    }

    std::vector<Vector3> circle(const double   radius,
                                const Vector3 &first,
                                const Vector3 &second,
                                const Vector3 &centre = Vector3())
    {
      constexpr unsigned int n = 48;
      std::vector<Vector3>   points;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double angle = 2 * dealii::numbers::PI * i / n;
          points.push_back(
            centre +
            radius * (std::cos(angle) * first + std::sin(angle) * second));
        }
      return points;
    }

    /** Subtracts @p level and sets round-off to zero. */
    void subtract(const double level, BernsteinPolynomial &polynomial)
    {
      double scale = std::abs(level);
      for (unsigned int i = 0; i <= polynomial.degree; ++i)
        scale = std::max(scale, std::abs(polynomial.coefficients[i]));
      for (unsigned int i = 0; i <= polynomial.degree; ++i)
        {
          double &value = polynomial.coefficients[i];
          value -= level;
          if (std::abs(value) <= 2 * few_round_offs * scale)
            value = 0;
        }
    }

    class PlaneSurface : public RigidSurface
    {
    public:
      explicit PlaneSurface(const Vector3 &normal) : normal(normal)
      {}

      double distance(const Vector3 &position) const override
      {
        return normal * position;
      }

      SurfaceDistance at(const Vector3 &position) const override
      {
        return {normal * position, normal, {}};
      }

      MeanDistance between(const Vector3 & /*from*/,
                           const Vector3 & /*to*/) const override
      {
        return {normal, {}};
      }

      BernsteinPolynomial level(const ControlPolygon &one,
                                const ControlPolygon &other,
                                const double          distance) const override
      {
        BernsteinPolynomial result;
        result.degree = one.degree;
        for (unsigned int i = 0; i <= one.degree; ++i)
          result.coefficients[i] =
            normal * (one.points[i] + other.points[i]) / 2;
        subtract(distance, result);
        return result;
      }

      Lines outline(const double       size,
                    const unsigned int dimension) const override
      {
        const auto [a, b] = unit_vectors_across(normal);
        const double r    = size / 2;
        if (dimension == 2)
          return {{-r * a, r * a}};
        return {
          {r * (-a - b), r * (a - b), r * (a + b), r * (b - a), r * (-a - b)}};
      }

    private:
      const Vector3 normal;
    };

    /** Ball, or cylinder about an axis. */
    class RoundSurface : public RigidSurface
    {
    public:
      /** @param axis zero vector for a ball */
      RoundSurface(const Vector3 &axis, const double radius)
        : axis(axis)
        , radius(radius)
      {
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            projection[i][j] = (i == j ? 1. : 0.) - axis[i] * axis[j];
      }

      double distance(const Vector3 &position) const override
      {
        return (projection * position).norm() - radius;
      }

      SurfaceDistance at(const Vector3 &position) const override
      {
        const Vector3   r = projection * position;
        const double    l = r.norm();
        SurfaceDistance result{l - radius, r / l, {}};
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result.curvature[i][j] =
              (projection[i][j] - result.normal[i] * result.normal[j]) / l;
        return result;
      }

      MeanDistance between(const Vector3 &from,
                           const Vector3 &to) const override
      {
        // Discrete gradient of a length: (r1^2 - r0^2) / (r0 + r1).
        const Vector3 r0 = projection * from, r1 = projection * to;
        const double  sum = r0.norm() + r1.norm();
        const Vector3 now = r1 / r1.norm();
        MeanDistance  result{(r0 + r1) / sum, {}};
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result.change[i][j] =
              (projection[i][j] - result.direction[i] * now[j]) / sum;
        return result;
      }

      BernsteinPolynomial level(const ControlPolygon &one,
                                const ControlPolygon &other,
                                const double          distance) const override
      {
        BernsteinPolynomial result = product(across(one), across(other));
        // A negative distance from the centre is never reached.
        const double from_centre = radius + distance;
        subtract(from_centre * std::abs(from_centre), result);
        return result;
      }

      Lines outline(const double       size,
                    const unsigned int dimension) const override
      {
        const Vector3 x = unit_vector(0), y = unit_vector(1),
                      z = unit_vector(2);
        if (dimension == 2)
          return {circle(radius, x, y)};
        if (axis.norm_square() == 0)
          return {circle(radius, x, y),
                  circle(radius, y, z),
                  circle(radius, z, x)};
        const auto [a, b]   = unit_vectors_across(axis);
        const Vector3 along = size / 2 * axis;
        Lines         lines = {circle(radius, a, b, along),
                               circle(radius, a, b, -along)};
        for (const Vector3 &side : {a, -a, b, -b})
          lines.push_back({radius * side - along, radius * side + along});
        return lines;
      }

    private:
      ControlPolygon across(const ControlPolygon &curve) const
      {
        ControlPolygon result;
        result.degree = curve.degree;
        for (unsigned int i = 0; i <= curve.degree; ++i)
          result.points[i] = projection * curve.points[i];
        return result;
      }

      const Vector3        axis;
      const double         radius;
      dealii::Tensor<2, 3> projection; ///< onto the plane across the axis
    };
  } // namespace

  std::shared_ptr<const RigidSurface>
  make_plane_surface(const dealii::Tensor<1, 3> &normal)
  {
    return std::make_shared<PlaneSurface>(normal);
  }

  std::shared_ptr<const RigidSurface> make_sphere_surface(const double radius)
  {
    return std::make_shared<RoundSurface>(Vector3(), radius);
  }

  std::shared_ptr<const RigidSurface>
  make_cylinder_surface(const dealii::Tensor<1, 3> &axis, const double radius)
  {
    return std::make_shared<RoundSurface>(axis, radius);
  }

  namespace
  {
    /** A subpatch of the motion of a curve: Bernstein coefficients in the path,
     * each a polynomial along the curve. */
    struct Patch
    {
      using Levels = std::array<BernsteinPolynomial, 3>;

      /** Halves in the order of the path. */
      std::array<Patch, 2> halves_of_path() const
      {
        std::array<Patch, 2> halves = {{*this, *this}};
        const double         middle = (path[0] + path[1]) / 2;
        halves[0].path[1] = halves[1].path[0] = middle;
        for (unsigned int i = 0; i <= levels[0].degree; ++i)
          {
            const double a = levels[0].coefficients[i],
                         b = levels[1].coefficients[i],
                         c = levels[2].coefficients[i], ab = (a + b) / 2,
                         bc = (b + c) / 2, abc = (ab + bc) / 2;
            halves[0].levels[1].coefficients[i] = ab;
            halves[0].levels[2].coefficients[i] = abc;
            halves[1].levels[0].coefficients[i] = abc;
            halves[1].levels[1].coefficients[i] = bc;
          }
        return halves;
      }

      std::array<Patch, 2> halves_of_curve() const
      {
        std::array<Patch, 2> halves = {{*this, *this}};
        const double         middle = (curve[0] + curve[1]) / 2;
        halves[0].curve[1] = halves[1].curve[0] = middle;
        for (unsigned int k = 0; k < levels.size(); ++k)
          {
            const auto level_halves = levels[k].halves();
            for (unsigned int i = 0; i < 2; ++i)
              halves[i].levels[k] = level_halves[i];
          }
        return halves;
      }

      /** Lowest of the corners, where coefficients are values. */
      CurvePassage lowest_corner(double &value) const
      {
        CurvePassage lowest{curve[0], path[0]};
        value = levels[0].coefficients[0];
        for (const unsigned int j : {0, 1})
          for (const unsigned int i : {0, 1})
            if (const double here =
                  levels[2 * j].coefficients[i * levels[0].degree];
                here < value)
              {
                value  = here;
                lowest = {curve[i], path[j]};
              }
        return lowest;
      }

      bool is_nowhere_negative() const
      {
        return std::all_of(levels.begin(),
                           levels.end(),
                           [](const BernsteinPolynomial &level) {
                             return level.is_nowhere_negative();
                           });
      }

      /** Whether the level varies more along the curve than along the path. */
      bool is_steeper_along_curve() const
      {
        double along = 0, across = 0;
        for (unsigned int k = 0; k < levels.size(); ++k)
          for (unsigned int i = 0; i <= levels[k].degree; ++i)
            {
              const double here = levels[k].coefficients[i];
              along =
                std::max(along, std::abs(here - levels[k].coefficients[0]));
              across =
                std::max(across, std::abs(here - levels[0].coefficients[i]));
            }
        return along > across;
      }

      Levels                levels;
      std::array<double, 2> curve = {{0, 1}}, path = {{0, 1}};
    };

    std::optional<CurvePassage> find_negative(const Patch &patch)
    {
      // A smaller remainder is round-off.
      constexpr double smallest = 1e-14;
      if (patch.is_nowhere_negative())
        return {};
      double             value;
      const CurvePassage lowest = patch.lowest_corner(value);
      if (value < 0)
        return lowest;
      if ((patch.curve[1] - patch.curve[0]) * (patch.path[1] - patch.path[0]) <
          smallest)
        return {};
      for (const Patch &half : patch.is_steeper_along_curve()
             ? patch.halves_of_curve()
             : patch.halves_of_path())
        if (const auto found = find_negative(half))
          return found;
      return {};
    }
  } // namespace

  std::vector<double>
  parameters_between_levels(const RigidSurface                &surface,
                            const std::vector<ControlPolygon> &curves,
                            const std::vector<double>         &levels)
  {
    std::vector<double> parameters = {0., 1.};
    for (const ControlPolygon &curve : curves)
      for (const double level : levels)
        surface.level(curve, curve, level).add_sign_changes(parameters);
    std::sort(parameters.begin(), parameters.end());
    return parameters;
  }

  std::optional<CurvePassage> find_passage(const RigidSurface   &surface,
                                           const ControlPolygon &from,
                                           const ControlPolygon &to,
                                           const double          distance)
  {
    Patch whole;
    whole.levels = {{surface.level(from, from, distance),
                     surface.level(from, to, distance),
                     surface.level(to, to, distance)}};
    return find_negative(whole);
  }
} // namespace auxfem
