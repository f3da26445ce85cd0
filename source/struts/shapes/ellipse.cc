#include <auxfem/struts/shapes/shape_table.h>

#include <deal.II/base/numbers.h>

namespace auxfem
{
  namespace
  {
    const Quantity ellipse_width  = {"Width",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Diameter along axis 3, normal to the "
                                      "plane."};
    const Quantity ellipse_height = {"Height",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Diameter along axis 2, in the plane."};

    /** Shear area over area of an ellipse with half diameter @p a along the
     * force and @p b across, by the exact solution at Poisson's ratio 0 (see
     * solve_saint_venant()): stress function f = (A - B y^2 - C z^2) y. */
    double shear_part_of_ellipse(const double a, const double b)
    {
      return 3 * (3 * a * a + b * b) / (10 * a * a + 4 * b * b);
    }

    std::unique_ptr<CrossSection> make_ellipse(ParameterValues &values)
    {
      using dealii::numbers::PI;
      const double a = values[ellipse_height] / 2,
                   b = values[ellipse_width] / 2;
      CrossSection section;
      section.area            = PI * a * b;
      section.second_moment_2 = PI / 4 * a * b * b * b;
      section.second_moment_3 = PI / 4 * a * a * a * b;
      section.torsion_constant =
        values.value_or(torsion_constant_parameter(),
                        PI * a * a * a * b * b * b / (a * a + b * b));
      section.shear_area_2       = section.area * shear_part_of_ellipse(a, b);
      section.shear_area_3       = section.area * shear_part_of_ellipse(b, a);
      section.radius             = a;
      section.half_thicknesses   = {{b, a}};
      section.outer_fibres       = fibres_at(section.half_thicknesses);
      section.make_stress_points = [a, b](unsigned int) {
        return ellipse_stress_points(2 * a, 2 * b);
      };
      return std::make_unique<CrossSection>(section);
    }
  } // namespace

  RegistryEntry<CrossSection> ellipse_entry()
  {
    return {"ellipse",
            "Solid ellipse.",
            {ellipse_width, ellipse_height, torsion_constant_parameter()},
            make_ellipse};
  }
} // namespace auxfem
