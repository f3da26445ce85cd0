#ifndef auxfem_model_load_history_h
#define auxfem_model_load_history_h

#include <auxfem/scene/run_plan.h>

#include <vector>

namespace auxfem
{
  /** How fast the loads and prescribed motions of a scene change. */
  struct LoadHistory
  {
    /**
     * The largest rate of one of them over its largest value (1/s), as far as
     * steps resolve it: the inverse of the loading time, the angular frequency
     * of a load that oscillates.
     */
    double rate;

    /** Whether something jumps, so that the structure swings as fast as it
     * can. */
    bool is_sudden;

    /**
     * What becomes of a relative loss @p per_radian of oscillations until the
     * end of @p plan; of loads that follow one course it is the change itself.
     * At most 1.
     */
    double lost(const RunPlan &plan, double per_radian) const;
  };

  /** Weight counts as a load if there is no other. */
  LoadHistory load_history(const RunPlan &plan);

  /**
   * How much of the answer is motion that the loads of @p plan do not command,
   * of a structure with the lowest angular frequency @p frequency (1/s): the
   * largest jump of a load, of its slope over the frequency, and second
   * derivative over its square, over its largest value; at most 1.
   */
  double uncommanded_motion(const RunPlan &plan, double frequency);

  /** Angular frequency (1/s) of an oscillation of which steps of @p plan
   * make a period of twenty. */
  double resolved_frequency(const RunPlan &plan);

  /** Whether the analysis of @p plan takes loads as functions of a load factor
   * (State::path). */
  bool has_load_factor(const RunPlan &plan);

  /**
   * A load or prescribed motion as the analysis of @p plan takes it: as it is
   * given, or a function of the load factor: at 0 it is 0 or, with a start from
   * static equilibrium, what it is at t = 0; at 1 what it is at the time of the
   * loads that the analysis has been given.
   */
  TimeFunction proportional(const TimeFunction &history, const RunPlan &plan);

  /** Shape functions of an element of polynomial order p, p not fixed when
   * compiled. */
  struct LineRule
  {
    explicit LineRule(unsigned int order);

    /** Integrals of the shape functions over [-1, 1]. */
    std::vector<double> integrals;
    /** Their nodes in [-1, 1]. */
    std::vector<double> nodes;
  };
} // namespace auxfem

#endif
