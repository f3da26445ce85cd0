#ifndef auxfem_analysis_stable_motions_h
#define auxfem_analysis_stable_motions_h

#include <auxfem/analysis/small_displacement_error.h>
#include <auxfem/time/records.h>

namespace auxfem
{
  /**
   * Which motions are trusted to be stable, as one is that was looked at: those
   * of no more size, in which no more presses the struts.
   */
  class StableMotions
  {
  public:
    /** Compression (SmallDisplacementError) of a strut by which hardly anything
     * buckles. */
    static constexpr double little_compression = 1e-2;

    /** @param estimate by which motions are compared; must outlive the object,
     *   as @p layout */
    StableMotions(const SmallDisplacementEstimate &estimate,
                  const UnknownLayout             &layout);

    /** Whether one of @p size (m) with the compressions of @p now is among
     * them. Collective. */
    bool have(double size, const SmallDisplacementError &now) const;

    /** So many @p times the one looked at, and no others. */
    void
    trust(double times, double size, const SmallDisplacementError &looked_at);

    /** @name For runs that are resumed. */
    ///@{
    void save(Records &records) const;
    void resume(const Records &records);
    ///@}

  private:
    const SmallDisplacementEstimate &estimate;
    const UnknownLayout             &layout;
    double                           largest_size        = 0; ///< m
    double                           largest_compression = 0;
    std::vector<double>              compressions; ///< by strut
  };
} // namespace auxfem

#endif
