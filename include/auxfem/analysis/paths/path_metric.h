#ifndef auxfem_analysis_paths_path_metric_h
#define auxfem_analysis_paths_path_metric_h

#include <auxfem/model/lattice_model.h>

namespace auxfem
{
  /**
   * Lengths of increments of all unknowns, the root mean square over the nodes
   * of how far they move, where a rotation counts as that of an arm of the mean
   * strut length; forces of constraints do not count. What computes is
   * collective.
   */
  class PathMetric
  {
  public:
    /** @p model must outlive the object. */
    explicit PathMetric(const LatticeModel &model);

    /** Of two increments, of which rotations are vectors in one frame (m2). */
    double product(const Vector &one, const Vector &other) const;

    double length(const Vector &increment) const; ///< m

    /** The metric as a diagonal matrix, on owned rows (1, m2). */
    const Vector &weights() const
    {
      return weight;
    }

  private:
    const UnknownLayout &layout;
    Vector               weight;
  };
} // namespace auxfem

#endif
