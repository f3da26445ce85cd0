#include <auxfem/struts/section.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace auxfem
{
  namespace
  {
    const Text section_struts = {"Struts",
                                 "all",
                                 "Set of struts with this section."};

    Choice shape_choice()
    {
      return {"Shape",
              "",
              names_of(cross_section_registry()),
              "Shape of the cross-section."};
    }

    const QuantityList reference = {
      "Reference vector",
      "auto",
      "1",
      Range::any(),
      3,
      3,
      "Vector x, y, z whose projection normal to the strut gives axis 3 of the drawn shape at rest; not parallel to a strut; unused in the plane; auto: z, or x for struts within 5 degrees of z.",
      {"auto"}};
    const Text section_material = {
      "Material",
      "none",
      "Name in Materials; none: the section gives the constants of a linear "
      "elastic material itself."};

    const Text taper = {
      "Taper",
      "none",
      "Factors on dimensions along the strut, DIMENSION: EXPRESSION in s from 0 "
      "at its first joint to 1 at its second, separated by semicolons, e.g. "
      "Height: 1 - 0.5 * s. Each element has the section of its middle. none: "
      "constant."};

    const Text base = {
      "Base",
      "none",
      "Name of another section, whose values count where this one gives none."};

    const Text grading = {
      "Grading",
      "none",
      "Factors from strut to strut, NAME: EXPRESSION separated by semicolons, "
      "e.g. Height: 1 + 0.5 * y / ymax; Density: 1 + 0.1 * normal(1). NAME: a "
      "number of the shape, Young's modulus, Density, Yield strain, damping or "
      "Thermal expansion. Expressions may use x, y, z of the strut's middle and "
      "xmin, xmax, ... in the designed lattice (m), strut, cell, "
      "random(seed) in [0, 1) and normal(seed). none: all struts alike."};

    /** Sets the variation along the strut and the shape of its middle. */
    void set_taper(const ParameterValues             &values,
                   const RegistryEntry<CrossSection> &shape,
                   Section                           &section)
    {
      section.taper = std::make_shared<Taper>(values, taper, shape);
      for (const double s : {0., 1., 0.5})
        section = section.at(s);
      if (section.outer_fibres.empty())
        values.refuse(taper,
                      "the outer fibres of Shape = " + shape.name +
                        " are not known. Choose a shape with dimensions");
    }

    const RegistryEntry<CrossSection> &shape_of(const ParameterValues &values)
    {
      return find_entry(cross_section_registry(), values[shape_choice()]);
    }

    /** In the plane, struts bend about the drawn axis 3. */
    void refuse_turned_axes(const ParameterValues &values,
                            const CrossSection    &section)
    {
      const double angle = section.principal_angle;
      if (angle == 0)
        return;
      const double       c = std::cos(angle), s = std::sin(angle);
      std::ostringstream text;
      text.precision(4);
      text
        << "its principal axes are turned by "
        << angle * 180 / dealii::numbers::PI
        << " degrees, so that a strut would bend out of the plane. Set "
           "Dimension = 3, or turn the shape; if supports keep the struts in "
           "the plane, set Shape = given with Second moment of area = "
        << c * c * section.second_moment_3 + s * s * section.second_moment_2
        << " m4";
      values.refuse(shape_choice(), text.str());
    }

    /** Sets all that depends on the shape alone. */
    void read_shape(ParameterValues &values, SectionDefinition &definition)
    {
      const RegistryEntry<CrossSection> &shape        = shape_of(values);
      static_cast<CrossSection &>(definition.section) = *shape.make(values);
      if (values[taper] != "none")
        set_taper(values, shape, definition.section);
      if (values.context.dimension == 2)
        refuse_turned_axes(values, definition.section);
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

    /** Elements with one law share the proportions of their fibres. */
    void refuse_varied_fibres(const ParameterValues &values,
                              const Section         &section)
    {
      if (!section.taper || !section.law)
        return;
      const SectionShape here = section.law->needed_shape(section.shape),
                         there =
                           section.law->needed_shape(section.at(0.25).shape);
      if (!are_alike(here, there))
        values.refuse(taper,
                      "the proportions of the section vary, for which this "
                      "material has no fibres. Let both dimensions vary alike, "
                      "or divide the struts into several ones");
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

  bool have_tapers(const std::vector<SectionDefinition> &sections)
  {
    return std::any_of(sections.begin(),
                       sections.end(),
                       [](const SectionDefinition &definition) {
                         return definition.section.taper != nullptr;
                       });
  }

  const Parameter &base_section_parameter()
  {
    return base;
  }

  SubsectionSchema sections_schema()
  {
    Parameters parameters =
      {section_struts, base, shape_choice(), taper, grading, section_material};
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
      variants_of(cross_section_registry())};
  }

  SectionDefinition
  read_section(ParameterValues                       &values,
               const std::vector<MaterialDefinition> &materials,
               const std::vector<SectionDefinition>  &others)
  {
    SectionDefinition definition;
    definition.name   = values.name();
    definition.path   = values.context.path;
    definition.struts = values[section_struts];
    read_shape(values, definition);
    const MaterialDefinition material = material_of(values, materials);
    if (material.law && material.law->yields() &&
        definition.section.shape.kind == SectionShape::Kind::without_fibres)
      values.refuse(shape_choice(),
                    "Material = " + material.name +
                      " yields fibre by fibre, and this shape has no fibres. "
                      "Choose rectangle, circle or tube");
    set_material(material, others, definition);
    refuse_varied_fibres(values, definition.section);
    if (!values.is_word(reference))
      definition.section.reference = unit_vector_of(values, reference);
    definition.number = others.size();
    if (values[grading] != "none")
      definition.grading =
        std::make_shared<Grading>(values,
                                  grading,
                                  definition,
                                  shape_of(values).parameters,
                                  read_shape);
    return definition;
  }
} // namespace auxfem
