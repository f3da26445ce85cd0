#include <auxfem/mesh/segment.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    double cross(const dealii::Tensor<1, 3> &a, const dealii::Tensor<1, 3> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }

    /** Largest coordinate in the plane (m). */
    double largest_coordinate(const Segment &segment)
    {
      double largest = 0;
      for (const dealii::Point<3> &point : {segment.begin, segment.end})
        for (unsigned int d = 0; d < 2; ++d)
          largest = std::max(largest, std::abs(point[d]));
      return largest;
    }

    double in_segment(const double fraction)
    {
      return std::clamp(fraction, 0., 1.);
    }
  } // namespace

  std::optional<std::array<double, 2>> meeting_point(const Segment &one,
                                                     const Segment &other)
  {
    const dealii::Tensor<1, 3> a   = one.end - one.begin,
                               b   = other.end - other.begin,
                               gap = other.begin - one.begin;
    const double determinant       = cross(a, b);
    // Points are known to the round-off of their coordinates. Segments so
    // nearly parallel that it moves their meeting point by more than this part
    // of their lengths count as parallel, as those of one straight line.
    const double round_off = std::numeric_limits<double>::epsilon() *
      std::max(largest_coordinate(one), largest_coordinate(other)) *
      (a.norm() + b.norm() + gap.norm());
    if (accuracy_of_places * std::abs(determinant) <= round_off)
      return {};
    const double along_one = cross(gap, b), along_other = cross(gap, a);
    const auto   is_inside = [determinant](const double numerator) {
      return determinant > 0 ? 0 <= numerator && numerator <= determinant
                               : determinant <= numerator && numerator <= 0;
    };
    if (!is_inside(along_one) || !is_inside(along_other))
      return {};
    return {{{along_one / determinant, along_other / determinant}}};
  }

  double distance(const Segment &one, const Segment &other)
  {
    const dealii::Tensor<1, 3> a   = one.end - one.begin,
                               b   = other.end - other.begin,
                               gap = one.begin - other.begin;
    const double aa = a * a, ab = a * b, bb = b * b, ag = a * gap, bg = b * gap;
    const double parallel = aa * bb - ab * ab;
    double s = parallel > 0 ? in_segment((ab * bg - ag * bb) / parallel) : 0;
    double t = bb > 0 ? (ab * s + bg) / bb : 0;
    // What is nearest to a point beyond the other's ends, or to a point that is
    // the other, is another one.
    if (t < 0 || t > 1 || bb == 0)
      {
        t = in_segment(t);
        s = aa > 0 ? in_segment((ab * t - ag) / aa) : 0;
      }
    return (gap + s * a - t * b).norm();
  }
} // namespace auxfem
