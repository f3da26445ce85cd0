#ifndef auxfem_contact_axis_curve_h
#define auxfem_contact_axis_curve_h

#include <deal.II/base/tensor.h>

#include <array>

namespace auxfem
{
  /**
   * The axis of an element now: a polynomial of a parameter in [0, 1] along it,
   * in powers of that. Pure geometry.
   */
  struct AxisCurve
  {
    using Vector = dealii::Tensor<1, 3>;

    /** Enough for struts of order 6 and arcs up to a full circle. */
    static constexpr unsigned int max_degree = 14;

    unsigned int                       degree = 1;
    std::array<Vector, max_degree + 1> coefficients; ///< m

    Vector at(const double parameter) const
    {
      Vector result = coefficients[degree];
      for (unsigned int k = degree; k-- > 0;)
        result = coefficients[k] + parameter * result;
      return result;
    }

    /** Derivative by the parameter (m). */
    Vector tangent(const double parameter) const
    {
      Vector result = degree * coefficients[degree];
      for (unsigned int k = degree; k-- > 1;)
        result = k * coefficients[k] + parameter * result;
      return result;
    }

    /** Second derivative by the parameter (m). */
    Vector bend(const double parameter) const
    {
      Vector result;
      for (unsigned int k = degree; k > 1; --k)
        result = k * (k - 1.) * coefficients[k] + parameter * result;
      return result;
    }
  };

  /** The point of a curve that is nearest to another one. */
  struct NearestPoint
  {
    double parameter;
    double distance; ///< m
    /** Whether the line between the points is normal to the curve: else the
     * point is an end of the part looked at. */
    bool is_inside;
  };

  /**
   * The point nearest to @p point on the part of @p curve between two
   * parameters: the best of some points along it, then Newton's method, kept
   * between the neighbours of that.
   */
  NearestPoint nearest_point(const AxisCurve         &curve,
                             const AxisCurve::Vector &point,
                             double                   begin = 0,
                             double                   end   = 1);
} // namespace auxfem

#endif
