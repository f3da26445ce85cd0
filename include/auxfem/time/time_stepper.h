#ifndef auxfem_time_time_stepper_h
#define auxfem_time_time_stepper_h

#include <auxfem/scene/step_ends.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/time/consistent_rates.h>
#include <auxfem/time/dense_output.h>
#include <auxfem/time/equilibrium_jumps.h>
#include <auxfem/time/newton.h>
#include <auxfem/time/schemes/step_control.h>
#include <auxfem/time/stages.h>
#include <auxfem/time/step_error.h>
#include <auxfem/time/watch.h>

namespace auxfem
{
  class SmallDisplacementLimit;

  /**
   * Takes the lattice through time. A step that does not converge is undone and
   * repeated as the step control says; an unconverged trial never becomes the
   * solution. All functions but solver() are collective.
   */
  class TimeStepper
  {
  public:
    /**
     * @param equations, work must outlive the object. @p work takes up
     *   all that is done.
     */
    TimeStepper(Equations &equations, Work &work);

    /**
     * Brings Equations::initial_solution() into order: prescribed motion,
     * static equilibrium if the scene starts from it, accelerations in
     * equilibrium, energies.
     * Throws ComputationError if there is no equilibrium to be found.
     */
    void start(Solution &solution);

    /**
     * Advances @p solution by one step of the scene. @p recorder is told of what
     * it asks for within the step. Throws ComputationError if even the smallest
     * step does not converge; @p solution is then the last accepted one.
     */
    StepReport advance(Solution &solution, Recorder &recorder);

    /** Saves or restores what the stepper remembers beside the state. */
    void serialize(CheckpointArchive &archive);

    /**
     * Begins anew at @p solution, an accepted one: what follows depends on its
     * state and on what serialize() restores alone. So a run that is resumed
     * there has equal digits. Finds the results of the state.
     */
    void restart(Solution &solution);

    /** For what has to be solved before the start. */
    TangentSolver &solver()
    {
      return solvers->tangent;
    }

    /**
     * solver() has factorized the stiffness at rest, from which start() or the
     * first step of the scene takes its first tangent.
     */
    void adopt_rest_factorization(const State &rest);

    /** Estimated error of all steps so far, relative, where steps follow it. */
    std::optional<double> estimated_error() const
    {
      return error ? std::optional<double>(error->total()) : std::nullopt;
    }

    /** Those that look at its steps. */
    Watches &watches()
    {
      return scene_watches;
    }

    const Watches &watches() const
    {
      return scene_watches;
    }

    /** Ends the run where @p limit, which must outlive it, throws. */
    void set_limit(SmallDisplacementLimit &new_limit)
    {
      limit = &new_limit;
    }

    /** What the watches have found so far. */
    std::vector<Finding> findings() const;

  private:
    void find_static_equilibrium(State &state);
    /** Finds what comes near something in an accepted state. */
    void update_couplings(State &state);
    /** Why a solved step must be repeated in shorter ones; empty: it need not.
     */
    std::string rejection_reason(const Evaluation &step);
    /** Whatever keeps states or results makes room if ghosts @p are_more. */
    void take_ghosts(bool are_more);
    /**
     * What follows from loads, or motions of supports, that are not smooth at
     * the state. Returns whether the next step follows a jump of them.
     */
    bool
    handle_events(Solution &solution, StepReport &report, Recorder &recorder);
    /**
     * Without inertia: a part of a step in which springs answer loads that have
     * jumped, dashpots do not.
     */
    void
    apply_load_jump(Solution &solution, StepReport &report, Recorder &recorder);
    /** With inertia: rates just after the @p jump. */
    void restart_rates(Solution &solution, StepEnd::Jump jump);
    /**
     * Results and energies of an instant at which rates have been found; where
     * supports have struck, with the work of their impulses.
     * @param before the state just before
     */
    void update_results(Solution              &solution,
                        const State           &before,
                        const ConsistentRates *rates,
                        double                 event);
    /** One accepted step, to @p target (s) at the latest. */
    void advance_substep(Solution   &solution,
                         double      target,
                         StepReport &report,
                         Recorder   &recorder);
    bool try_step(Solution          &solution,
                  const PlannedStep &planned,
                  StepReport        &report,
                  Recorder          &recorder);
    /** The trial of @p step becomes the solution. */
    void accept(Solution &solution, const Evaluation &step, Recorder &recorder);
    bool solve_step(const Evaluation &step, StepReport &report);
    /** By stages, of which the last remains in the trial. */
    bool solve_stages(const Solution   &solution,
                      const Evaluation &step,
                      StepReport       &report);
    /** One implicit step or stage; returns whether it is solved. */
    bool solve(const ImplicitScheme &rule,
               const Evaluation     &step,
               StepReport           &report);
    /** Whether what is solved may become the solution. */
    bool is_acceptable(const Evaluation &step);
    /** Error of @p step over the one that is allowed. */
    double relative_error(const Evaluation &step);
    /** What is asked of the equations at the end of a step of length @p dt (s). */
    Evaluation make_evaluation(const State &from, double dt);
    void       predict(const ImplicitScheme &rule, const Evaluation &step);
    /** Rates of rigid parts put right, in a step that is solved. */
    void              restore_rates(const Evaluation &step);
    bool              creates_energy(const Evaluation &step) const;
    bool              reject(const std::string &reason);
    [[noreturn]] void throw_step_failure(const State &state, double dt) const;

    /** With the mass matrix. */
    struct RateSolver
    {
      RateSolver(const Equations &equations, Work &work)
        : solver(equations, equations.model().plan.solver, work)
        , rates(solver)
      {}

      TangentSolver   solver;
      ConsistentRates rates;
    };

    /** All that keeps factorizations. */
    struct Solvers
    {
      Solvers(const Equations &equations, Work &work)
        : tangent(equations, equations.model().plan.solver, work)
        , newton(tangent, equations.model().plan.newton)
      {}

      TangentSolver tangent;
      Newton        newton;
      /** Only where rates are restored after each step. */
      std::unique_ptr<RateSolver> rates;
    };

    Equations                     &equations;
    const TimeParameters          &parameters;
    const ImplicitScheme          &scheme;
    Work                          &work;
    Solution                       trial;
    const NodeRotations            rotations;
    const std::unique_ptr<Solvers> solvers;
    std::unique_ptr<StepControl>   control;
    /** Only of a scheme that has some. */
    std::optional<Stages> stages;
    const DenseOutput     dense_output;
    /** Only where the length of steps follows their error. */
    std::optional<StepError> error;
    const StepEnds           ends;
    Watches                  scene_watches;
    /** One of the watches; only of nonlinear equilibria. */
    EquilibriumJumps       *jumps = nullptr;
    SmallDisplacementLimit *limit = nullptr;
    std::string             last_failure;
    double                  last_dt = 0; ///< of the last accepted step (s)
    /** Of the last step, over the one that is allowed; 0: it failed for another
     * reason, or did not. */
    double rejected_error = 0;
  };
} // namespace auxfem

#endif
