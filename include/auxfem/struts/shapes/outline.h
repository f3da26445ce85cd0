#ifndef auxfem_struts_shapes_outline_h
#define auxfem_struts_shapes_outline_h

#include <auxfem/struts/shapes/cross_section.h>

#include <optional>
#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * Closed polygon around a section: coordinates along the drawn axes 2 and 3
   * (m), counter-clockwise. A hole, clockwise, is joined to the outer polygon
   * by a side that is passed twice, so that two corners appear twice.
   */
  using Outline = std::vector<dealii::Point<2>>;

  /** Twice the area of a triangle, positive if counter-clockwise (m2). */
  double twice_area(const dealii::Point<2> &a,
                    const dealii::Point<2> &b,
                    const dealii::Point<2> &c);

  /** Corner of a section, perhaps rounded by an arc. */
  struct RoundedCorner
  {
    double y, z;       ///< along the drawn axes 2 and 3 (m)
    double radius = 0; ///< of an arc tangential to both sides (m); 0: sharp
  };

  /** Outline with chords in place of arcs, of equal area. */
  Outline rounded_outline(const std::vector<RoundedCorner> &corners);

  /** Area, negative if the corners are clockwise (m2). */
  double signed_area(const Outline &outline);

  /** Two sides that cross or touch, by the numbers of their first corners;
   * successive sides may share their corner only. */
  std::optional<std::pair<unsigned int, unsigned int>>
  crossing_sides(const Outline &outline);

  /** Constants of a homogeneous section: moments of the polygon, torsion
   * constant and shear areas by solve_saint_venant(). Half thicknesses are half
   * the extent along the principal axes. */
  CrossSection section_in_outline(Outline outline);
} // namespace auxfem

#endif
