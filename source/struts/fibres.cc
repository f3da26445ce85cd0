#include <auxfem/struts/fibres.h>
#include <auxfem/struts/shapes/stress_points.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;
    using Shear = std::array<double, 2>;

    /** A layer or a ring: its position and its part of the whole. */
    struct Part
    {
      double position, weight;
    };

    /** Points of Gauss' rule in [-1, 1], weights with the sum 1. */
    std::vector<Part> gauss_parts(const unsigned int n)
    {
      const dealii::QGauss<1> rule(n);
      std::vector<Part>       parts;
      for (unsigned int i = 0; i < n; ++i)
        parts.push_back({2 * rule.point(i)[0] - 1, rule.weight(i)});
      return parts;
    }

    /** Radii of rings over the outer radius, by Gauss' rule in their square, of
     * which area is a linear function. */
    std::vector<Part> rings(const double bore, const unsigned int n)
    {
      std::vector<Part> parts = gauss_parts(n);
      for (Part &part : parts)
        part.position = std::sqrt((1 + bore * bore) / 2 +
                                  (1 - bore * bore) / 2 * part.position);
      return parts;
    }

    /** Scales values at the fibres to a mean square of one. */
    template <class Value>
    void normalize(std::vector<Fibre> &fibres, const Value &value_of)
    {
      double sum = 0;
      for (Fibre &fibre : fibres)
        for (const double value : value_of(fibre))
          sum += fibre.weight * value * value;
      if (sum > 0)
        for (Fibre &fibre : fibres)
          for (double &value : value_of(fibre))
            value /= std::sqrt(sum);
    }

    /** Scales weights and strains so that the moments hold to round-off. */
    std::vector<Fibre> normalized(std::vector<Fibre> fibres)
    {
      double weight = 0;
      for (const Fibre &fibre : fibres)
        weight += fibre.weight;
      for (Fibre &fibre : fibres)
        fibre.weight /= weight;
      struct Span
      {
        double *begin() const
        {
          return value;
        }
        double *end() const
        {
          return value + 1;
        }
        double *value;
      };
      normalize(fibres, [](Fibre &f) { return Span{&f.arm_2}; });
      normalize(fibres, [](Fibre &f) { return Span{&f.arm_3}; });
      normalize(fibres, [](Fibre &f) -> Shear & { return f.shear_2; });
      normalize(fibres, [](Fibre &f) -> Shear & { return f.shear_3; });
      normalize(fibres, [](Fibre &f) -> Shear & { return f.twist; });
      return fibres;
    }

    /** Layer at the height @p y in [-1, 1]. */
    Fibre layer(const double weight, const double y)
    {
      return {weight, 0, -y, {{1 - y * y, 0}}, {}, {}};
    }
  } // namespace

  std::vector<Fibre> plane_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers)
  {
    const unsigned int n = numbers.layers;
    std::vector<Fibre> fibres;
    switch (shape.kind)
      {
        case SectionShape::Kind::circle:
          for (unsigned int i = 1; i <= n; ++i)
            {
              const double angle = i * PI / (n + 1), sine = std::sin(angle);
              fibres.push_back(layer(sine * sine, std::cos(angle)));
            }
          break;
        case SectionShape::Kind::tube:
          for (const Part &ring : rings(shape.ratio, numbers.rings))
            for (unsigned int i = 0; i < n; ++i)
              {
                const double angle = (i + 0.5) * PI / n;
                fibres.push_back({ring.weight,
                                  0,
                                  -ring.position * std::cos(angle),
                                  {{std::sin(angle), 0}},
                                  {},
                                  {}});
              }
          break;
        default:
          for (const Part &part : gauss_parts(n))
            fibres.push_back(layer(part.weight, part.position));
      }
    return normalized(std::move(fibres));
  }

  namespace
  {
    std::vector<Fibre> rectangle_in_space(const double       ratio,
                                          const unsigned int n)
    {
      const double            b     = ratio > 0 ? ratio : 1;
      const std::vector<Part> parts = gauss_parts(n);
      std::vector<Fibre>      fibres;
      for (const Part &along_2 : parts)
        for (const Part &along_3 : parts)
          {
            const double y = along_2.position, z = along_3.position;
            fibres.push_back({along_2.weight * along_3.weight,
                              z,
                              -y,
                              {{1 - y * y, 0}},
                              {{0, 1 - z * z}},
                              twist_of_rectangle(y / 2, z * b / 2, 1, b)});
          }
      return fibres;
    }

    std::vector<Fibre> round_in_space(const SectionShape &shape,
                                      const FibreNumbers &numbers)
    {
      const bool         is_tube = shape.kind == SectionShape::Kind::tube;
      std::vector<Fibre> fibres;
      for (const Part &ring : rings(shape.ratio, numbers.rings))
        for (unsigned int i = 0; i < numbers.angles; ++i)
          {
            const double angle = (i + 0.5) * 2 * PI / numbers.angles;
            const double c = std::cos(angle), s = std::sin(angle);
            const double y = ring.position * c, z = ring.position * s;
            fibres.push_back(
              {ring.weight,
               z,
               -y,
               is_tube ? Shear{{s * s, -s * c}} : Shear{{1 - y * y, 0}},
               is_tube ? Shear{{-s * c, c * c}} : Shear{{0, 1 - z * z}},
               {{-z, y}}});
          }
      return fibres;
    }
  } // namespace

  std::vector<Fibre> space_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers)
  {
    return normalized(shape.kind == SectionShape::Kind::rectangle
                        ? rectangle_in_space(shape.ratio, numbers.grid)
                        : round_in_space(shape, numbers));
  }
} // namespace auxfem
