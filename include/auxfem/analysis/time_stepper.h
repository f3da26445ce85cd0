#ifndef auxfem_analysis_time_stepper_h
#define auxfem_analysis_time_stepper_h

#include <auxfem/analysis/consistent_rates.h>
#include <auxfem/analysis/newton.h>
#include <auxfem/analysis/step_ends.h>
#include <auxfem/equations/solution.h>
#include <auxfem/time/step_control.h>

namespace auxfem
{
  /**
   * Takes the lattice through time. A step that does not converge is undone and
   * repeated as the step control says; an unconverged trial never becomes the
   * solution.
   */
  class TimeStepper
  {
  public:
    /**
     * @param equations, work must outlive the object. @p work takes up all that
     *   is done.
     */
    TimeStepper(Equations &equations, const Scene &scene, Work &work);

    /** The state at t = 0, before start(). */
    Solution initial_solution() const;

    /**
     * Brings the initial state into order: prescribed motion, static
     * equilibrium if the scene starts from it, accelerations in equilibrium,
     * energies.
     * Throws ComputationError if there is no equilibrium to be found.
     */
    void start(Solution &solution);

    /**
     * Advances @p solution by one step of the scene. Throws ComputationError if
     * even the smallest step does not converge; @p solution is then the last
     * accepted one.
     */
    StepReport advance(Solution &solution);

    /** For what has to be solved before the start; see Newton. */
    TangentSolver &solver();

  private:
    void find_static_equilibrium(State &state);
    /** Where the next step must end at the latest (s). */
    double next_target(double time, double end_of_scene_step) const;
    /** Whether a load or a support jumps at @p time (s). */
    bool is_jump(double time) const;
    /** Rates just after a load has jumped. */
    void renew_rates(Solution &solution);
    bool try_step(Solution          &solution,
                  const PlannedStep &planned,
                  StepReport        &report);
    /** What is asked of the equations at the end of a step of length @p dt (s). */
    Evaluation evaluation_of(const State &from, double dt);
    void       predict(const Evaluation &step);
    /** Rates of rigid parts put right, in a step that is solved. */
    void              restore_rates(const Evaluation &step);
    bool              creates_energy(const Evaluation &step) const;
    bool              reject(const std::string &reason);
    [[noreturn]] void give_up(const State &state, double dt) const;

    Equations            &equations;
    const TimeParameters  parameters;
    const ImplicitScheme &scheme;
    Work                 &work;
    TangentSolver         tangent_solver;
    Newton                newton;
    Solution              trial;
    const NodeRotations   rotations;
    /** With the mass matrix; only where rates are restored after each step. */
    struct RateSolver
    {
      RateSolver(const Equations        &equations,
                 const SolverParameters &parameters,
                 Work                   &work);

      TangentSolver   solver;
      ConsistentRates rates;
    };
    std::unique_ptr<RateSolver>  rate_solver;
    std::unique_ptr<StepControl> control;
    const std::vector<TimeEvent> events;
    std::string                  last_failure;
  };
} // namespace auxfem

#endif
