#ifndef auxfem_contact_bernstein_polynomial_h
#define auxfem_contact_bernstein_polynomial_h

#include <auxfem/contact/axis_curve.h>

#include <vector>

namespace auxfem
{
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
