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
   * A scene with a lattice, set up and taken through time on all ranks: what
   * computes is collective.
   */
  class LatticeRun
  {
    Work work_done;
    /** Of the constructor: what follows is made while it runs. */
    std::optional<Stopwatch> set_up_watch;

    const std::shared_ptr<const Lattice> shared_lattice;

  public:
    const Scene   &scene; ///< of the plan
    const Lattice &lattice;
    /** Constant but for what LatticeModel::explain() says. */
    LatticeModel model;
    Equations    equations;
    Solution     solution;

    /**
     * Sets up lattice, model, equations and solver.
     * @param plan whose scene must outlive the object
     *
     * Throws InputError for what the lattice shows to be wrong with the scene.
     */
    LatticeRun(const RunPlan &plan, MPI_Comm communicator);

    /**
     * The plan and lattice of @p other, which must outlive the object, with
     * other effects, as LatticeModel.
     */
    LatticeRun(const LatticeRun &other, SimulatedEffects simulated);

    LatticeRun(const LatticeRun &)            = delete;
    LatticeRun &operator=(const LatticeRun &) = delete;

    /**
     * All that comes before the first result, which a wrong scene does not get
     * past: throws InputError if the scene has no unique solution from the
     * start, since it can move without resistance or constraints follow from
     * others; then start(), but for a search for static equilibrium.
     */
    void prepare();

    /**
     * How much of the answer inertia is: motion that the loads do not command
     * (uncommanded_motion()). Nothing without inertia, and where the structure
     * can move freely. Collective; takes a factorization.
     */
    std::optional<EffectMeasure> inertia_measure();

    /** Brings the solution at t = 0 into order, as TimeStepper::start(). */
    void start();

    /** The next step of the scene, as TimeStepper::advance(). */
    StepReport advance(Recorder &recorder);

    /** The error of chosen elements; nullptr: there are none, or the run has
     * not begun.
     */
    const MeshError *mesh_error() const
    {
      return observer ? &observer->error() : nullptr;
    }

    /**
     * All that a run of the same scene needs to go on from here: the solution
     * now, and what the run and @p recorder, which has been told of it,
     * remember of the way there. The run goes on from here as one that is
     * resumed with it does, with equal digits.
     */
    CheckpointData checkpoint(Recorder &recorder);

    /**
     * In place of start(): goes on from @p checkpoint. @p recorder, which has
     * begun, gets back its part. Throws InputError if a record is missing.
     */
    void resume(const CheckpointData &checkpoint, Recorder &recorder);

    /**
     * Steps to the end time, of which @p recorder is told. Throws Interrupted
     * after a signal. The recorder gets the checkpoints, as many as the scene
     * asks for at equal numbers of steps, and one at the end.
     */
    void advance_to_end(Recorder &recorder);

    /**
     * Everything from refuse_undetermined() or the checkpoint that @p recorder
     * has to go on from, to the end time. Throws InputError and
     * ComputationError; the recorder has then been told of all that was
     * computed, as it has at the end.
     */
    RunResult run(Recorder &recorder);

    /** Takes a run on from its start, tells the recorder of it, and returns
     * what it has found out about the way. */
    using Advance = std::function<std::vector<Finding>(Recorder &)>;

    /** As run(), with @p advance in place of advance_to_end(). */
    RunResult run(Recorder &recorder, const Advance &advance);

    /** What looks at accepted steps. */
    Watches &watches()
    {
      return stepper.watches();
    }

    /** All that has been done so far; whoever takes the run further adds to it.
     */
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

    /** With that of the limit. */
    Work work_of_all() const;

    /** What was done elsewhere counts here too, but for its steps. */
    void add_effort(const Work &elsewhere);

    /** As TimeStepper::solver(), before the run. */
    TangentSolver &solver()
    {
      return stepper.solver();
    }

  private:
    void refuse_undetermined();

    RunResult result(const std::string &exit_state) const;

    /** A checkpoint() after which the run does not go on. */
    CheckpointData last_checkpoint(Recorder &recorder);

    /** Saves or restores all that is remembered of the way. */
    void serialize(CheckpointArchive &archive, Recorder &recorder);

    /** prepare() and start(), or resume(), with @p recorder told of it. */
    void begin(Recorder &recorder, bool &has_begun);

    TimeStepper                      stepper;
    SmallDisplacementLimit          *limit = nullptr;
    std::optional<MeshErrorObserver> observer; ///< of chosen elements
  };

  /** A LatticeRun from its set-up to the end time. */
  RunResult
  run_lattice(const Scene &scene, MPI_Comm communicator, Recorder &recorder);

  /** Its set-up and start; prints counts and what is simulated. */
  void check_lattice(const Scene &scene, MPI_Comm communicator);
} // namespace auxfem

#endif
