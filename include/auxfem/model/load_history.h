#ifndef auxfem_model_load_history_h
#define auxfem_model_load_history_h

#include <auxfem/scene/run_plan.h>

#include <vector>

namespace auxfem
{
  /** Rate of change of the loads and prescribed motions of a scene. */
  struct LoadHistory
  {
    /** Largest rate of a load over its largest value (1/s), limited to what
     * steps resolve: inverse loading time, or angular frequency of an
     * oscillating load. */
    double rate;

    /** Whether a load jumps and excites the highest frequencies. */
    bool is_sudden;

    /** Accumulated relative loss until the end of @p plan from a loss
     * @p per_radian of oscillation; @p per_radian itself for smooth loads. At
     * most 1. */
    double lost(const RunPlan &plan, double per_radian) const;
  };

  /**
   * Finds the load history of a plan; weight counts only without other loads.
   */
  LoadHistory load_history(const RunPlan &plan);

  /**
   * Fraction of free vibration in the response to the loads of @p plan, for the
   * lowest angular frequency @p frequency (1/s). The largest of a load jump,
   * slope jump over the frequency and second derivative over its square,
   * relative to the load; at most 1.
   */
  double uncommanded_motion(const RunPlan &plan, double frequency);

  /**
   * Angular frequency (1/s) that steps of @p plan resolve with 20 steps per
   * period.
   */
  double resolved_frequency(const RunPlan &plan);

  /** Whether loads of @p plan depend on a load factor (State::path). */
  bool has_load_factor(const RunPlan &plan);

  /**
   * Load or prescribed motion as used by the analysis of @p plan: the history
   * itself, or a linear function of the load factor. It runs from 0 (value at t
   * = 0 for a static start) to the value at the reference time at factor 1.
   */
  TimeFunction proportional(const TimeFunction &history, const RunPlan &plan);

  /**
   * Nodes and integrals of the shape functions of an element of run-time order.
   */
  struct LineRule
  {
    explicit LineRule(unsigned int order);

    /** A point of Gauss' rule with the shape functions there, which integrates
     * their products with polynomials of the same degree exactly. */
    struct Point
    {
      double              xi; ///< in [-1, 1]
      double              weight;
      std::vector<double> shapes; ///< by node
    };

    /** Integrals of the shape functions over [-1, 1]. */
    std::vector<double> integrals;
    /** Nodes in [-1, 1]. */
    std::vector<double> nodes;
    std::vector<Point>  points;
  };
} // namespace auxfem

#endif
