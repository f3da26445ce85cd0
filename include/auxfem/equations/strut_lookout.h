#ifndef auxfem_equations_strut_lookout_h
#define auxfem_equations_strut_lookout_h

#include <auxfem/equations/strut_proximity.h>
#include <auxfem/time/state.h>

namespace auxfem
{
  /** Follows a motion that knows no contact, step by step, and tells of struts
   * that come to touch. */
  class StrutLookout
  {
  public:
    /** @param model, curves must outlive the object. Collective. */
    StrutLookout(const LatticeModel              &model,
                 const StrutCurves               &curves,
                 const std::vector<StrutOverlap> &overlaps)
      : model(model)
      , curves(curves)
      , proximity(model, curves, overlaps)
    {}

    /**
     * Two struts that come to touch, or pass each other, on the straight way of
     * a step; none if there are none. Collective.
     * @param from where the step before has ended
     */
    std::optional<std::array<unsigned int, 2>> first_to_touch(const State &from,
                                                              const State &to);

  private:
    const LatticeModel &model;
    const StrutCurves  &curves;
    StrutProximity      proximity;
    bool                is_following = false;
    /** Displacements of all ranks. */
    std::vector<double> before, after;
  };
} // namespace auxfem

#endif
