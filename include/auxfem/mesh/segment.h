#ifndef auxfem_mesh_segment_h
#define auxfem_mesh_segment_h

#include <deal.II/base/point.h>

#include <array>
#include <optional>

namespace auxfem
{
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
