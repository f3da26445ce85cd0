#include <auxfem/struts/shapes/shape_table.h>

namespace auxfem
{
  const Registry<CrossSection> &cross_section_registry()
  {
    static const Registry<CrossSection> registry = {rectangle_entry(),
                                                    circle_entry(),
                                                    tube_entry(),
                                                    ellipse_entry(),
                                                    box_entry(),
                                                    i_entry(),
                                                    t_entry(),
                                                    c_entry(),
                                                    l_entry(),
                                                    polygon_entry(),
                                                    profile_entry(),
                                                    given_entry()};
    return registry;
  }

  std::vector<dealii::Point<2>>
  fibres_at(const std::array<double, 2> &distances)
  {
    const auto [z, y] = distances;
    return {{y, z}, {y, -z}, {-y, z}, {-y, -z}};
  }

  const Quantity &shear_correction_parameter()
  {
    static const Quantity parameter = {
      "Shear correction",
      "auto",
      "1",
      {0, 1, true, false},
      "Shear area over area; auto: 5/6 for a rectangle, 0.9 for a circle, 0.5 "
      "for a tube.",
      {"auto"}};
    return parameter;
  }

  const Quantity &torsion_constant_parameter()
  {
    static const Quantity parameter = {
      "Torsion constant",
      "auto",
      "m4",
      Range::positive(),
      "Torsion constant J, unused in the plane; auto: Saint-Venant's.",
      {"auto"}};
    return parameter;
  }

  std::unique_ptr<CrossSection>
  section_of_outline(const ParameterValues &values, const Outline &outline)
  {
    CrossSection section = section_in_outline(outline);
    section.torsion_constant =
      values.value_or(torsion_constant_parameter(), section.torsion_constant);
    return std::make_unique<CrossSection>(section);
  }

  void set_shear_areas(const ParameterValues &values,
                       const double           automatic,
                       CrossSection          &section)
  {
    section.shear_area_2 = section.shear_area_3 =
      section.area * values.value_or(shear_correction_parameter(), automatic);
  }

  void set_axisymmetric_moments(const double  second_moment,
                                CrossSection &section)
  {
    section.second_moment_2  = second_moment;
    section.second_moment_3  = second_moment;
    section.torsion_constant = 2 * second_moment;
  }
} // namespace auxfem
