#include <auxfem/parameters/errors.h>
#include <auxfem/scene/scene_sections.h>
#include <auxfem/scene/scene_space.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

    const Text   section_struts = {"Struts",
                                   "all",
                                   "Set of struts with this section."};
    const Choice shape          = {"Shape",
                                   "",
                                   {"rectangle", "circle", "tube", "given"},
                                   "Shape of the cross-section."};

    const Quantity width = {
      "Width",
      "",
      "m",
      Range::positive(),
      "Side of the rectangle along axis 3, normal to the plane."};
    const Quantity height = {
      "Height",
      "",
      "m",
      Range::positive(),
      "Side of the rectangle along axis 2, in the plane."};
    const Quantity radius         = {"Radius",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Radius of the circle."};
    const Quantity outer_radius   = {"Outer radius",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Outer radius of the tube."};
    const Quantity wall_thickness = {
      "Wall thickness",
      "",
      "m",
      Range::positive(),
      "Thickness of the tube's wall, at most the outer radius."};
    const Quantity area       = {"Area", "", "m2", Range::positive(), "Area."};
    const Quantity shear_area = {
      "Shear area",
      "",
      "m2",
      Range::positive(),
      "Area that carries shear along axis 2, shear correction included."};
    const Quantity shear_area_3 = {
      "Shear area 3",
      "auto",
      "m2",
      Range::positive(),
      "The same along axis 3, unused in the plane; auto: Shear area.",
      {"auto"}};
    const Quantity second_moment = {
      "Second moment of area",
      "",
      "m4",
      Range::positive(),
      "Second moment of area about axis 3, for bending in the plane."};
    const Quantity second_moment_2 = {
      "Second moment of area 2",
      "auto",
      "m4",
      Range::positive(),
      "The same about axis 2, unused in the plane; auto: Second moment of area.",
      {"auto"}};
    const Quantity torsion_of_rectangle = {
      "Torsion constant",
      "auto",
      "m4",
      Range::positive(),
      "Torsion constant J, unused in the plane; auto: Saint-Venant's.",
      {"auto"}};
    const Quantity given_torsion = {
      "Torsion constant",
      "auto",
      "m4",
      Range::positive(),
      "Torsion constant J, unused in the plane; auto: sum of the second moments of area.",
      {"auto"}};
    const QuantityList given_rotary_inertia = {
      "Rotary inertia",
      "auto",
      "kg m",
      Range::non_negative(),
      3,
      3,
      "Rotary inertia per length about axes 1, 2 and 3, of which the plane uses the last; auto: density times the second moments of area, about axis 1 their sum.",
      {"auto"}};
    const QuantityList reference = {
      "Reference vector",
      "auto",
      "1",
      Range::any(),
      3,
      3,
      "Vector x, y, z that axis 3 is as near to as can be, at rest; it may not lie along a strut; unused in the plane; auto: z, or x for struts within 5 degrees of z.",
      {"auto"}};
    const Quantity drawing_radius = {
      "Drawing radius",
      "auto",
      "m",
      Range::positive(),
      "Radius of the tube drawn in ParaView; auto: half the height of the "
      "rectangle of equal area and second moment.",
      {"auto"}};
    const Quantity shear_correction = {
      "Shear correction",
      "auto",
      "1",
      {0, 1, true, false},
      "Shear area over area; auto: 5/6 for a rectangle, 0.9 for a circle, 0.5 "
      "for a tube.",
      {"auto"}};

    const Quantity youngs_modulus = {"Young's modulus",
                                     "",
                                     "Pa",
                                     Range::positive(),
                                     "Young's modulus."};
    const Quantity poissons_ratio = {"Poisson's ratio",
                                     "0.3",
                                     "1",
                                     {-1, 0.5, true, false},
                                     "Poisson's ratio, for the shear modulus."};
    const Quantity density        = {
             "Density",
             "none",
             "kg/m3",
             Range::non_negative(),
             "Mass per volume; none will do for statics without weight only.",
             {"none"}};
    const Quantity stiffness_damping = {
      "Stiffness-proportional damping",
      "0 s",
      "s",
      Range::non_negative(),
      "Time b of the damping stress = E b strain rate."};
    const Quantity mass_damping = {
      "Mass-proportional damping",
      "0 1/s",
      "1/s",
      Range::non_negative(),
      "Rate a of the damping force = a mass velocity."};

    void declare_common(dealii::ParameterHandler &prm)
    {
      declare(prm, section_struts);
      declare(prm, shape);
      declare(prm, youngs_modulus);
      declare(prm, poissons_ratio);
      declare(prm, density);
      declare(prm, reference);
      declare(prm, stiffness_damping);
      declare(prm, mass_damping);
    }

    void declare_rectangle(dealii::ParameterHandler &prm)
    {
      declare(prm, width);
      declare(prm, height);
      declare(prm, shear_correction);
      declare(prm, torsion_of_rectangle);
    }

    void declare_circle(dealii::ParameterHandler &prm)
    {
      declare(prm, radius);
      declare(prm, shear_correction);
    }

    void declare_tube(dealii::ParameterHandler &prm)
    {
      declare(prm, outer_radius);
      declare(prm, wall_thickness);
      declare(prm, shear_correction);
    }

    void declare_given(dealii::ParameterHandler &prm)
    {
      declare(prm, area);
      declare(prm, shear_area);
      declare(prm, shear_area_3);
      declare(prm, second_moment);
      declare(prm, second_moment_2);
      declare(prm, given_torsion);
      declare(prm, given_rotary_inertia);
      declare(prm, drawing_radius);
    }

    /** The number in @p entry; @p automatic in place of `auto`. */
    double value_or(dealii::ParameterHandler &prm,
                    const Quantity           &entry,
                    const double              automatic)
    {
      return is_word(prm, entry) ? automatic : get(prm, entry);
    }

    void set_shear_areas(dealii::ParameterHandler &prm,
                         const double              automatic,
                         Section                  &section)
    {
      section.shear_area_2 = section.shear_area_3 =
        section.area * value_or(prm, shear_correction, automatic);
    }

    /**
     * Saint-Venant's torsion constant of a rectangle with longer side @p b and
     * shorter side @p t (m4), exact to round-off: Timoshenko and Goodier,
     * Theory of Elasticity, section 109,
     * J = b t^3 / 3 (1 - 192/pi^5 t/b sum tanh(n pi b / (2 t)) / n^5)
     * over odd n.
     */
    double torsion_constant_of_rectangle(const double b, const double t)
    {
      // Summed as one minus tanh, of which ten terms reach round-off, since
      // exp(-21 pi) < 1e-28; the ones sum to 31/32 zeta(5).
      double sum = 31. / 32. * 1.0369277551433699263;
      for (unsigned int n = 1; n < 20; n += 2)
        sum -= 2 / ((std::exp(n * PI * b / t) + 1) * std::pow(n, 5));
      return b * t * t * t / 3 * (1 - 192 / std::pow(PI, 5) * t / b * sum);
    }

    /** A section that is the same about every axis across the strut. */
    void set_round(const double second_moment, Section &section)
    {
      section.second_moment_2  = second_moment;
      section.second_moment_3  = second_moment;
      section.torsion_constant = 2 * second_moment;
    }

    void read_rectangle(dealii::ParameterHandler &prm, Section &section)
    {
      const double b = get(prm, width), h = get(prm, height);
      section.area            = b * h;
      section.second_moment_2 = h * b * b * b / 12;
      section.second_moment_3 = b * h * h * h / 12;
      section.torsion_constant =
        value_or(prm,
                 torsion_of_rectangle,
                 torsion_constant_of_rectangle(std::max(b, h), std::min(b, h)));
      section.radius          = h / 2;
      section.fibre_distances = {{b / 2, h / 2}};
      set_shear_areas(prm, 5. / 6., section);
    }

    void read_circle(dealii::ParameterHandler &prm, Section &section)
    {
      const double r          = get(prm, radius);
      section.area            = PI * r * r;
      section.radius          = r;
      section.fibre_distances = {{r, r}};
      set_round(PI / 4 * r * r * r * r, section);
      set_shear_areas(prm, 0.9, section);
    }

    void read_tube(dealii::ParameterHandler &prm,
                   const std::string        &path,
                   Section                  &section)
    {
      const double outer = get(prm, outer_radius);
      const double inner = outer - get(prm, wall_thickness);
      if (inner < 0)
        throw InputError(
          path + ": Wall thickness = " + prm.get(wall_thickness.name) +
          " is more than Outer radius = " + prm.get(outer_radius.name) +
          "; reduce it, or set Shape = circle for a solid rod");
      section.area            = PI * (outer * outer - inner * inner);
      section.radius          = outer;
      section.fibre_distances = {{outer, outer}};
      set_round(PI / 4 * (std::pow(outer, 4) - std::pow(inner, 4)), section);
      set_shear_areas(prm, 0.5, section);
    }

    void read_given(dealii::ParameterHandler &prm, Section &section)
    {
      section.area         = get(prm, area);
      section.shear_area_2 = get(prm, shear_area);
      section.shear_area_3 = value_or(prm, shear_area_3, section.shear_area_2);
      section.second_moment_3 = get(prm, second_moment);
      section.second_moment_2 =
        value_or(prm, second_moment_2, section.second_moment_3);
      section.torsion_constant =
        value_or(prm,
                 given_torsion,
                 section.second_moment_2 + section.second_moment_3);
      section.radius =
        value_or(prm,
                 drawing_radius,
                 std::sqrt(3 * section.second_moment_3 / section.area));
      if (!is_word(prm, given_rotary_inertia))
        {
          const std::vector<double> values = get(prm, given_rotary_inertia);
          section.given_rotary_inertia = {{values[0], values[1], values[2]}};
        }
    }

    void read_material(dealii::ParameterHandler &prm, Section &section)
    {
      section.youngs_modulus = get(prm, youngs_modulus);
      section.shear_modulus =
        section.youngs_modulus / (2 * (1 + get(prm, poissons_ratio)));
      section.stiffness_proportional_damping = get(prm, stiffness_damping);
      section.mass_proportional_damping      = get(prm, mass_damping);
    }

    void read_section(dealii::ParameterHandler &prm,
                      const std::string        &name,
                      const SceneContext       &context,
                      Scene                    &scene)
    {
      SectionDefinition definition;
      definition.name              = name;
      definition.path              = context.path;
      definition.struts            = get(prm, section_struts);
      const std::string shape_name = get(prm, shape);
      if (shape_name == "rectangle")
        read_rectangle(prm, definition.section);
      else if (shape_name == "circle")
        read_circle(prm, definition.section);
      else if (shape_name == "tube")
        read_tube(prm, context.path, definition.section);
      else
        read_given(prm, definition.section);
      read_material(prm, definition.section);
      if (!is_word(prm, reference))
        definition.section.reference =
          read_unit_vector(prm, reference, context);
      definition.has_density = !is_word(prm, density);
      if (definition.has_density)
        definition.section.density = get(prm, density);
      scene.sections.push_back(definition);
    }
  } // namespace



  SubsectionKind sections_kind()
  {
    return {"Sections",
            SubsectionKind::Form::named_groups,
            "Cross-sections and materials; of several for one strut the last "
            "counts. Axis 1 of a section is along the strut; in the plane axis "
            "2 lies in it and axis 3 is its normal, in space see Reference "
            "vector.",
            declare_common,
            "Shape",
            {{"rectangle", "Solid rectangle.", declare_rectangle},
             {"circle", "Solid circle.", declare_circle},
             {"tube", "Circular tube.", declare_tube},
             {"given", "Area and moments as numbers.", declare_given}},
            read_section};
  }
} // namespace auxfem
