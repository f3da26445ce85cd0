#include <auxfem/struts/shapes/shape_table.h>

#include <deal.II/base/numbers.h>

namespace auxfem
{
  namespace
  {
    const Quantity circle_radius = {"Radius",
                                    "",
                                    "m",
                                    Range::positive(),
                                    "Radius of the circle."};

    std::unique_ptr<CrossSection> make_circle(ParameterValues &values)
    {
      using dealii::numbers::PI;
      const double r = values[circle_radius];
      CrossSection section;
      section.area               = PI * r * r;
      section.radius             = r;
      section.shape.kind         = SectionShape::Kind::circle;
      section.half_thicknesses   = {{r, r}};
      section.outer_fibres       = fibres_at(section.half_thicknesses);
      section.make_stress_points = [r](unsigned int) {
        return tube_stress_points(r, 0);
      };
      set_axisymmetric_moments(PI / 4 * r * r * r * r, section);
      set_shear_areas(values, 0.9, section);
      return std::make_unique<CrossSection>(section);
    }
  } // namespace

  RegistryEntry<CrossSection> circle_entry()
  {
    return {"circle",
            "Solid circle.",
            {circle_radius, shear_correction_parameter()},
            make_circle};
  }
} // namespace auxfem
