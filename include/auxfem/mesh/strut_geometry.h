#ifndef auxfem_mesh_strut_geometry_h
#define auxfem_mesh_strut_geometry_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <optional>

namespace auxfem
{
  /** Shape of a circular arc over a chord, see Strut. */
  struct Arc
  {
    double               sagitta; ///< m
    dealii::Tensor<1, 3> normal;  ///< unit vector
  };

  /** Unit vector to the left of the direction @p along, seen against
   * @p normal. Both may have any length, but must not be parallel. */
  dealii::Tensor<1, 3> left_of(const dealii::Tensor<1, 3> &along,
                               const dealii::Tensor<1, 3> &normal);

  /**
   * Vector from the middle of the @p chord to the middle of the arc (m). It
   * distinguishes arcs between the same joints, as it does not depend on their
   * order.
   */
  dealii::Tensor<1, 3> rise_of_arc(const dealii::Tensor<1, 3> &chord,
                                   double                      sagitta,
                                   const dealii::Tensor<1, 3> &normal);

  /**
   * The arc over @p chord through @p point, both relative to the arc's start
   * (m). The largest component of its normal is positive: z in planes parallel
   * to x-y. A point on the chord gives sagitta zero. Nothing if the point lies
   * at an end of the chord or on its extension.
   */
  std::optional<Arc> arc_through(const dealii::Tensor<1, 3> &chord,
                                 const dealii::Tensor<1, 3> &point);

  /** A straight line from one point to another (m). */
  struct Segment
  {
    dealii::Point<3> begin, end;
  };

  /** Intersection of two segments in the plane z = 0, as fractions of both
   * lengths; nothing if they do not meet or are parallel. */
  std::optional<std::array<double, 2>> intersection(const Segment &one,
                                                    const Segment &other);

  /** Points of two segments that are nearest to each other. */
  struct NearestPoints
  {
    double distance; ///< m
    /** Places of the points as fractions of both lengths. */
    std::array<double, 2> fractions;
  };

  /** Nearest points of two segments (Ericson, Real-Time Collision Detection,
   * 2005, section 5.1.9). A segment may be a point. */
  NearestPoints nearest_points(const Segment &one, const Segment &other);

  /** Shortest distance (m) between two segments. */
  inline double distance(const Segment &one, const Segment &other)
  {
    return nearest_points(one, other).distance;
  }
} // namespace auxfem

#endif
