#ifndef auxfem_struts_shapes_cross_section_h
#define auxfem_struts_shapes_cross_section_h

#include <auxfem/parameters/registry.h>
#include <auxfem/struts/fibres.h>
#include <auxfem/struts/shapes/stress_points.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Constants of a cross-section without its material (SI). Axes 2 and 3 are
   * the principal axes through the centroid. The drawn axes, in which a shape
   * is given, may be turned against them.
   */
  struct CrossSection
  {
    double area = 0; ///< A (m2)
    /** Shear areas k A along axes 2 and 3, shear correction included (m2). */
    double shear_area_2 = 0, shear_area_3 = 0;
    /** I about axes 2 and 3 (m4). */
    double second_moment_2 = 0, second_moment_3 = 0;
    /** Angle about axis 1 from the drawn axes to the principal ones (rad), in
     * (-pi/4, pi/4]. */
    double principal_angle = 0;
    /** Saint-Venant's torsion constant J (m4). */
    double torsion_constant = 0;
    /** Rotary inertia per length about axes 1, 2, 3 (kg m); empty: density
     * times I_2 + I_3, I_2, I_3. */
    std::optional<std::array<double, 3>> given_rotary_inertia;
    /** Outermost fibres, at their distances along axes 2 and 3 from the axis
     * (m): bending strains are largest at one of them. Empty: unknown. */
    std::vector<dealii::Point<2>> outer_fibres;
    /** Points at which stresses are looked for; empty: the shape is unknown. */
    StressPointsMaker make_stress_points;
    /** Half thickness across axes 2 and 3 for contact (m); 0: unknown, the
     * section is given by its stiffnesses. */
    std::array<double, 2> half_thicknesses = {{0., 0.}};
    /** Half thickness (m) of struts for contact: in the plane the one in it, in
     * space the smaller one. */
    double contact_half_thickness(const unsigned int dimension) const
    {
      return dimension == 2
        ? half_thicknesses[1]
        : std::min(half_thicknesses[0], half_thicknesses[1]);
    }
    /** Shape, for laws that divide the section into fibres. */
    SectionShape shape;
    /** Radius of the tube drawn in ParaView (m). */
    double radius = 0;
  };

  /** Registry of all shapes (source/struts/shapes/shape_table.cc). */
  const Registry<CrossSection> &cross_section_registry();

  /** Outermost fibres of a rectangle, or of another doubly symmetric shape to
   * the safe side.
   * @param distances from axes 2 and 3 (m) */
  std::vector<dealii::Point<2>>
  fibres_at(const std::array<double, 2> &distances);
} // namespace auxfem

#endif
