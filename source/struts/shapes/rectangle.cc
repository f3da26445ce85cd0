#include <auxfem/struts/shapes/shape_table.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    const Quantity rectangle_width = {
      "Width",
      "",
      "m",
      Range::positive(),
      "Side along axis 3, normal to the plane."};
    const Quantity rectangle_height = {"Height",
                                       "",
                                       "m",
                                       Range::positive(),
                                       "Side along axis 2, in the plane."};
    /**
     * Saint-Venant's torsion constant of a rectangle with longer side @p b and
     * shorter side @p t (m4), exact to round-off (Timoshenko and Goodier,
     * Theory of Elasticity, section 109):
     * J = b t^3 / 3 (1 - 192/pi^5 t/b sum tanh(n pi b / (2 t)) / n^5) over odd
     * n.
     */
    double torsion_constant_of_rectangle(const double b, const double t)
    {
      using dealii::numbers::PI;
      // The sum of 1 - tanh converges in ten terms, since exp(-21 pi) < 1e-28;
      // the ones sum to 31/32 zeta(5).
      double sum = 31. / 32. * 1.0369277551433699263;
      for (unsigned int n = 1; n < 20; n += 2)
        sum -= 2 / ((std::exp(n * PI * b / t) + 1) * std::pow(n, 5));
      return b * t * t * t / 3 * (1 - 192 / std::pow(PI, 5) * t / b * sum);
    }

    std::unique_ptr<CrossSection> make_rectangle(ParameterValues &values)
    {
      const double b = values[rectangle_width], h = values[rectangle_height];
      CrossSection section;
      section.area            = b * h;
      section.second_moment_2 = h * b * b * b / 12;
      section.second_moment_3 = b * h * h * h / 12;
      section.torsion_constant =
        values.value_or(torsion_constant_parameter(),
                        torsion_constant_of_rectangle(std::max(b, h),
                                                      std::min(b, h)));
      section.radius             = h / 2;
      section.shape              = {SectionShape::Kind::rectangle, b / h};
      section.half_thicknesses   = {{b / 2, h / 2}};
      section.outer_fibres       = fibres_at(section.half_thicknesses);
      section.make_stress_points = [b, h](const unsigned int dimension) {
        return rectangle_stress_points(h, b, dimension);
      };
      set_shear_areas(values, 5. / 6., section);
      return std::make_unique<CrossSection>(section);
    }
  } // namespace

  RegistryEntry<CrossSection> rectangle_entry()
  {
    return {"rectangle",
            "Solid rectangle.",
            {rectangle_width,
             rectangle_height,
             shear_correction_parameter(),
             torsion_constant_parameter()},
            make_rectangle};
  }
} // namespace auxfem
