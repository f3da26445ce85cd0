#ifndef auxfem_contact_axis_curve_h
#define auxfem_contact_axis_curve_h

#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace auxfem
{
  /**
   * The current axis of an element as a polynomial of a parameter in [0, 1],
   * given by its monomial coefficients. Pure geometry.
   */
  struct AxisCurve
  {
    using Vector = dealii::Tensor<1, 3>;

    /** Suffices for struts of order 6 and arcs up to a full circle. */
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

    /** Derivative with respect to the parameter (m). */
    Vector tangent(const double parameter) const
    {
      Vector result = degree * coefficients[degree];
      for (unsigned int k = degree; k-- > 1;)
        result = k * coefficients[k] + parameter * result;
      return result;
    }

    /** Second derivative with respect to the parameter (m). */
    Vector bend(const double parameter) const
    {
      Vector result;
      for (unsigned int k = degree; k > 1; --k)
        result = k * (k - 1.) * coefficients[k] + parameter * result;
      return result;
    }
  };

  /** The point of a curve nearest to a given point. */
  struct NearestPoint
  {
    double parameter;
    double distance; ///< m
    /** Whether the connecting line is normal to the curve; otherwise the
     * nearest point is an end of the searched interval. */
    bool is_inside;
  };

  /**
   * Finds the point of @p curve nearest to @p point between two parameters.
   * Samples bracket the minima, and a safeguarded Newton iteration refines
   * each.
   */
  NearestPoint nearest_point(const AxisCurve         &curve,
                             const AxisCurve::Vector &point,
                             double                   begin = 0,
                             double                   end   = 1);

  /** Straight chords along a curve, which bound distances from it at a small
   * part of the cost of nearest_point(). */
  class CurveChords
  {
  public:
    explicit CurveChords(const AxisCurve &curve);

    /** A distance that no point of the curve falls below (m); it is less than
     * that of the nearest point by twice the deviation of the chords at most.
     */
    double least_distance(const AxisCurve::Vector &point) const;

  private:
    static constexpr unsigned int n = 4;

    std::array<AxisCurve::Vector, n> begins, chords;
    std::array<double, n>            inverse_squares; ///< of lengths (1/m2)
    double                           deviation;       ///< of the curve (m)
  };

  /**
   * A polynomial on [0, 1] in the Bernstein basis. Its values lie between the
   * smallest and the largest coefficient; the first and last coefficients are
   * its end values. G. Farin, Curves and Surfaces for CAGD, 5th ed., 2002,
   * chapter 6.
   */
  struct BernsteinPolynomial
  {
    static constexpr unsigned int max_degree = 2 * AxisCurve::max_degree;

    unsigned int                       degree = 0;
    std::array<double, max_degree + 1> coefficients;

    double at(double parameter) const;

    /** Restrictions to [0, 1/2] and [1/2, 1], each mapped to [0, 1]. */
    std::array<BernsteinPolynomial, 2> halves() const;

    /** @name Bounds: all coefficients have this sign or are zero. */
    ///@{
    bool is_nowhere_negative() const;
    bool is_nowhere_positive() const;
    ///@}

    /** Appends the unsorted parameters of sign changes; two within 1e-9 may be
     * reported as one. */
    void add_sign_changes(std::vector<double> &parameters) const;
  };

  /**
   * Bezier control points of a curve (m). The curve lies in their convex hull.
   */
  struct ControlPolygon
  {
    ControlPolygon() = default;

    /** @param degree not less than that of the curve */
    ControlPolygon(const AxisCurve &curve, unsigned int degree);

    unsigned int                                             degree = 0;
    std::array<AxisCurve::Vector, AxisCurve::max_degree + 1> points;
  };

  /** Scalar product of two curves of equal degree. */
  BernsteinPolynomial product(const ControlPolygon &one,
                              const ControlPolygon &other);
} // namespace auxfem

#endif
