#include <auxfem/struts/section.h>

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
    const Choice section_shape  = {"Shape",
                                   "",
                                   {"rectangle", "circle", "tube", "given"},
                                   "Shape of the cross-section."};

    const Quantity width          = {"Width",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Side along axis 3, normal to the plane."};
    const Quantity height         = {"Height",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Side along axis 2, in the plane."};
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
    const Quantity extreme_fibre = {
      "Extreme fibre",
      "none",
      "m",
      Range::positive(),
      "Distance of the outermost fibre from axis 3, for bending strains in the "
      "plane; none: unknown, Yield strain is checked at the radius of gyration.",
      {"none"}};
    const Quantity extreme_fibre_2 = {
      "Extreme fibre 2",
      "auto",
      "m",
      Range::positive(),
      "The same from axis 2, unused in the plane; auto: Extreme fibre.",
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
      "Rotary inertia per length about axes 1, 2 and 3; the plane uses the last; auto: density times the second moments of area, for axis 1 their sum.",
      {"auto"}};
    const QuantityList reference = {
      "Reference vector",
      "auto",
      "1",
      Range::any(),
      3,
      3,
      "Vector x, y, z whose projection normal to the strut gives axis 3 at rest; not parallel to a strut; unused in the plane; auto: z, or x for struts within 5 degrees of z.",
      {"auto"}};
    const Quantity drawing_radius = {
      "Drawing radius",
      "auto",
      "m",
      Range::positive(),
      "Radius of the tube drawn in ParaView; auto: half the height of a "
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

    const Text section_material = {
      "Material",
      "none",
      "Name in Materials; none: the section gives the constants of a linear "
      "elastic material itself."};

    void set_shear_areas(const ParameterValues &values,
                         const double           automatic,
                         Section               &section)
    {
      section.shear_area_2 = section.shear_area_3 =
        section.area * values.value_or(shear_correction, automatic);
    }

    /**
     * Saint-Venant's torsion constant of a rectangle with longer side @p b and
     * shorter side @p t (m4), exact to round-off (Timoshenko and Goodier,
     * Theory of Elasticity, section 109):
     * J = b t^3 / 3 (1 - 192/pi^5 t/b sum tanh(n pi b / (2 t)) / n^5) over odd
     * n.
     */
    double torsion_constant_of_rectangle(const double b, const double t)
    {
      // The sum of 1 - tanh converges in ten terms, since exp(-21 pi) < 1e-28;
      // the ones sum to 31/32 zeta(5).
      double sum = 31. / 32. * 1.0369277551433699263;
      for (unsigned int n = 1; n < 20; n += 2)
        sum -= 2 / ((std::exp(n * PI * b / t) + 1) * std::pow(n, 5));
      return b * t * t * t / 3 * (1 - 192 / std::pow(PI, 5) * t / b * sum);
    }

    /** Sets the moments of a section that is the same about every transverse
     * axis. */
    void set_axisymmetric_moments(const double second_moment, Section &section)
    {
      section.second_moment_2  = second_moment;
      section.second_moment_3  = second_moment;
      section.torsion_constant = 2 * second_moment;
    }

    void read_rectangle(const ParameterValues &values, Section &section)
    {
      const double b = values[width], h = values[height];
      section.area            = b * h;
      section.second_moment_2 = h * b * b * b / 12;
      section.second_moment_3 = b * h * h * h / 12;
      section.torsion_constant =
        values.value_or(torsion_of_rectangle,
                        torsion_constant_of_rectangle(std::max(b, h),
                                                      std::min(b, h)));
      section.radius          = h / 2;
      section.shape           = {SectionShape::Kind::rectangle, b / h};
      section.fibre_distances = section.half_thicknesses = {{b / 2, h / 2}};
      set_shear_areas(values, 5. / 6., section);
    }

    void read_circle(const ParameterValues &values, Section &section)
    {
      const double r          = values[radius];
      section.area            = PI * r * r;
      section.radius          = r;
      section.shape.kind      = SectionShape::Kind::circle;
      section.fibre_distances = section.half_thicknesses = {{r, r}};
      set_axisymmetric_moments(PI / 4 * r * r * r * r, section);
      set_shear_areas(values, 0.9, section);
    }

    void read_tube(const ParameterValues &values, Section &section)
    {
      const double outer = values[outer_radius];
      const double inner = outer - values[wall_thickness];
      if (inner < 0)
        values.refuse(
          "Wall thickness = " + values.text(wall_thickness) +
          " is more than Outer radius = " + values.text(outer_radius) +
          "; reduce it, or set Shape = circle for a solid rod");
      section.area            = PI * (outer * outer - inner * inner);
      section.radius          = outer;
      section.shape           = {SectionShape::Kind::tube, inner / outer};
      section.fibre_distances = section.half_thicknesses = {{outer, outer}};
      set_axisymmetric_moments(PI / 4 *
                                 (std::pow(outer, 4) - std::pow(inner, 4)),
                               section);
      set_shear_areas(values, 0.5, section);
    }

    void read_given(const ParameterValues &values, Section &section)
    {
      section.area         = values[area];
      section.shear_area_2 = values[shear_area];
      section.shear_area_3 =
        values.value_or(shear_area_3, section.shear_area_2);
      section.second_moment_3 = values[second_moment];
      section.second_moment_2 =
        values.value_or(second_moment_2, section.second_moment_3);
      section.torsion_constant =
        values.value_or(given_torsion,
                        section.second_moment_2 + section.second_moment_3);
      section.radius =
        values.value_or(drawing_radius,
                        std::sqrt(3 * section.second_moment_3 / section.area));
      if (!values.is_word(extreme_fibre))
        section.fibre_distances = {
          {values.value_or(extreme_fibre_2, values[extreme_fibre]),
           values[extreme_fibre]}};
      else if (!values.is_word(extreme_fibre_2))
        values.refuse(extreme_fibre_2,
                      "Extreme fibre is none. Give both distances, or neither");
      if (!values.is_word(given_rotary_inertia))
        {
          const std::vector<double> moments = values[given_rotary_inertia];
          section.given_rotary_inertia = {{moments[0], moments[1], moments[2]}};
        }
    }

    MaterialDefinition
    material_of(const ParameterValues                 &values,
                const std::vector<MaterialDefinition> &materials)
    {
      const std::string name = values[section_material];
      if (name == "none")
        return read_material_constants(
          values,
          read_youngs_modulus(values,
                              "Set it, or name a material: Material = NAME"));
      const MaterialDefinition *material = find_by_name(materials, name);
      if (material == nullptr)
        {
          std::string known;
          for (const MaterialDefinition &other : materials)
            known += (known.empty() ? "" : ", ") + other.name;
          values.refuse(section_material,
                        known.empty()
                          ? "the file has no Materials. Add `subsection "
                            "Materials` with `subsection " +
                            name + "`"
                          : "no such material. Known: " + known);
        }
      refuse_material_parameters(values, name);
      return *material;
    }

    /** The law of @p material in sections of the shape of @p section, that of
     * an equal one of @p others if possible: struts with one law are computed
     * together. */
    std::shared_ptr<const SectionLaw>
    law_of(const MaterialDefinition             &material,
           const SectionDefinition              &definition,
           const std::vector<SectionDefinition> &others)
    {
      if (!material.law)
        return nullptr;
      const auto needed = [&](const SectionDefinition &section) {
        return material.law->needed_shape(section.section.shape);
      };
      const SectionShape shape = needed(definition);
      for (const SectionDefinition &other : others)
        if (other.material_path == definition.material_path &&
            !(needed(other) < shape) && !(shape < needed(other)))
          return other.section.law;
      const auto law = material.law->in_shape(shape);
      return law ? law : material.law;
    }

    void set_material(const MaterialDefinition             &material,
                      const std::vector<SectionDefinition> &others,
                      SectionDefinition                    &definition)
    {
      Section &section       = definition.section;
      section.youngs_modulus = material.youngs_modulus;
      section.shear_modulus  = material.shear_modulus;
      section.yield_strain   = material.yield_strain;
      section.stiffness_proportional_damping =
        material.stiffness_proportional_damping;
      section.mass_proportional_damping = material.mass_proportional_damping;
      section.thermal_expansion         = material.thermal_expansion;
      definition.material_path =
        material.name.empty() ? definition.path : "Materials/" + material.name;
      section.law            = law_of(material, definition, others);
      definition.has_density = material.density.has_value();
      section.density        = material.density.value_or(0);
    }
  } // namespace

  bool yields(const std::vector<SectionDefinition> &sections)
  {
    return std::any_of(sections.begin(),
                       sections.end(),
                       [](const SectionDefinition &definition) {
                         return definition.section.yields();
                       });
  }

  SubsectionSchema sections_schema()
  {
    Parameters parameters = {section_struts, section_shape, section_material};
    for (const Parameter &parameter : material_parameters())
      parameters.push_back(parameter);
    parameters.push_back(reference);
    return {
      "Sections",
      SubsectionSchema::Form::named_groups,
      "Cross-sections with their materials. If several apply to a strut, the last "
      "one counts. Axis 1 is along the strut. In the plane, axis 2 lies "
      "in it and axis 3 is its normal; in space see Reference vector.",
      parameters,
      "Shape",
      {{"rectangle",
        "Solid rectangle.",
        {width, height, shear_correction, torsion_of_rectangle}},
       {"circle", "Solid circle.", {radius, shear_correction}},
       {"tube",
        "Circular tube.",
        {outer_radius, wall_thickness, shear_correction}},
       {"given",
        "Area and moments as numbers.",
        {area,
         shear_area,
         shear_area_3,
         second_moment,
         second_moment_2,
         extreme_fibre,
         extreme_fibre_2,
         given_torsion,
         given_rotary_inertia,
         drawing_radius}}}};
  }

  SectionDefinition
  read_section(ParameterValues                       &values,
               const std::vector<MaterialDefinition> &materials,
               const std::vector<SectionDefinition>  &others)
  {
    SectionDefinition definition;
    definition.name              = values.name();
    definition.path              = values.context.path;
    definition.struts            = values[section_struts];
    const std::string shape_name = values[section_shape];
    if (shape_name == "rectangle")
      read_rectangle(values, definition.section);
    else if (shape_name == "circle")
      read_circle(values, definition.section);
    else if (shape_name == "tube")
      read_tube(values, definition.section);
    else
      read_given(values, definition.section);
    const MaterialDefinition material = material_of(values, materials);
    if (material.law && material.law->yields() && shape_name == "given")
      values.refuse(
        section_shape,
        "Material = " + material.name +
          " yields fibre by fibre, and area and moments do not tell "
          "where fibres lie. Choose rectangle, circle or tube");
    set_material(material, others, definition);
    if (!values.is_word(reference))
      definition.section.reference = unit_vector_of(values, reference);
    return definition;
  }
} // namespace auxfem
