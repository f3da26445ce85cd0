#include <auxfem/mesh/lattice.h>
#include <auxfem/mesh/strut_geometry.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace auxfem
{
  std::optional<unsigned int> read_index(const std::string &text)
  {
    const std::string digits = dealii::Utilities::trim(text);
    const char *const end    = digits.data() + digits.size();
    unsigned int      index  = 0;
    const auto        answer = std::from_chars(digits.data(), end, index);
    if (answer.ec != std::errc() || answer.ptr != end || index == invalid_index)
      return {};
    return index;
  }

  namespace
  {
    /**
     * Half the angle a circular arc subtends (rad), signed as the sagitta; in
     * (-pi, pi), beyond pi/2 for more than a half circle.
     */
    double half_angle(const double chord, const double sagitta)
    {
      return 2. * std::atan(2. * sagitta / chord);
    }

    /** sin(x)/x. */
    double sinc(const double x)
    {
      return x == 0. ? 1. : std::sin(x) / x;
    }

    double arc_length(const double chord, const double sagitta)
    {
      // With t = tan(angle/2) = 2 sagitta / chord, angle / sin(angle) is
      // (1 + t^2) atan(t) / t. This is accurate for flat arcs and for nearly
      // closed circles, where sin(angle) goes to zero.
      const double t = 2. * sagitta / chord;
      return t == 0. ? chord : chord * (1. + t * t) * std::atan(t) / t;
    }
  } // namespace

  unsigned int Lattice::n_elastic_struts() const
  {
    return std::count_if(struts.begin(), struts.end(), [](const Strut &strut) {
      return !strut.is_rigid();
    });
  }

  double Lattice::length(const Strut &strut) const
  {
    const double chord =
      joints[strut.joints[0]].distance(joints[strut.joints[1]]);
    return arc_length(chord, strut.sagitta);
  }

  dealii::Point<3> Lattice::centroid(const Strut &strut) const
  {
    dealii::Point<3> result;
    for (const auto &[position, weight] : uniform_points(strut))
      result += weight * position;
    return result;
  }

  std::vector<std::pair<dealii::Point<3>, double>>
  Lattice::uniform_points(const Strut &strut) const
  {
    // Exact for a straight axis, to 1e-14 for a half circle.
    static const dealii::QGauss<1>                   rule(12);
    std::vector<std::pair<dealii::Point<3>, double>> points(rule.size());
    for (unsigned int q = 0; q < rule.size(); ++q)
      {
        dealii::Tensor<1, 3> tangent;
        axis(strut, rule.point(q)[0], points[q].first, tangent);
        points[q].second = rule.weight(q);
      }
    return points;
  }

  void Lattice::axis(const Strut          &strut,
                     const double          s,
                     dealii::Point<3>     &position,
                     dealii::Tensor<1, 3> &tangent) const
  {
    const dealii::Point<3>    &start = joints[strut.joints[0]];
    const dealii::Tensor<1, 3> chord = joints[strut.joints[1]] - start;
    const double               c     = chord.norm();
    const dealii::Tensor<1, 3> along = chord / c;
    if (strut.sagitta == 0.)
      {
        position = start + s * chord;
        tangent  = along;
        return;
      }

    const dealii::Tensor<1, 3> left = left_of(along, strut.normal);

    // The tangent turns evenly from +angle at the start to -angle at the end.
    // Its integral is written as a product: the difference of two sines would
    // cancel for flat arcs.
    const double angle    = half_angle(c, strut.sagitta);
    const double distance = s * arc_length(c, strut.sagitta) * sinc(angle * s);
    position              = start +
      distance *
        (std::cos(angle * (1. - s)) * along +
         std::sin(angle * (1. - s)) * left);
    tangent = std::cos(angle * (1. - 2. * s)) * along +
      std::sin(angle * (1. - 2. * s)) * left;
  }
} // namespace auxfem
