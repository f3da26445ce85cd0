#include <auxfem/struts/fibres.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

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

    /** Scales arms and weights so that the moments hold to round-off. */
    std::vector<Fibre> normalized(std::vector<Fibre> fibres)
    {
      double weight = 0, moment_2 = 0, moment_3 = 0;
      for (const Fibre &fibre : fibres)
        weight += fibre.weight;
      for (Fibre &fibre : fibres)
        {
          fibre.weight /= weight;
          moment_2 += fibre.weight * fibre.arm_2 * fibre.arm_2;
          moment_3 += fibre.weight * fibre.arm_3 * fibre.arm_3;
        }
      for (Fibre &fibre : fibres)
        {
          if (moment_2 > 0)
            fibre.arm_2 /= std::sqrt(moment_2);
          fibre.arm_3 /= std::sqrt(moment_3);
        }
      return fibres;
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
              fibres.push_back({sine * sine, 0, std::cos(angle)});
            }
          break;
        case SectionShape::Kind::tube:
          for (const Part &ring : rings(shape.bore, numbers.rings))
            for (unsigned int i = 0; i < n; ++i)
              fibres.push_back(
                {ring.weight, 0, ring.position * std::cos((i + 0.5) * PI / n)});
          break;
        default:
          for (const Part &layer : gauss_parts(n))
            fibres.push_back({layer.weight, 0, layer.position});
      }
    return normalized(std::move(fibres));
  }

  std::vector<Fibre> space_fibres(const SectionShape &shape,
                                  const FibreNumbers &numbers)
  {
    std::vector<Fibre> fibres;
    if (shape.kind == SectionShape::Kind::rectangle)
      {
        const std::vector<Part> parts = gauss_parts(numbers.grid);
        for (const Part &across : parts)
          for (const Part &along : parts)
            fibres.push_back(
              {across.weight * along.weight, along.position, across.position});
      }
    else
      for (const Part &ring : rings(shape.bore, numbers.rings))
        for (unsigned int i = 0; i < numbers.angles; ++i)
          {
            const double angle = (i + 0.5) * 2 * PI / numbers.angles;
            fibres.push_back({ring.weight,
                              ring.position * std::sin(angle),
                              ring.position * std::cos(angle)});
          }
    return normalized(std::move(fibres));
  }
} // namespace auxfem
