#ifndef auxfem_equations_strut_gap_h
#define auxfem_equations_strut_gap_h

#include <auxfem/equations/strut_curves.h>

namespace auxfem
{
  /** Distance of two curves, or less by at most @p tolerance (m). */
  double
  distance(const AxisCurve &one, const AxisCurve &other, double tolerance);

  /**
   * How far two axes are from touching, with their thickness, where they may
   * touch at all.
   */
  class StrutGap
  {
  public:
    /** @param curves must outlive the object. */
    explicit StrutGap(const StrutCurves &curves);

    /** Least distance of two axes less half the sum of their thicknesses (m),
     * or a little less; negative where they touch. */
    double operator()(const AxisPair  &pair,
                      const AxisCurve &one,
                      const AxisCurve &other) const;

    /**
     * By how much the tangents of two axes with a common node may turn each
     * (rad) before a gap becomes smaller than the part @p least of half the sum
     * of their thicknesses, or less than that; zero where it is smaller.
     * With some safety for what it does not see: that other points than
     * those which are nearest now come near, and that the axes stretch.
     */
    double turning_left(const AxisPair  &pair,
                        const AxisCurve &one,
                        const AxisCurve &other,
                        double           least) const;

    /** Whether a gap becomes smaller than @p least (m) on the straight way from
     * curves to others, of which the first ones are not. */
    bool comes_below(const AxisPair                 &pair,
                     const std::array<AxisCurve, 2> &from,
                     const std::array<AxisCurve, 2> &to,
                     double                          least) const;

  private:
    double of_ranges(const AxisPair  &pair,
                     const AxisCurve &one,
                     const AxisCurve &other) const;
    double of_strut(const AxisPair  &pair,
                    const AxisCurve &one,
                    const AxisCurve &other) const;

    const StrutCurves &curves;
  };
} // namespace auxfem

#endif
