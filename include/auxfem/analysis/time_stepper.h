#ifndef auxfem_analysis_time_stepper_h
#define auxfem_analysis_time_stepper_h

#include <auxfem/analysis/consistent_rates.h>
#include <auxfem/analysis/newton.h>

namespace auxfem
{
  /**
   * Takes the lattice through time. A step that does not converge is undone and
   * done in halves, these in halves again, down to the smallest step; an
   * unconverged trial never becomes the state.
   */
  class TimeStepper
  {
  public:
    /** Lets @p system carry what the scheme needs. */
    TimeStepper(System &system, const Scene &scene);

    /** Number of steps to the end time. */
    unsigned long n_steps() const;

    /**
     * Brings the initial state into order: prescribed motion, static
     * equilibrium if the scene starts from it, accelerations in equilibrium,
     * energies.
     * Throws ComputationError if there is no equilibrium to be found.
     */
    void start(State &state);

    /**
     * Advances @p state by one step of the scene. Throws ComputationError if
     * even the smallest step does not converge; @p state is then the last
     * accepted one.
     */
    StepReport advance(State &state);

    Newton &newton();

  private:
    /**
     * Brings all that effects keep for output (forces of connectors, strain
     * energy) to those of an accepted state, without a step.
     */
    void evaluate_accepted(State &state);

    void              complete_start(State &state);
    [[noreturn]] void give_up(State &state, double dt);
    Newton::Result    solve_trial(State &state, const Step &step);
    bool              creates_energy(const Step &step) const;
    bool try_step(State &state, double time, double dt, StepReport &report);

    System               &system;
    TimeParameters        parameters;
    const ImplicitScheme &scheme;
    Newton                solver;
    State                 trial;
    /** With the mass matrix; only where rates are restored after each step. */
    struct RateSolver
    {
      RateSolver(System &system, const SolverParameters &parameters);

      std::unique_ptr<TangentMatrix> matrix;
      LinearSolver                   linear_solver;
      ConsistentRates                rates;
    };
    std::unique_ptr<RateSolver> rate_solver;
    std::string                 last_failure;
    /** Total or dissipated, of all accepted states (J). */
    double largest_energy = 0;
  };
} // namespace auxfem

#endif
