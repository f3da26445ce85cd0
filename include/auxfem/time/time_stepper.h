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
   * Advances the lattice by steps of the scene; LatticeRun owns it. A scene
   * step consists of substeps, each predicted, solved by Newton's method,
   * judged, and accepted or repeated as StepControl decides. A rejected trial
   * never becomes the solution. All functions but solver() are collective.
   */
  class TimeStepper
  {
  public:
    /**
     * @param equations, work must outlive the object. @p work counts the effort
     *   of all steps.
     */
    TimeStepper(Equations &equations, Work &work);

    /**
     * Completes Equations::initial_solution(): prescribed motion, static
     * equilibrium if the scene starts from it, consistent accelerations,
     * energies. Throws ComputationError if no equilibrium is found.
     */
    void start(Solution &solution);

    /**
     * Advances @p solution by one step of the scene and passes to @p recorder
     * the solutions that it requests within the step. Throws ComputationError
     * if even the smallest step does not converge; @p solution is then the last
     * accepted one.
     */
    StepReport advance(Solution &solution, Recorder &recorder);

    /** Saves or restores the stepper's own data beside the state. */
    void serialize(CheckpointArchive &archive);

    /**
     * Restarts from the accepted @p solution, so that later steps depend only
     * on its state and on the data of serialize(). A resumed run then has equal
     * digits. Evaluates the results of the state.
     */
    void restart(Solution &solution);

    /** Solver for systems that are solved before start(). */
    TangentSolver &solver()
    {
      return solvers->tangent;
    }

    /**
     * Reuses the stiffness at rest, which solver() has factorized, as the first
     * tangent of start() or of the first step.
     */
    void adopt_rest_factorization(const State &rest);

    /** Estimated relative error of all steps so far; empty without step-size
     * control. */
    std::optional<double> estimated_error() const
    {
      return error ? std::optional<double>(error->total()) : std::nullopt;
    }

    /** Watches that check the accepted steps. */
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

    /** Findings of the watches and of the step error so far. */
    std::vector<Finding> findings() const;

  private:
    void find_static_equilibrium(State &state);

    /** Gives the history of materials the initial strains at t = 0. */
    void strain_materials(State &state);

    /** @name One step of the scene, in the order of its execution. */
    ///@{
    /** Detects contact candidates in an accepted state. */
    void update_couplings(State &state);
    /** Enlarges states and results if ghosts @p are_more. */
    void extend_ghosts(bool are_more);
    /**
     * Handles a kink or jump of loads or support motions at the state. Returns
     * whether the next step begins with a jump.
     */
    bool
    handle_events(Solution &solution, StepReport &report, Recorder &recorder);
    /** With inertia: finds rates just after the @p jump. */
    void restart_rates(Solution &solution, StepEnd::Jump jump);
    /**
     * Evaluates results and energies after new rates, with the work of support
     * impulses.
     * @param before the state just before
     */
    void update_results(Solution              &solution,
                        const State           &before,
                        const ConsistentRates *rates,
                        double                 event);
    /**
     * Without inertia: applies jumped loads in a very short step, to which
     * springs respond but dashpots do not.
     */
    void
    apply_load_jump(Solution &solution, StepReport &report, Recorder &recorder);
    /** Advances by one accepted step, to @p target (s) at the latest. */
    void advance_substep(Solution   &solution,
                         double      target,
                         StepReport &report,
                         Recorder   &recorder);
    bool try_step(Solution          &solution,
                  const PlannedStep &planned,
                  StepReport        &report,
                  Recorder          &recorder);
    /** Evaluation at the end of a step of length @p dt (s). */
    Evaluation make_evaluation(const State &from, double dt);
    /** Solves a step of a scheme without stages. */
    bool solve_step(const Evaluation &step, StepReport &report);
    /** Solves all stages; the last one remains in the trial. */
    bool solve_stages(const Solution   &solution,
                      const Evaluation &step,
                      StepReport       &report);
    void predict(const ImplicitScheme &rule, const Evaluation &step);
    /** Solves one implicit step or stage by Newton's method. */
    bool solve(const ImplicitScheme &rule,
               const Evaluation     &step,
               StepReport           &report);
    /** Restores consistent rates of rigid parts in a solved step. */
    void restore_rates(const Evaluation &step);
    /** Whether the solved trial may become the solution. */
    bool is_acceptable(const Evaluation &step);
    /** Why contact demands a shorter step; empty: it does not. */
    std::string rejection_reason(const Evaluation &step);
    bool        creates_energy(const Evaluation &step) const;
    /** Estimated error of @p step over the allowed one. */
    double relative_error(const Evaluation &step);
    /** Makes the trial of @p step the solution. */
    void accept(Solution &solution, const Evaluation &step, Recorder &recorder);
    bool reject(const std::string &reason);
    [[noreturn]] void throw_step_failure(const State &state, double dt) const;
    ///@}

    /** Solver and rates with the mass matrix. */
    struct RateSolver
    {
      RateSolver(const Equations &equations, Work &work)
        : solver(equations, equations.model().plan.solver, work)
        , rates(solver)
      {}

      TangentSolver   solver;
      ConsistentRates rates;
    };

    /** All objects that store factorizations. */
    struct Solvers
    {
      Solvers(const Equations &equations, Work &work)
        : tangent(equations, equations.model().plan.solver, work)
        , newton(tangent, equations.model().plan.newton)
      {}

      TangentSolver tangent;
      Newton        newton;
      /** Present if rates are restored after each step. */
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
    /** Present for schemes with stages. */
    std::optional<Stages> stages;
    const DenseOutput     dense_output;
    /** Present with step-size control. */
    std::optional<StepError> error;
    const StepEnds           ends;
    Watches                  scene_watches;
    /** One of the watches; only in nonlinear statics. */
    EquilibriumJumps       *jumps = nullptr;
    SmallDisplacementLimit *limit = nullptr;
    std::string             last_failure;
    double                  last_dt = 0; ///< of the last accepted step (s)
    /** Error of the last trial over the allowed one; 0 unless it was rejected
     * for its error. */
    double rejected_error = 0;
  };
} // namespace auxfem

#endif
