#include <auxfem/struts/shapes/shape_table.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity outer_radius   = {"Outer radius",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Outer radius of the tube."};
    const Quantity tube_thickness = {
      "Wall thickness",
      "",
      "m",
      Range::positive(),
      "Thickness of the tube's wall, at most the outer radius."};

    std::unique_ptr<CrossSection> make_tube(ParameterValues &values)
    {
      using dealii::numbers::PI;
      const double outer = values[outer_radius];
      const double inner = outer - values[tube_thickness];
      if (inner < 0)
        values.refuse(
          "Wall thickness = " + values.text(tube_thickness) +
          " is more than Outer radius = " + values.text(outer_radius) +
          "; reduce it, or set Shape = circle for a solid rod");
      CrossSection section;
      section.area               = PI * (outer * outer - inner * inner);
      section.radius             = outer;
      section.shape              = {SectionShape::Kind::tube, inner / outer};
      section.half_thicknesses   = {{outer, outer}};
      section.outer_fibres       = fibres_at(section.half_thicknesses);
      section.make_stress_points = [outer, inner](unsigned int) {
        return tube_stress_points(outer, inner);
      };
      set_axisymmetric_moments(PI / 4 *
                                 (std::pow(outer, 4) - std::pow(inner, 4)),
                               section);
      set_shear_areas(values, 0.5, section);
      return std::make_unique<CrossSection>(section);
    }
  } // namespace

  RegistryEntry<CrossSection> tube_entry()
  {
    return {"tube",
            "Circular tube.",
            {outer_radius, tube_thickness, shear_correction_parameter()},
            make_tube};
  }
} // namespace auxfem
