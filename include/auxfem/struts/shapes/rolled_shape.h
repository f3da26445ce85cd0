#ifndef auxfem_struts_shapes_rolled_shape_h
#define auxfem_struts_shapes_rolled_shape_h

#include <auxfem/struts/shapes/outline.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** Dimensions of a rolled section (m). */
  struct RolledDimensions
  {
    double height = 0, width = 0; ///< along axes 2 and 3
    double web = 0, flange = 0;   ///< thicknesses of walls along axes 2 and 3
    double fillet = 0;            ///< radius between web and flange
    double toe    = 0;            ///< radius at the ends of the legs of an L
  };

  /** A kind of section of webs and flanges. */
  struct RolledShape
  {
    std::string name;
    /** Flanges at the web: one or two. */
    unsigned int n_flanges;
    /** Whether flanges project from both sides of the web. */
    bool projects_on_both_sides;
    Outline (*outline)(const RolledDimensions &dimensions);

    /** Height and width of the space between web and flange (m). */
    double clear_height(const RolledDimensions &dimensions) const
    {
      return dimensions.height - n_flanges * dimensions.flange;
    }
    double clear_width(const RolledDimensions &dimensions) const
    {
      return (dimensions.width - dimensions.web) /
        (projects_on_both_sides ? 2 : 1);
    }
  };

  /** I, T, C and L. */
  const std::vector<RolledShape> &rolled_shapes();
} // namespace auxfem

#endif
