#include <auxfem/struts/shapes/outline.h>
#include <auxfem/struts/shapes/shape_table.h>

namespace auxfem
{
  namespace
  {
    const Quantity box_width   = {"Width",
                                  "",
                                  "m",
                                  Range::positive(),
                                  "Outer side along axis 3, normal to the "
                                    "plane."};
    const Quantity box_height  = {"Height",
                                  "",
                                  "m",
                                  Range::positive(),
                                  "Outer side along axis 2, in the plane."};
    const Quantity box_wall    = {"Wall thickness",
                                  "",
                                  "m",
                                  Range::positive(),
                                  "Thickness of the walls along axis 2, less "
                                     "than half the width."};
    const Quantity box_flanges = {"Flange thickness",
                                  "auto",
                                  "m",
                                  Range::positive(),
                                  "Thickness of the walls along axis 3, less "
                                  "than half the height; auto: Wall "
                                  "thickness.",
                                  {"auto"}};

    std::unique_ptr<CrossSection> make_box(ParameterValues &values)
    {
      const double h = values[box_height], b = values[box_width],
                   t_w = values[box_wall],
                   t_f = values.value_or(box_flanges, t_w);
      if (2 * t_w >= b)
        values.refuse(box_wall,
                      "the walls fill the box, which is " +
                        values.text(box_width) +
                        " wide. Give less than half the Width, or set Shape = "
                        "rectangle");
      if (2 * t_f >= h)
        values.refuse(values.is_word(box_flanges) ? box_wall : box_flanges,
                      "the walls fill the box, which is " +
                        values.text(box_height) +
                        " high. Give less than half the Height, or set Shape = "
                        "rectangle");
      return section_of_outline(values,
                                {{0, 0},
                                 {h, 0},
                                 {h, b},
                                 {0, b},
                                 {0, 0},
                                 {t_f, t_w},
                                 {t_f, b - t_w},
                                 {h - t_f, b - t_w},
                                 {h - t_f, t_w},
                                 {t_f, t_w}});
    }
  } // namespace

  RegistryEntry<CrossSection> box_entry()
  {
    return {"box",
            "Rectangular tube.",
            {box_width,
             box_height,
             box_wall,
             box_flanges,
             torsion_constant_parameter()},
            make_box};
  }
} // namespace auxfem
