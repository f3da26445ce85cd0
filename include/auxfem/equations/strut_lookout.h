#ifndef auxfem_equations_strut_lookout_h
#define auxfem_equations_strut_lookout_h

#include <auxfem/equations/strut_proximity.h>
#include <auxfem/time/state.h>

namespace auxfem
{
  /**
   * Follows a motion that knows no contact, step by step, and tells of struts
   * that come to touch. With inertia, while none may do so soon, steps are
   * passed over: no more than eight, and no more than nodes take at their pace
   * to move by half of what need not be seen.
   */
  class StrutLookout
  {
  public:
    /** @param model, curves must outlive the object
     * @param at_rest which has followed nothing so far */
    StrutLookout(const LatticeModel   &model,
                 const StrutCurves    &curves,
                 const StrutProximity &at_rest)
      : model(model)
      , curves(curves)
      , proximity(at_rest)
    {}

    /**
     * Two struts that come to touch, or pass each other, on the straight way
     * of a step and those not looked at before it; none if there are none.
     * Collective.
     * @param from where the step before has ended
     */
    std::optional<std::array<unsigned int, 2>> first_to_touch(const State &from,
                                                              const State &to);

  private:
    /** After a look. @param way StrutProximity::way_to() before it (m) */
    void set_distance(double way);

    const LatticeModel &model;
    const StrutCurves  &curves;
    StrutProximity      proximity;
    bool                is_following = false;
    unsigned int        distance     = 1; ///< of looks, steps
    unsigned int        n_unseen     = 0; ///< steps since the last look
    unsigned int        n_steps      = 0; ///< in which nodes have gone way_to()
    std::vector<double> room;             ///< for what other ranks have
  };
} // namespace auxfem

#endif
