#ifndef auxfem_analysis_watch_h
#define auxfem_analysis_watch_h

#include <auxfem/analysis/run_statistics.h>
#include <auxfem/analysis/sampling_schedule.h>
#include <auxfem/analysis/tangent_solver.h>
#include <auxfem/output/verdict.h>

#include <memory>
#include <optional>

namespace auxfem
{
  /**
   * Checks accepted steps of a run, and judges the run at the end. What a watch
   * has found so far is kept in RunStatistics. All functions are collective.
   */
  class Watch
  {
  public:
    explicit Watch(const SamplingRate rate = SamplingRate::every_step)
      : rate(rate)
    {}

    virtual ~Watch() = default;

    /** The state at t = 0, in order. */
    virtual void start(const State & /*state*/)
    {}

    /**
     * A step of those that `rate` asks for, or a part of one, is solved and
     * accepted; step.to has its energies.
     * @param results of its end
     * @param solver of Newton's method, with the factorization it keeps
     */
    virtual void step(const Evaluation        &step,
                      const EvaluationResults &results,
                      TangentSolver           &solver) = 0;

    /** The next step does not follow on the last one that was checked: what is
     * remembered of steps means nothing any more. */
    virtual void forget_steps()
    {}

    /**
     * Whether the ends of a static step, solved but not yet accepted, have
     * different numbers of negative modes.
     * @param solver as step()
     */
    virtual bool changes_stability(const Evaluation & /*step*/,
                                   TangentSolver & /*solver*/)
    {
      return false;
    }

    /** The next step leads to another equilibrium than the connected one, which
     * is known: the energy that is set free is no error. */
    virtual void expect_jump()
    {}

    /** What it makes of the run so far; the same on all ranks. */
    virtual std::vector<Finding> findings() const = 0;

    /** Largest depth of struts in plates or other struts so far, over their
     * thickness; none if the watch does not check that. */
    virtual std::optional<double> largest_penetration() const
    {
      return std::nullopt;
    }

    /** What is not in RunStatistics. */
    virtual void serialize(CheckpointArchive & /*archive*/)
    {}

    const SamplingRate rate;
  };

  /**
   * ` (Time/Time step = ... s). A step of ... s would miss 1 %.`: the end of
   * what a watch says of steps that miss too much.
   * @param scene_step that of the scene (s)
   * @param missed part that its steps miss
   */
  std::string shorter_step_text(double                scene_step,
                                const ImplicitScheme &scheme,
                                double                missed);

  /** All watches that the scene gives cause for, one per file, with the
   * schedule by which they check steps. */
  class Watches
  {
  public:
    /** @param equations, work must outlive the object; @p work takes up
     * what they do. */
    Watches(const Equations &equations, Work &work);

    /** One more, which checks what the others do not; returns it. Before
     * start(). */
    template <class Added>
    Added *add(std::unique_ptr<Added> watch)
    {
      Added *const added = watch.get();
      watches.push_back(std::move(watch));
      return added;
    }

    void start(const State &state);

    /** An accepted step: tells the watches that sample it. */
    void step(const Evaluation        &step,
              const EvaluationResults &results,
              TangentSolver           &solver);

    /** At a checkpoint: drops what is remembered of steps before it, so that a
     * run that is resumed there finds the same. */
    void forget_steps();

    /** Whether one says so. */
    bool changes_stability(const Evaluation &step, TangentSolver &solver);

    /** Says so to all. */
    void expect_jump()
    {
      for (const auto &watch : watches)
        watch->expect_jump();
    }

    /** Of all, the worst first. */
    std::vector<Finding> findings() const;

    /** Of the one that checks that. */
    std::optional<double> largest_penetration() const;

    void serialize(CheckpointArchive &archive);

  private:
    const SamplingSchedule              schedule;
    RunStatistics                       statistics;
    std::vector<std::unique_ptr<Watch>> watches;
    /** Whether the step before was in a burst, and is remembered. */
    bool follows_burst = false;
  };

  /** What watches of a run refer to; all must outlive them. */
  struct WatchedRun
  {
    const RunPlan   &plan;
    const Equations &equations;
    RunStatistics   &statistics;
    Work            &work; ///< takes up what watches do
  };

  using MakeWatch = std::unique_ptr<Watch>(const WatchedRun &);

  /** @name The watches; watch.cc says which scenes have which. */
  ///@{
  /** Energy that is not accounted for, or that a scheme with inertia gives or
   * takes. */
  MakeWatch make_energy_watch;
  /** Steps that are too long for the motion. With inertia. */
  MakeWatch make_step_watch;
  /** Loads that change within steps. With inertia. */
  MakeWatch make_load_step_watch;
  /** Strains for which no linear law stands; the scene has elastic struts. */
  MakeWatch make_strain_watch;
  /** Strains beyond those at which sections yield; a section has one. */
  MakeWatch make_yield_watch;
  /** Struts that buckle between their joints, which their elements do not
   * show; the scene has elastic struts. */
  MakeWatch make_local_buckling_watch;
  /** Bending that elements of order 1 miss; none without such elements. The
   * scene simulates shear flexibility, without which they bend as they should.
   */
  MakeWatch make_bending_watch;
  /** Bending waves shorter than elements resolve; the scene has elastic struts,
   * and inertia. */
  MakeWatch make_wave_watch;
  /** Connectors that are shortened to nothing; the scene has some. */
  MakeWatch make_connector_watch;
  /** Struts that go deep into plates or struts; the scene has contact. */
  MakeWatch make_contact_watch;
  /** Impacts that steps do not resolve. With inertia; the scene has contact. */
  MakeWatch make_impact_watch;
  /** Loads that are too fast to leave inertia out, where time has a meaning. */
  MakeWatch make_load_speed_watch;
  /** Struts that touch or pass through each other; the scene has elastic
   * struts. */
  MakeWatch make_crossing_watch;
  /** Struts that go through plates where contact is left out; the scene has
   * plates. */
  MakeWatch make_plate_crossing_watch;
  /** Displacements too large for the small-displacement form. */
  MakeWatch make_small_displacement_watch;
  /** Free lattices in space whose spin makes errors grow beyond the tolerance
   * that the steps follow. Without rigid parts. */
  MakeWatch make_spin_watch;
  /** Equilibria and motions that a disturbance would leave. */
  MakeWatch make_stability_watch;
  ///@}
} // namespace auxfem

#endif
