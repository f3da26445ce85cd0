#ifndef auxfem_contact_effects_strut_gap_h
#define auxfem_contact_effects_strut_gap_h

#include <auxfem/contact/effects/strut_curves.h>

#include <deal.II/base/bounding_box.h>

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
    double rotation_margin(const AxisPair  &pair,
                           const AxisCurve &one,
                           const AxisCurve &other,
                           double           least) const;

    /** Whether two axes are straight and where they are at rest: neighbours
     * are then farther apart than they are thick where they may touch. */
    bool are_lines_at_rest(const AxisPair  &pair,
                           const AxisCurve &one,
                           const AxisCurve &other) const
    {
      return is_line_at_rest(pair[0], one) && is_line_at_rest(pair[1], other);
    }

    /** Whether a gap becomes smaller than @p least (m) on the straight way from
     * curves to others, of which the first ones are not. */
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
    /** rotation_margin() of axes that are straight and at rest, or less, also
     * than zero, without a look at points. */
    double rotation_margin_at_rest(const AxisPair &pair, double least) const;
    /** Whether an axis is straight and where it is at rest. */
    bool is_line_at_rest(unsigned int axis, const AxisCurve &curve) const;

    const StrutCurves &curves;
  };

  /** Pairs of boxes that have points in common, from a tree of them (R-tree):
   * those of which the lower number is in a part [begin, end) of them, sorted
   * by that. */
  std::vector<AxisPair>
  pairs_that_meet(const std::vector<dealii::BoundingBox<3>> &boxes,
                  const std::array<std::size_t, 2>          &part);

  /** Box of an axis with a margin (m) around it. */
  dealii::BoundingBox<3> box_around(const AxisCurve &curve, double margin);

  /** Two struts without a common joint that are nearer to each other at rest
   * than their thickness. */
  struct StrutOverlap
  {
    std::array<unsigned int, 2> struts; ///< the lower number first
    /** Whether one goes through the other: by more than half of half the sum of
     * their thicknesses. Only side by side, across the plane say, they can be
     * real; then they never touch. */
    bool is_passing;
  };

  /** All of them, by numbers of struts. Ranks share the work; collective.
   * @param near pairs of axes, with all that are nearer to each other at rest
   *   than their thickness */
  std::vector<StrutOverlap> find_overlaps(const StrutCurves           &curves,
                                          const std::vector<AxisPair> &near,
                                          const UnknownLayout         &layout);
} // namespace auxfem

#endif
