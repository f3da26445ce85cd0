#ifndef auxfem_contact_effects_strut_gap_h
#define auxfem_contact_effects_strut_gap_h

#include <auxfem/contact/effects/strut_curves.h>

#include <deal.II/base/bounding_box.h>

namespace auxfem
{
  /** Lower bound of the distance of two curves, within @p tolerance (m). */
  double
  distance(const AxisCurve &one, const AxisCurve &other, double tolerance);

  /** Gap between two axes over the ranges in which they may touch. */
  class StrutGap
  {
  public:
    /** @param curves must outlive the object. */
    explicit StrutGap(const StrutCurves &curves);

    /** Lower bound of the distance minus half the sum of the thicknesses (m);
     * negative for penetration. */
    double operator()(const AxisPair  &pair,
                      const AxisCurve &one,
                      const AxisCurve &other) const;

    /** Rotation (rad) that each of two axes with a common node may undergo
     * before their gap falls below @p least times half the sum of the
     * thicknesses; zero if it already has. A safety factor covers stretch and
     * changes of the nearest points. */
    double rotation_margin(const AxisPair  &pair,
                           const AxisCurve &one,
                           const AxisCurve &other,
                           double           least) const;

    /** Whether both axes are straight and undisplaced. Neighbours then have a
     * positive gap. */
    bool are_lines_at_rest(const AxisPair  &pair,
                           const AxisCurve &one,
                           const AxisCurve &other) const
    {
      return is_line_at_rest(pair[0], one) && is_line_at_rest(pair[1], other);
    }

    /** Whether the gap falls below @p least (m) on the straight path from
     * accepted curves @p from to @p to. */
    bool falls_below(const AxisPair                 &pair,
                     const std::array<AxisCurve, 2> &from,
                     const std::array<AxisCurve, 2> &to,
                     double                          least) const;

  private:
    double gap_between_struts(const AxisPair  &pair,
                              const AxisCurve &one,
                              const AxisCurve &other) const;
    double gap_within_strut(const AxisPair  &pair,
                            const AxisCurve &one,
                            const AxisCurve &other) const;
    /** Closed-form lower bound of rotation_margin() for straight axes at rest;
     * may be negative. */
    double rotation_margin_at_rest(const AxisPair &pair, double least) const;
    /** Whether an axis is straight and undisplaced. */
    bool is_line_at_rest(unsigned int axis, const AxisCurve &curve) const;

    const StrutCurves &curves;
  };

  /**
   * Broad phase: pairs of intersecting boxes from an R-tree. Returns those with
   * the lower number in [begin, end) = @p part, sorted by it.
   */
  std::vector<AxisPair>
  pairs_that_meet(const std::vector<dealii::BoundingBox<3>> &boxes,
                  const std::array<std::size_t, 2>          &part);

  /** Bounding box of an axis with a margin (m). */
  dealii::BoundingBox<3> box_around(const AxisCurve &curve, double margin);

  /** Two struts without a common joint that overlap at rest. */
  struct StrutOverlap
  {
    std::array<unsigned int, 2> struts;
    std::array<unsigned int, 2> lines; ///< the lower ContactAxis::line first
    /** Whether the overlap exceeds half of the mean thickness. Such struts are
     * assumed to lie side by side, for example across the plane, and never
     * touch. */
    bool is_passing;
  };

  /**
   * All overlaps, sorted by strut. Ranks share the work; collective.
   * @param near pairs of axes, including all that overlap at rest
   */
  std::vector<StrutOverlap> find_overlaps(const StrutCurves           &curves,
                                          const std::vector<AxisPair> &near,
                                          const UnknownLayout         &layout);
} // namespace auxfem

#endif
