#include <auxfem/mesh/segment.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    double cross(const dealii::Tensor<1, 3> &a, const dealii::Tensor<1, 3> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
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
    const double along_one = cross(gap, b), along_other = cross(gap, a);
    const auto   is_inside = [determinant](const double numerator) {
      return determinant > 0 ? 0 <= numerator && numerator <= determinant
                               : determinant <= numerator && numerator <= 0;
    };
    if (determinant == 0 || !is_inside(along_one) || !is_inside(along_other))
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
