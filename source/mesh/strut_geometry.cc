#include <auxfem/mesh/strut_geometry.h>
#include <auxfem/parameters/numerical_limits.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    /** Component of largest absolute value. */
    double largest_component(const dealii::Tensor<1, 3> &vector)
    {
      double largest = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        if (std::abs(vector[d]) > std::abs(largest))
          largest = vector[d];
      return largest;
    }
  } // namespace

  dealii::Tensor<1, 3> left_of(const dealii::Tensor<1, 3> &along,
                               const dealii::Tensor<1, 3> &normal)
  {
    const dealii::Tensor<1, 3> left = dealii::cross_product_3d(normal, along);
    // Nested hypot() is exact if a component is zero, as in the x-y plane.
    const double length = std::hypot(std::hypot(left[0], left[1]), left[2]);
    Assert(length > 0.,
           dealii::ExcMessage("The normal of an arc's plane cannot be parallel "
                              "to its chord."));
    return left / length;
  }

  dealii::Tensor<1, 3> rise_of_arc(const dealii::Tensor<1, 3> &chord,
                                   const double                sagitta,
                                   const dealii::Tensor<1, 3> &normal)
  {
    return sagitta == 0. ? dealii::Tensor<1, 3>()
                         : sagitta * left_of(chord, normal);
  }

  std::optional<Arc> arc_through(const dealii::Tensor<1, 3> &chord,
                                 const dealii::Tensor<1, 3> &point)
  {
    // Inscribed angle: the directions start-point and point-end differ by half
    // the angle of the arc, and sagitta = chord / 2 tan(angle / 4). Sine and
    // one plus cosine of this half angle are scaled by both distances.
    const dealii::Tensor<1, 3> back            = chord - point;
    const double               product         = point.norm() * back.norm();
    const double               one_plus_cosine = product + point * back;
    if (one_plus_cosine <= 1e-8 * product)
      return {};

    const dealii::Tensor<1, 3> turn = dealii::cross_product_3d(back, point);
    if (turn.norm() == 0.)
      return Arc{0., dealii::Point<3>(0, 0, 1)};
    // Changing the signs of both normal and sagitta gives the same arc.
    const double sine =
      largest_component(turn) < 0. ? -turn.norm() : turn.norm();
    return Arc{chord.norm() / 2. * sine / one_plus_cosine, turn / sine};
  }

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

  std::optional<std::array<double, 2>> intersection(const Segment &one,
                                                    const Segment &other)
  {
    const dealii::Tensor<1, 3> a   = one.end - one.begin,
                               b   = other.end - other.begin,
                               gap = other.begin - one.begin;
    const double determinant       = cross(a, b);
    // Segments count as parallel if round-off of coordinates moves their
    // intersection by more than position_tolerance of their lengths.
    const double round_off = std::numeric_limits<double>::epsilon() *
      std::max(largest_coordinate(one), largest_coordinate(other)) *
      (a.norm() + b.norm() + gap.norm());
    if (position_tolerance * std::abs(determinant) <= round_off)
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

  NearestPoints nearest_points(const Segment &one, const Segment &other)
  {
    const dealii::Tensor<1, 3> a   = one.end - one.begin,
                               b   = other.end - other.begin,
                               gap = one.begin - other.begin;
    const double aa = a * a, ab = a * b, bb = b * b, ag = a * gap, bg = b * gap;
    const double parallel = aa * bb - ab * ab;
    double s = parallel > 0 ? in_segment((ab * bg - ag * bb) / parallel) : 0;
    double t = bb > 0 ? (ab * s + bg) / bb : 0;
    // If the nearest point of `other` lies beyond its ends, or `other` is a
    // point, recompute the nearest point of `one`.
    if (t < 0 || t > 1 || bb == 0)
      {
        t = in_segment(t);
        s = aa > 0 ? in_segment((ab * t - ag) / aa) : 0;
      }
    return {(gap + s * a - t * b).norm(), {{s, t}}};
  }
} // namespace auxfem
