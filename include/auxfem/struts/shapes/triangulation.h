#ifndef auxfem_struts_shapes_triangulation_h
#define auxfem_struts_shapes_triangulation_h

#include <auxfem/struts/shapes/outline.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** A section divided into triangles. */
  struct TriangulatedSection
  {
    std::vector<dealii::Point<2>>            points;    ///< (m)
    std::vector<std::array<unsigned int, 3>> triangles; ///< counter-clockwise
    /** Corners with an inner angle well beyond pi, where stresses are singular
     * (m). */
    std::vector<dealii::Point<2>> reentrant_corners;
  };

  /**
   * Divides the polygon @p outline into Delaunay triangles. Their corners are
   * those of the polygon and points on its sides, as far apart as the section
   * is thick; far from corners further.
   */
  TriangulatedSection triangulate(const Outline &outline);
} // namespace auxfem

#endif
