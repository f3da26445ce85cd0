#ifndef auxfem_equations_first_contact_detector_h
#define auxfem_equations_first_contact_detector_h

#include <auxfem/equations/strut_proximity.h>
#include <auxfem/time/state.h>

namespace auxfem
{
  /** Follows a motion without contact, step by step, and finds the first struts
   * that touch or pass each other. */
  class FirstContactDetector
  {
  public:
    /** @param model, curves must outlive the object
     * @param at_rest which has followed nothing so far */
    FirstContactDetector(const LatticeModel   &model,
                         const StrutCurves    &curves,
                         const StrutProximity &at_rest)
      : model(model)
      , curves(curves)
      , proximity(at_rest)
    {}

    /**
     * Two struts that touch on the straight way of a step; none if there are
     * none. Collective.
     * @param from where the step before has ended
     */
    std::optional<std::array<unsigned int, 2>> find(const State &from,
                                                    const State &to);

  private:
    const LatticeModel &model;
    const StrutCurves  &curves;
    StrutProximity      proximity;
    bool                is_following = false;
    std::vector<double> room; ///< for what other ranks have
  };
} // namespace auxfem

#endif
