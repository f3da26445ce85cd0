#ifndef auxfem_struts_shapes_shape_table_h
#define auxfem_struts_shapes_shape_table_h

#include <auxfem/struts/shapes/outline.h>

namespace auxfem
{
  /** @name Registry entries of the shapes, one per file in
   * source/struts/shapes/. */
  ///@{
  RegistryEntry<CrossSection> rectangle_entry();
  RegistryEntry<CrossSection> circle_entry();
  RegistryEntry<CrossSection> tube_entry();
  RegistryEntry<CrossSection> ellipse_entry();
  RegistryEntry<CrossSection> box_entry();
  RegistryEntry<CrossSection> i_entry();
  RegistryEntry<CrossSection> t_entry();
  RegistryEntry<CrossSection> c_entry();
  RegistryEntry<CrossSection> l_entry();
  RegistryEntry<CrossSection> polygon_entry();
  RegistryEntry<CrossSection> profile_entry();
  RegistryEntry<CrossSection> given_entry();
  ///@}

  /** @name Parts of shapes */
  ///@{
  /** Parameter `Shear correction`: shear area over area. */
  const Quantity &shear_correction_parameter();

  /** Parameter `Torsion constant`, by default Saint-Venant's. */
  const Quantity &torsion_constant_parameter();

  /** section_in_outline(), with the Torsion constant that is given. */
  std::unique_ptr<CrossSection>
  section_of_outline(const ParameterValues &values, const Outline &outline);

  /** Sets both shear areas to the area times the Shear correction, or times
   * @p automatic. */
  void set_shear_areas(const ParameterValues &values,
                       double                 automatic,
                       CrossSection          &section);

  /** Sets the moments of a section that is the same about every transverse axis
   * (m4). */
  void set_axisymmetric_moments(double second_moment, CrossSection &section);
  ///@}
} // namespace auxfem

#endif
