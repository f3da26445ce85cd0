#include <auxfem/struts/material.h>

namespace auxfem
{
  namespace
  {
    const Quantity youngs_modulus = {
      "Young's modulus",
      "none",
      "Pa",
      Range::positive(),
      "Young's modulus, the instantaneous one of materials that relax.",
      {"none"}};
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
             "Mass per volume; none: allowed only in statics without weight.",
             {"none"}};
    const Quantity yield_strain = {
      "Yield strain",
      "none",
      "1",
      Range::positive(),
      "Outer-fibre strain at which the material yields, in tension or "
      "compression; beyond it the verdict is doubtful. In a section with Shape "
      "= given see Extreme fibre.",
      {"none"}};
    const Quantity stiffness_damping = {
      "Stiffness-proportional damping",
      "0 s",
      "s",
      Range::non_negative(),
      "Time b of the damping stress = E b strain rate; elastic materials only."};
    const Quantity mass_damping = {
      "Mass-proportional damping",
      "0 1/s",
      "1/s",
      Range::non_negative(),
      "Rate a of the damping force = a mass velocity."};
    const Quantity thermal_expansion = {
      "Thermal expansion",
      "none",
      "1/K",
      Range::any(),
      "Strain of a free strut per temperature; none: refused under a load of "
      "Type = temperature.",
      {"none"}};

    Choice law_choice()
    {
      return {"Law",
              "elastic",
              names_of(section_law_registry()),
              "Relation between stress and strain."};
    }
  } // namespace

  Parameters material_parameters()
  {
    return {youngs_modulus,
            poissons_ratio,
            density,
            yield_strain,
            stiffness_damping,
            mass_damping,
            thermal_expansion};
  }

  const Quantity &youngs_modulus_parameter()
  {
    return youngs_modulus;
  }

  const Quantity &poissons_ratio_parameter()
  {
    return poissons_ratio;
  }

  double read_youngs_modulus(const ParameterValues &values,
                             const std::string     &remedy)
  {
    if (values.is_word(youngs_modulus))
      values.refuse(youngs_modulus, "it must be given. " + remedy);
    return values[youngs_modulus];
  }

  MaterialDefinition read_material_constants(const ParameterValues &values,
                                             const double           modulus)
  {
    MaterialDefinition material;
    material.youngs_modulus = modulus;
    material.shear_modulus =
      material.youngs_modulus / (2 * (1 + values[poissons_ratio]));
    if (!values.is_word(density))
      material.density = values[density];
    if (!values.is_word(yield_strain))
      material.yield_strain = values[yield_strain];
    material.stiffness_proportional_damping = values[stiffness_damping];
    material.mass_proportional_damping      = values[mass_damping];
    if (!values.is_word(thermal_expansion))
      material.thermal_expansion = values[thermal_expansion];
    return material;
  }

  void refuse_material_parameters(const ParameterValues &values,
                                  const std::string     &material)
  {
    for (const Parameter &parameter : material_parameters())
      if (!values.is_default(parameter))
        values.refuse(parameter,
                      "the section has Material = " + material + ". Set " +
                        parameter.name + " in Materials/" + material +
                        ", or remove Material");
  }

  SubsectionSchema materials_schema()
  {
    Parameters parameters = {law_choice()};
    for (const Parameter &parameter : material_parameters())
      parameters.push_back(parameter);
    return {"Materials",
            SubsectionSchema::Form::named_groups,
            "Materials of sections, each named once.",
            parameters,
            "Law",
            variants_of(section_law_registry())};
  }

  MaterialDefinition read_material(ParameterValues &values)
  {
    std::shared_ptr<const SectionLaw> law =
      find_entry(section_law_registry(), values[law_choice()]).make(values);
    const std::optional<double> law_modulus =
      law ? law->youngs_modulus() : std::nullopt;
    MaterialDefinition material = read_material_constants(
      values,
      law_modulus ? *law_modulus
                  : read_youngs_modulus(values, example_of_youngs_modulus));
    material.name = values.name();
    material.law  = law;
    if (material.law && material.law->yields() && material.yield_strain)
      values.refuse(yield_strain,
                    "Law = " + values[law_choice()] +
                      " simulates yielding from Yield stress on. Remove it");
    if (material.law && material.stiffness_proportional_damping > 0)
      values.refuse(
        stiffness_damping,
        "Law = " + values[law_choice()] + " has losses of its own. " +
          (material.law->yields()
             ? "Set Mass-proportional damping, or damp by the time scheme "
               "(generalized-alpha)"
             : "Remove it, or add a relaxing part with a short relaxation "
               "time"));
    return material;
  }
} // namespace auxfem
