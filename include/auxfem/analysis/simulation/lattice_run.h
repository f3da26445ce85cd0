#ifndef auxfem_analysis_simulation_lattice_run_h
#define auxfem_analysis_simulation_lattice_run_h

#include <auxfem/analysis/discretization/order_choice.h>
#include <auxfem/output/recorder.h>
#include <auxfem/scene/scene.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/step_report.h>
#include <auxfem/time/time_stepper.h>

#include <functional>

namespace auxfem
{
  /**
   * A lattice scene, set up and advanced through time on all ranks. Used by
   * simulations and by analyses that start from one. Computing functions are
   * collective.
   */
  class LatticeRun
  {
    Work work_done;
    /**
     * Measures the constructor; the members below are constructed meanwhile.
     */
    std::optional<Stopwatch> set_up_watch;

    const std::shared_ptr<const Lattice> shared_lattice;

  public:
    const Scene   &scene; ///< of the plan
    const Lattice &lattice;
    /** Constant except for LatticeModel::explain(). */
    LatticeModel model;
    Equations    equations;
    Solution     solution;

    /**
     * Sets up lattice, model, equations and solver.
     * @param plan whose scene must outlive the object
     *
     * Throws InputError for mistakes in the scene that the lattice reveals.
     */
    LatticeRun(const RunPlan &plan, MPI_Comm communicator);

    /**
     * Uses the plan and lattice of @p other, which must outlive the object,
     * with other effects, as LatticeModel.
     */
    LatticeRun(const LatticeRun &other, SimulatedEffects simulated);

    LatticeRun(const LatticeRun &)            = delete;
    LatticeRun &operator=(const LatticeRun &) = delete;

    /**
     * Checks the scene before the first result: throws InputError if it has a
     * mechanism or redundant constraints, so that the solution is not unique.
     * Then calls start(), unless that searches for static equilibrium.
     */
    void prepare();

    /**
     * Estimates the part of inertia in the response: motion beyond the static
     * response (uncommanded_motion()). Empty without inertia, or if the
     * structure moves freely. Collective; takes a factorization.
     */
    std::optional<EffectMeasure> inertia_measure();

    /** Completes the solution at t = 0, as TimeStepper::start(). */
    void start();

    /** Advances by one step of the scene, as TimeStepper::advance(). */
    StepReport advance(Recorder &recorder);

    /** Error of chosen elements; nullptr without them or before the run. */
    const MeshError *mesh_error() const
    {
      return observer ? &observer->error() : nullptr;
    }

    /**
     * Complete data to resume the run from here: the solution, and the history
     * of the run and of @p recorder. The current run continues exactly as a
     * resumed one, with equal digits.
     */
    CheckpointData checkpoint(Recorder &recorder);

    /**
     * Replaces start(): resumes from @p checkpoint and restores the part of
     * @p recorder, which has begun. Throws InputError if a record is missing.
     */
    void resume(const CheckpointData &checkpoint, Recorder &recorder);

    /**
     * Advances to the end time and reports to @p recorder: steps, checkpoints
     * at equal numbers of steps as the scene requests, and one at the end.
     * Throws Interrupted after a signal.
     */
    void advance_to_end(Recorder &recorder);

    /**
     * Runs from prepare(), or from the checkpoint that @p recorder restarts
     * from, to the end time. Throws InputError and ComputationError; the
     * recorder then has all results so far.
     */
    RunResult run(Recorder &recorder);

    /**
     * Advances a started run, reports to the recorder, and returns findings.
     */
    using Advance = std::function<std::vector<Finding>(Recorder &)>;

    /** As run(), with @p advance in place of advance_to_end(). */
    RunResult run(Recorder &recorder, const Advance &advance);

    /** Watches that check accepted steps. */
    Watches &watches()
    {
      return stepper.watches();
    }

    /** Effort so far; code that advances the run elsewhere adds its own. */
    ///@{
    const Work &work() const
    {
      return work_done;
    }

    Work &work()
    {
      return work_done;
    }
    ///@}

    /** Ends the run where @p limit, which must outlive it, throws. */
    void set_limit(SmallDisplacementLimit &limit);

    /** Effort including that of the limit. */
    Work work_of_all() const;

    /** Adds effort spent elsewhere, except its steps. */
    void add_effort(const Work &elsewhere);

    /** As TimeStepper::solver(), before the run. */
    TangentSolver &solver()
    {
      return stepper.solver();
    }

  private:
    void refuse_undetermined();

    RunResult result(const std::string &exit_state) const;

    /** A checkpoint() at the end of the run, without a restart. */
    CheckpointData last_checkpoint(Recorder &recorder);

    /** Saves or restores the history of run and recorder. */
    void serialize(CheckpointArchive &archive, Recorder &recorder);

    /** Calls prepare() and start(), or resume(), and reports to @p recorder. */
    void begin(Recorder &recorder, bool &has_begun);

    TimeStepper                      stepper;
    SmallDisplacementLimit          *limit = nullptr;
    std::optional<MeshErrorObserver> observer; ///< of chosen elements
  };

  /** Runs a LatticeRun from its set-up to the end time. */
  RunResult
  run_lattice(const Scene &scene, MPI_Comm communicator, Recorder &recorder);

  /** Sets up and starts the run; prints counts and simulated effects. */
  void check_lattice(const Scene &scene, MPI_Comm communicator);
} // namespace auxfem

#endif
