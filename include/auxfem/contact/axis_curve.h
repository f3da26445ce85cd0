#ifndef auxfem_contact_axis_curve_h
#define auxfem_contact_axis_curve_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

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

  /**
   * A polynomial on [0, 1] by its Bernstein coefficients. All its values lie
   * between the smallest and the largest of them; the first and the last are
   * its values at the ends. G. Farin, Curves and Surfaces for CAGD, 5th ed.,
   * 2002, chapter 6.
   */
  struct BernsteinPolynomial
  {
    static constexpr unsigned int max_degree = 2 * AxisCurve::max_degree;

    unsigned int                       degree = 0;
    std::array<double, max_degree + 1> coefficients;

    double at(double parameter) const;

    /** On [0, 1/2] and [1/2, 1], each over [0, 1]. */
    std::array<BernsteinPolynomial, 2> halves() const;

    /** @name Bounds: all coefficients have this sign or are zero. */
    ///@{
    bool is_nowhere_negative() const;
    bool is_nowhere_positive() const;
    ///@}

    /** Appends the parameters at which the sign changes, in any order; two that
     * are closer together than 1e-9 may count as one. */
    void add_sign_changes(std::vector<double> &parameters) const;
  };

  /** The control points of a curve (m), which lies in their convex hull. */
  struct ControlPolygon
  {
    ControlPolygon() = default;

    /** @param degree at least that of the curve */
    ControlPolygon(const AxisCurve &curve, unsigned int degree);

    unsigned int                                             degree = 0;
    std::array<AxisCurve::Vector, AxisCurve::max_degree + 1> points;
  };

  /** The product of two curves of one degree. */
  BernsteinPolynomial product(const ControlPolygon &one,
                              const ControlPolygon &other);
} // namespace auxfem

#endif
