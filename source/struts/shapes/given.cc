#include <auxfem/struts/shapes/shape_table.h>

#include <cmath>

namespace auxfem
{
  namespace
  {
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
    const Quantity drawing_radius = {
      "Drawing radius",
      "auto",
      "m",
      Range::positive(),
      "Radius of the tube drawn in ParaView; auto: half the height of a "
      "rectangle of equal area and second moment.",
      {"auto"}};
    std::unique_ptr<CrossSection> make_given(ParameterValues &values)
    {
      CrossSection section;
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
        section.outer_fibres =
          fibres_at({{values.value_or(extreme_fibre_2, values[extreme_fibre]),
                      values[extreme_fibre]}});
      else if (!values.is_word(extreme_fibre_2))
        values.refuse(extreme_fibre_2,
                      "Extreme fibre is none. Give both distances, or neither");
      if (!values.is_word(given_rotary_inertia))
        {
          const std::vector<double> moments = values[given_rotary_inertia];
          section.given_rotary_inertia = {{moments[0], moments[1], moments[2]}};
        }
      return std::make_unique<CrossSection>(section);
    }
  } // namespace

  RegistryEntry<CrossSection> given_entry()
  {
    return {"given",
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
             drawing_radius},
            make_given};
  }
} // namespace auxfem
