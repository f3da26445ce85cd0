#include <auxfem/struts/shapes/shape_table.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    const QuantityList polygon_corners = {
      "Corners",
      "",
      "m",
      Range::any(),
      6,
      1000,
      "Coordinates of the corners along axes 2 and 3, in turn, around the "
      "section from any origin: y1, z1, y2, z2, ..."};

    /** Length of sides over the extent of the section, below which both ends
     * are the same corner. */
    constexpr double least_side = 1e-6;

    /** The corners at both ends of a side, counted from 1. */
    std::string side_text(const unsigned int side, const unsigned int n)
    {
      return std::to_string(side + 1) + " - " +
        std::to_string((side + 1) % n + 1);
    }

    Outline read_corners(const ParameterValues &values)
    {
      const std::vector<double> numbers = values[polygon_corners];
      if (numbers.size() % 2 == 1)
        values.refuse(polygon_corners,
                      "there are " + std::to_string(numbers.size()) +
                        " numbers. Each corner needs two: y1, z1, y2, z2, ...");
      Outline outline;
      for (std::size_t i = 0; i < numbers.size(); i += 2)
        outline.emplace_back(numbers[i], numbers[i + 1]);
      double extent = 0;
      for (const dealii::Point<2> &corner : outline)
        extent = std::max(extent, corner.distance(outline.front()));
      for (std::size_t i = 0; i < outline.size(); ++i)
        if (outline[i].distance(outline[(i + 1) % outline.size()]) <=
            least_side * extent)
          values.refuse(polygon_corners,
                        "corners " + side_text(i, outline.size()) +
                          " are the same. Give each corner once; the last side "
                          "closes the polygon by itself");
      return outline;
    }

    std::unique_ptr<CrossSection> make_polygon(ParameterValues &values)
    {
      Outline outline = read_corners(values);
      if (const auto sides = crossing_sides(outline))
        values.refuse(polygon_corners,
                      "the sides between corners " +
                        side_text(sides->first, outline.size()) + " and " +
                        side_text(sides->second, outline.size()) +
                        " cross or touch. Give the corners in order around the "
                        "section");
      if (signed_area(outline) < 0)
        std::reverse(outline.begin(), outline.end());
      return section_of_outline(values, outline);
    }
  } // namespace

  RegistryEntry<CrossSection> polygon_entry()
  {
    return {"polygon",
            "Solid polygon.",
            {polygon_corners, torsion_constant_parameter()},
            make_polygon};
  }
} // namespace auxfem
