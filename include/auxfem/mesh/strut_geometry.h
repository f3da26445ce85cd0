#ifndef auxfem_mesh_strut_geometry_h
#define auxfem_mesh_strut_geometry_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <optional>

namespace auxfem
{
  /** A circular arc over a chord; see Strut for the two. */
  struct Arc
  {
    double               sagitta; ///< m
    dealii::Tensor<1, 3> normal;  ///< unit vector
  };

  /**
   * Unit vector to the left of the direction @p along, seen against @p normal;
   * neither has to be of length one, but they cannot be parallel.
   */
  dealii::Tensor<1, 3> left_of(const dealii::Tensor<1, 3> &along,
                               const dealii::Tensor<1, 3> &normal);

  /**
   * From the middle of the @p chord (m) to the middle of the arc (m). Tells
   * arcs between the same joints apart: it is the same whichever joint comes
   * first. The zero vector without sagitta.
   */
  dealii::Tensor<1, 3> rise_of_arc(const dealii::Tensor<1, 3> &chord,
                                   double                      sagitta,
                                   const dealii::Tensor<1, 3> &normal);

  /**
   * The arc over @p chord that leads through a point @p there, both counted
   * from its start (m). In planes parallel to x-y its normal is z, elsewhere
   * the largest component of the normal is positive. The sagitta is zero for a
   * point on the chord. Nothing for a point on the chord's line outside of it,
   * or at its ends: no arc leads there.
   */
  std::optional<Arc> arc_through(const dealii::Tensor<1, 3> &chord,
                                 const dealii::Tensor<1, 3> &there);

  /** A straight line from one point to another (m). */
  struct Segment
  {
    dealii::Point<3> begin, end;
  };

  /**
   * Where two segments in the plane z = 0 meet, as fractions of both; nothing
   * if they do not or are parallel.
   */
  std::optional<std::array<double, 2>> meeting_point(const Segment &one,
                                                     const Segment &other);

  /** Shortest distance (m) between two segments (Ericson, Real-Time Collision
   * Detection, 2005, section 5.1.9). */
  double distance(const Segment &one, const Segment &other);
} // namespace auxfem

#endif
