#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/scene_sections.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
    using dealii::numbers::PI;

    const Text   struts = {"Struts", "all", "Set of struts with this section."};
    const Choice shape  = {"Shape",
                           "",
                           {"rectangle", "circle", "tube", "given"},
                           "Shape of the cross-section."};

    const Quantity width          = {"Width",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Side of the rectangle normal to the plane."};
    const Quantity height         = {"Height",
                                     "",
                                     "m",
                                     Range::positive(),
                                     "Side of the rectangle in the plane."};
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
      "Area that carries shear, shear correction included."};
    const Quantity second_moment = {
      "Second moment of area",
      "",
      "m4",
      Range::positive(),
      "Second moment of area about the normal of the plane."};
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
      declare(prm, struts);
      declare(prm, shape);
      declare(prm, youngs_modulus);
      declare(prm, poissons_ratio);
      declare(prm, density);
      declare(prm, stiffness_damping);
      declare(prm, mass_damping);
    }

    void declare_rectangle(dealii::ParameterHandler &prm)
    {
      declare(prm, width);
      declare(prm, height);
      declare(prm, shear_correction);
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
      declare(prm, second_moment);
      declare(prm, drawing_radius);
    }

    void set_shear_area(dealii::ParameterHandler &prm,
                        const double              automatic,
                        Section                  &section)
    {
      section.shear_area_2 = section.area *
        (is_word(prm, shear_correction) ? automatic
                                        : get(prm, shear_correction));
    }

    void read_rectangle(dealii::ParameterHandler &prm, Section &section)
    {
      const double b = get(prm, width), h = get(prm, height);
      section.area            = b * h;
      section.second_moment_3 = b * h * h * h / 12;
      section.radius          = h / 2;
      set_shear_area(prm, 5. / 6., section);
    }

    void read_circle(dealii::ParameterHandler &prm, Section &section)
    {
      const double r          = get(prm, radius);
      section.area            = PI * r * r;
      section.second_moment_3 = PI / 4 * r * r * r * r;
      section.radius          = r;
      set_shear_area(prm, 0.9, section);
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
      section.area = PI * (outer * outer - inner * inner);
      section.second_moment_3 =
        PI / 4 * (std::pow(outer, 4) - std::pow(inner, 4));
      section.radius = outer;
      set_shear_area(prm, 0.5, section);
    }

    void read_given(dealii::ParameterHandler &prm, Section &section)
    {
      section.area            = get(prm, area);
      section.shear_area_2    = get(prm, shear_area);
      section.second_moment_3 = get(prm, second_moment);
      section.radius          = is_word(prm, drawing_radius)
                 ? std::sqrt(3 * section.second_moment_3 / section.area)
                 : get(prm, drawing_radius);
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
      definition.struts            = get(prm, struts);
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
            "counts.",
            declare_common,
            "Shape",
            {{"rectangle", "Solid rectangle.", declare_rectangle},
             {"circle", "Solid circle.", declare_circle},
             {"tube", "Circular tube.", declare_tube},
             {"given", "Area and moments as numbers.", declare_given}},
            read_section};
  }
} // namespace auxfem
