#ifndef auxfem_time_stages_h
#define auxfem_time_stages_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/time/schemes/runge_kutta.h>

#include <vector>

namespace auxfem
{
  /**
   * The stages of steps by a Runge-Kutta scheme, one after the other: base and
   * first guess of each, and what their slopes say of the step. Internal
   * variables of connectors are integrated by the same scheme.
   *
   * Of large rotations in space it is the rotation vector Theta since the start
   * of the step that is integrated, Theta' = T(Theta)^-1 W with the material
   * angular velocity W: so the scheme keeps its order on the rotation group (H.
   * Munthe-Kaas, Appl. Numer. Math. 29 (1999) 115-127).
   */
  class Stages
  {
  public:
    /** @p equations, @p scheme must outlive the object. */
    Stages(const Equations &equations, const ImplicitScheme &scheme);
    ~Stages();

    /** Of a step; number 0 is its start. */
    unsigned int n() const;

    /** What ties the motion at a stage to its base. */
    const ImplicitScheme &rule() const;

    /**
     * Begins @p step, with step.to as at its start.
     * @param at_start of the state step.from
     */
    void begin(const Evaluation &step, const EvaluationResults &at_start);

    /** What is asked of the equations at the next stage of @p step; takes
     * step.to to its time. */
    Evaluation next(const Evaluation &step);

    /** Takes up the @p stage asked for last; @p results are its solution's. */
    void solved(const Evaluation &stage, const EvaluationResults &results);

    /** The step becomes the solution: the next is predicted by it. */
    void accept();

    /** What follows is not predicted by what has been. */
    void reset_prediction()
    {
      before.clear();
    }

    /** By how much the step differs from that of the embedded scheme. */
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
    /** Displacements at the base, of rotations in space since the start. */
    Vector base_displacement;
    /** Only of rotations in space: where they are since the start. */
    Vector                rotation_vectors;
    std::unique_ptr<Rule> stage_rule;

    double              dt = 0, end = 0; ///< of the step (s)
    unsigned int        stage = 0;       ///< asked for last
    std::vector<Slopes> slopes;
    /** See Evaluation. */
    std::vector<Evaluation::Pair> taken_from_kinetic;

    /** Accelerations at the stages of the step before; empty: there is none. */
    std::vector<Vector> before;
    double              dt_before = 0; ///< s
  };
} // namespace auxfem

#endif
