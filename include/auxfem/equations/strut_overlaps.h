#ifndef auxfem_equations_strut_overlaps_h
#define auxfem_equations_strut_overlaps_h

#include <auxfem/equations/strut_curves.h>

#include <deal.II/base/bounding_box.h>

namespace auxfem
{
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
