#include <auxfem/mesh/cells/cell_drawing.h>
#include <auxfem/mesh/cells/cell_table.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <vector>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

    const Quantity ligament_length{"Ligament length",
                                   "10 mm",
                                   "m",
                                   Range::positive(),
                                   "Length L of the ligaments between rings."};
    const Quantity ring_radius{"Ring radius",
                               "2 mm",
                               "m",
                               Range::positive(),
                               "Radius r of the rings."};

    /** Joints of a ring at angles @p start + 2 pi k / n, joined by arcs. */
    std::vector<unsigned int> draw_ring(const dealii::Point<3> &centre,
                                        const double            radius,
                                        const unsigned int      n,
                                        const double            start,
                                        CellDrawing            &drawing)
    {
      std::vector<unsigned int> ring;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double angle = start + 2 * PI * k / n;
          ring.push_back(drawing.joint(centre[0] + radius * std::cos(angle),
                                       centre[1] + radius * std::sin(angle)));
        }
      // Counter-clockwise, arcs rise to the right.
      const double rise = radius * (1 - std::cos(PI / n));
      for (unsigned int k = 0; k < n; ++k)
        drawing.strut(ring[k], ring[(k + 1) % n], "rings", -rise);
      return ring;
    }

    /**
     * Rings of radius r at the distance R = sqrt(L^2 + 4 r^2), joined by
     * ligaments tangential to both. The ligament in the direction psi leaves
     * its ring at psi + pi/2 - beta with tan(beta) = 2 r / L and arrives at
     * psi - pi/2 - beta.
     */
    struct ChiralShape
    {
      ChiralShape(const ParameterValues &values, const unsigned int n)
        : radius(values[ring_radius])
        , n(n)
        , distance(std::hypot(values[ligament_length], 2 * radius))
        , start(PI / 2 - std::atan(2 * radius / values[ligament_length]))
      {}

      std::vector<unsigned int>
      draw(const double x, const double y, CellDrawing &drawing) const
      {
        return draw_ring(dealii::Point<3>(x, y, 0), radius, n, start, drawing);
      }

      /** Adds the ligament in the direction 2 pi k / n from @p ring to @p other
       * of the cell @p shift. */
      void connect(const unsigned int               k,
                   const std::vector<unsigned int> &ring,
                   const std::vector<unsigned int> &other,
                   const std::array<int, 3>        &shift,
                   CellDrawing                     &drawing) const
      {
        const unsigned int from = ring[k], to = other[(k + n / 2) % n];
        if (shift == std::array<int, 3>{{0, 0, 0}})
          drawing.strut(from, to, "ligaments");
        else
          drawing.strut_across(from, to, shift, "ligaments");
      }

      const double       radius;
      const unsigned int n;
      const double       distance; ///< of ring centres (m)
      const double       start;    ///< angle of the first joint (rad)
    };

    std::unique_ptr<Cell> make_tetrachiral(ParameterValues &values)
    {
      const ChiralShape shape(values, 4);
      CellDrawing       drawing(shape.distance);
      const auto        ring = shape.draw(0, 0, drawing);
      shape.connect(0, ring, ring, {{1, 0, 0}}, drawing);
      shape.connect(1, ring, ring, {{0, 1, 0}}, drawing);
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(shape.distance, shape.distance, 0)));
    }

    std::unique_ptr<Cell> make_hexachiral(ParameterValues &values)
    {
      const ChiralShape shape(values, 6);
      const double      R = shape.distance, h = std::sqrt(3.) / 2 * R;
      CellDrawing       drawing(R);
      const auto        low = shape.draw(0, 0, drawing),
                 high       = shape.draw(R / 2, h, drawing);
      for (const auto &ring : {low, high})
        shape.connect(0, ring, ring, {{1, 0, 0}}, drawing);
      shape.connect(1, low, high, {{0, 0, 0}}, drawing);
      shape.connect(2, low, high, {{-1, 0, 0}}, drawing);
      shape.connect(1, high, low, {{1, 1, 0}}, drawing);
      shape.connect(2, high, low, {{0, 1, 0}}, drawing);
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(R, 2 * h, 0)));
    }

    const Quantity ring_distance{"Ring distance",
                                 "10 mm",
                                 "m",
                                 Range::positive(),
                                 "Distance L of the rings' centres, and length "
                                 "of the ligaments."};

    /** Four rings; ligaments along the axes join their tops, bottoms, left and
     * right ends, so that neighbours turn in opposite senses. */
    std::unique_ptr<Cell> make_anti_tetrachiral(ParameterValues &values)
    {
      const double L = values[ring_distance], r = values[ring_radius];
      if (!(2 * r < L))
        values.refuse(ring_radius,
                      "the rings overlap. Give less than half of Ring "
                      "distance = " +
                        values.text(ring_distance));
      CellDrawing drawing(L);
      enum Side
      {
        right,
        top,
        left,
        bottom
      };
      const auto ring = [&](const double x, const double y) {
        return draw_ring(dealii::Point<3>(x, y, 0), r, 4, 0, drawing);
      };
      const std::vector<std::vector<unsigned int>> rings = {ring(0, 0),
                                                            ring(L, 0),
                                                            ring(L, L),
                                                            ring(0, L)};
      const auto at = [&](const unsigned int i, const Side side) {
        return rings[i][side];
      };
      drawing.strut(at(0, top), at(1, top), "ligaments");
      drawing.strut(at(3, bottom), at(2, bottom), "ligaments");
      drawing.strut(at(0, left), at(3, left), "ligaments");
      drawing.strut(at(1, right), at(2, right), "ligaments");
      drawing.strut_across(at(1, bottom),
                           at(0, bottom),
                           {{1, 0, 0}},
                           "ligaments");
      drawing.strut_across(at(2, top), at(3, top), {{1, 0, 0}}, "ligaments");
      drawing.strut_across(at(3, right),
                           at(0, right),
                           {{0, 1, 0}},
                           "ligaments");
      drawing.strut_across(at(2, left), at(1, left), {{0, 1, 0}}, "ligaments");
      return std::make_unique<PrebuiltCell>(
        drawing.repeated(dealii::Point<3>(2 * L, 2 * L, 0)));
    }
  } // namespace

  RegistryEntry<Cell> tetrachiral_cell_entry()
  {
    return {"tetrachiral",
            "Rings with four tangential ligaments.",
            {ligament_length, ring_radius},
            make_tetrachiral};
  }

  RegistryEntry<Cell> hexachiral_cell_entry()
  {
    return {"hexachiral",
            "Rings with six tangential ligaments, two rows of them; auxetic.",
            {ligament_length, ring_radius},
            make_hexachiral};
  }

  RegistryEntry<Cell> anti_tetrachiral_cell_entry()
  {
    return {"anti-tetrachiral",
            "Four rings with ligaments along the axes, of which neighbours "
            "turn in opposite senses; auxetic.",
            {ring_distance, ring_radius},
            make_anti_tetrachiral};
  }
} // namespace auxfem
