#ifndef auxfem_time_watch_h
#define auxfem_time_watch_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/output/verdict.h>
#include <auxfem/state/checkpoint_archive.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** An event at a part of the structure, as found by a watch. */
  struct LocatedEvent
  {
    double       size;      ///< severity, in the watch's unit
    double       time;      ///< s
    unsigned int number;    ///< of the strut or joint
    unsigned int group = 0; ///< of the connector, or of the other part involved
  };

  /**
   * First and largest event of a kind during a run; each rank adds those of
   * its own parts.
   */
  class EventExtremes
  {
  public:
    explicit EventExtremes(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /** Events must be added in the order of time. */
    void add(const LocatedEvent &occurrence);

    /** Largest event of this rank. */
    const std::optional<LocatedEvent> &largest_here() const
    {
      return largest_event;
    }

    /** @name Of all ranks, equal on each; collective. */
    ///@{
    std::optional<LocatedEvent> first() const;
    std::optional<LocatedEvent> largest() const;
    ///@}

    /** Collective. */
    void serialize(const std::string &name, CheckpointArchive &archive);

  private:
    const MPI_Comm              communicator;
    std::optional<LocatedEvent> first_event, largest_event;
  };

  /**
   * Everything that watches store in a checkpoint. Each watch refers to
   * entries whose names begin with its own. All but events are equal on all
   * ranks.
   */
  class RunStatistics
  {
  public:
    explicit RunStatistics(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    RunStatistics(const RunStatistics &)            = delete;
    RunStatistics &operator=(const RunStatistics &) = delete;

    /** @name Entry of this name, created on first access. */
    ///@{
    double &number(const std::string &name, const double initial = 0)
    {
      return numbers.try_emplace(name, initial).first->second;
    }

    LargestInTime &largest(const std::string &name)
    {
      return maxima[name];
    }

    EventExtremes &occurrences(const std::string &name)
    {
      return events.try_emplace(name, communicator).first->second;
    }

    std::vector<double> &list(const std::string &name)
    {
      return lists[name];
    }

    std::string &text(const std::string &name)
    {
      return texts[name];
    }
    ///@}

    /** Collective. */
    void serialize(CheckpointArchive &archive);

  private:
    const MPI_Comm                             communicator;
    std::map<std::string, double>              numbers;
    std::map<std::string, LargestInTime>       maxima;
    std::map<std::string, EventExtremes>       events;
    std::map<std::string, std::vector<double>> lists;
    std::map<std::string, std::string>         texts;
  };

  /** Steps that a watch checks. Without inertia every step is checked. */
  enum class SamplingRate
  {
    every_step,
    /**
     * Several consecutive steps at intervals, in linear scenes, where a check
     * costs about as much as a step; every step in nonlinear ones.
     */
    bursts,
    /**
     * The first step of each burst, also in nonlinear scenes; for checks that
     * cost an evaluation.
     */
    single_steps
  };

  /**
   * Decides which steps are sampled. The choice depends only on the step
   * number, so resumed runs sample the same steps. The last steps always are.
   */
  class SamplingSchedule
  {
  public:
    /**
     * Largest sampling interval.
     * @tuned [steps] measured: samples cost a few per cent of linear steps; a
     *   prime number lets no vibration hide between samples
     */
    static constexpr unsigned long longest_period = 13;

    /**
     * Smallest number of samples in a run with more steps.
     * @tuned judgement
     */
    static constexpr unsigned long min_samples = 20;

    explicit SamplingSchedule(const Equations &equations)
      : has_inertia(equations.model().plan.simulated.inertia)
      , is_linear(equations.is_linear())
      , n_steps(equations.model().plan.time.n_steps())
      , period(
          std::min(longest_period, (n_steps + min_samples - 1) / min_samples))
    {}

    /** @param number of the step, from 0 */
    bool is_sampled(const SamplingRate rate, const unsigned long number) const
    {
      if (rate == SamplingRate::every_step || !has_inertia)
        return true;
      if (rate == SamplingRate::single_steps)
        return number % period == 0 || number + 1 >= n_steps;
      return !is_linear || number % period < burst || number + burst >= n_steps;
    }

  private:
    /** Consecutive steps needed for a third difference. */
    static constexpr unsigned long burst = 3;

    const bool          has_inertia, is_linear;
    const unsigned long n_steps, period;
  };

  /**
   * Checks accepted steps of a run and judges the run at the end. Results so
   * far are stored in RunStatistics. All functions are collective.
   */
  class Watch
  {
  public:
    explicit Watch(const SamplingRate rate = SamplingRate::every_step)
      : rate(rate)
    {}

    virtual ~Watch() = default;

    /** Called with the consistent state at t = 0. */
    virtual void start(const State & /*state*/)
    {}

    /**
     * Called after a sampled step, or a part of one, is accepted; step.to has
     * its energies.
     * @param results at its end
     * @param solver Newton's, with its current factorization
     */
    virtual void step(const Evaluation        &step,
                      const EvaluationResults &results,
                      TangentSolver           &solver) = 0;

    /**
     * Drops data of earlier steps: the next step does not follow the last one
     * checked.
     */
    virtual void forget_steps()
    {}

    /**
     * Whether the number of negative modes changes within a static step that
     * is solved but not yet accepted.
     * @param solver as in step()
     */
    virtual bool changes_stability(const Evaluation & /*step*/,
                                   TangentSolver & /*solver*/)
    {
      return false;
    }

    /**
     * Announces a reported jump to another equilibrium; the energy released in
     * the next step is no error.
     */
    virtual void expect_jump()
    {}

    /** Findings about the run so far, equal on all ranks. */
    virtual std::vector<Finding> findings() const = 0;

    /**
     * Largest penetration of struts into plates or other struts so far, over
     * their thickness; empty if the watch does not check it.
     */
    virtual std::optional<double> largest_penetration() const
    {
      return std::nullopt;
    }

    /** Saves or restores data beyond RunStatistics. */
    virtual void serialize(CheckpointArchive & /*archive*/)
    {}

    const SamplingRate rate;
  };

  /**
   * End of a finding about too long steps: ` (Time/Time step = ... s). A step
   * of ... s would miss 1 %.`
   * @param scene_step step of the scene (s)
   * @param missed relative error of its steps
   */
  std::string shorter_step_text(double                scene_step,
                                const ImplicitScheme &scheme,
                                double                missed);

  /**
   * All watches that the scene needs, with their sampling schedule.
   * TimeStepper passes accepted steps to them.
   */
  class Watches
  {
  public:
    /**
     * @param equations, work must outlive the object; @p work counts the
     *   effort of the watches.
     */
    Watches(const Equations &equations, Work &work);

    /** Adds a watch before start() and returns it. */
    template <class Added>
    Added *add(std::unique_ptr<Added> watch)
    {
      Added *const added = watch.get();
      watches.push_back(std::move(watch));
      return added;
    }

    void start(const State &state);

    /** Passes an accepted step to the watches that sample it. */
    void step(const Evaluation        &step,
              const EvaluationResults &results,
              TangentSolver           &solver);

    /**
     * At a checkpoint: drops data of earlier steps, so that a resumed run has
     * the same findings.
     */
    void forget_steps();

    /** Whether any watch reports a change of stability. */
    bool changes_stability(const Evaluation &step, TangentSolver &solver);

    /** Announces a jump to all watches. */
    void expect_jump()
    {
      for (const auto &watch : watches)
        watch->expect_jump();
    }

    /** Findings of all watches, worst first. */
    std::vector<Finding> findings() const;

    /** As Watch::largest_penetration(). */
    std::optional<double> largest_penetration() const;

    void serialize(CheckpointArchive &archive);

  private:
    const SamplingSchedule              schedule;
    RunStatistics                       statistics;
    std::vector<std::unique_ptr<Watch>> watches;
    /** Whether the previous step was in a burst, so that its data are known. */
    bool follows_burst = false;
  };

  /** Objects that watches refer to; all must outlive them. */
  struct WatchContext
  {
    const RunPlan   &plan;
    const Equations &equations;
    RunStatistics   &statistics;
    Work            &work; ///< counts the effort of watches
  };

  using MakeWatch = std::unique_ptr<Watch>(const WatchContext &);

  /** @name The watches; watch.cc decides which scenes have which. */
  ///@{
  /**
   * Energy errors: an open balance, or gain and loss by a scheme with inertia.
   */
  MakeWatch make_energy_watch;
  /** Steps too long for the motion. With inertia. */
  MakeWatch make_step_watch;
  /** Loads that change within steps. With inertia. */
  MakeWatch make_load_step_watch;
  /** Strains beyond the linear law; with elastic struts. */
  MakeWatch make_strain_watch;
  /** Strains beyond yield; if a section has a yield strain. */
  MakeWatch make_yield_watch;
  /** Plastic strains beyond the data of the material, hinges in coarse
   * elements; with plasticity. */
  MakeWatch make_plasticity_watch;
  /**
   * Struts that buckle between joints, which their elements cannot represent;
   * with elastic struts.
   */
  MakeWatch make_local_buckling_watch;
  /** Bending that elements of order 1 miss. With shear flexibility. */
  MakeWatch make_bending_watch;
  /**
   * Bending waves shorter than elements resolve; with elastic struts and
   * inertia.
   */
  MakeWatch make_wave_watch;
  /** Connectors compressed to zero length; with connectors. */
  MakeWatch make_connector_watch;
  /** Penetration of struts into plates or struts; with contact. */
  MakeWatch make_contact_watch;
  /** Impacts that steps do not resolve; with inertia and contact. */
  MakeWatch make_impact_watch;
  /** Loads too fast for neglected inertia, where time has a meaning. */
  MakeWatch make_load_speed_watch;
  /** Struts that touch or pass through each other; with elastic struts. */
  MakeWatch make_crossing_watch;
  /** Struts that pass through plates without contact; with plates. */
  MakeWatch make_plate_crossing_watch;
  /** Displacements too large for the small-displacement form. */
  MakeWatch make_small_displacement_watch;
  /**
   * Free lattices in space whose unstable spin amplifies errors beyond the
   * tolerance of the step-size control. Without rigid parts.
   */
  MakeWatch make_spin_watch;
  /** Unstable equilibria and motions. */
  MakeWatch make_stability_watch;
  ///@}
} // namespace auxfem

#endif
