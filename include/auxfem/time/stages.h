#ifndef auxfem_time_stages_h
#define auxfem_time_stages_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/time/schemes/runge_kutta.h>

#include <vector>

namespace auxfem
{
  /**
   * The stages of a step by a Runge-Kutta scheme: base and predictor of each
   * stage, and the slopes that give the step. TimeStepper solves the stages.
   * Internal variables of connectors are integrated by the same scheme.
   *
   * Large rotations in space are integrated as rotation vectors Theta since
   * the start of the step, Theta' = T(Theta)^-1 W with the material angular
   * velocity W. So the scheme keeps its order on the rotation group (H.
   * Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115-127).
   */
  class Stages
  {
  public:
    /** @p equations, @p scheme must outlive the object. */
    Stages(const Equations &equations, const ImplicitScheme &scheme);
    ~Stages();

    /** Number of stages of a step; stage 0 is its start. */
    unsigned int n() const;

    /** The scheme that relates the motion at a stage to its base. */
    const ImplicitScheme &rule() const;

    /**
     * Begins @p step and sets step.to to its start.
     * @param at_start results of the state step.from
     */
    void begin(const Evaluation &step, const EvaluationResults &at_start);

    /**
     * Evaluation of the next stage of @p step; advances step.to to its time.
     */
    Evaluation next(const Evaluation &step);

    /**
     * Stores the slopes of @p stage, the one of the last next().
     * @param results of its solution
     */
    void solved(const Evaluation &stage, const EvaluationResults &results);

    /** Accepts the step as the solution; its slopes predict the next one. */
    void accept();

    /** Discards the slopes that predict the next step. */
    void reset_prediction()
    {
      before.clear();
    }

    /**
     * Difference between the step and that of the embedded scheme (m, m/s,
     * rad).
     */
    struct Difference
    {
      Vector displacement, velocity;
    };

    Difference embedded_difference() const;

  private:
    class Rule;

    /** Rates at a stage. */
    struct Slopes
    {
      Vector              displacement, velocity;
      std::vector<double> internal;
    };

    void find_slopes(const Evaluation &stage);
    void find_kinetic_energy_defect();
    void set_base(const Evaluation &step);
    void guess_acceleration();

    const Equations        &equations;
    const ButcherTableau   &tableau;
    const NodeRotations     rotations;
    const std::vector<int> &multipliers;

    State base;
    /**
     * Displacements at the base; rotations in space since the start of the
     * step.
     */
    Vector base_displacement;
    /** Rotations in space since the start of the step. */
    Vector                rotation_vectors;
    std::unique_ptr<Rule> stage_rule;

    double              dt = 0, end = 0; ///< of the step (s)
    unsigned int        stage = 0;       ///< of the last next()
    std::vector<Slopes> slopes;
    /** See Evaluation. */
    std::vector<Evaluation::Pair> kinetic_defect_terms;

    /** Accelerations at the stages of the previous step; empty without one. */
    std::vector<Vector> before;
    double              dt_before = 0; ///< s
  };
} // namespace auxfem

#endif
