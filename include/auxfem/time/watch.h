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
  /** Something that happens to a part of a structure. */
  struct Occurrence
  {
    double       size;      ///< how far it goes
    double       time;      ///< s
    unsigned int number;    ///< of the strut or joint
    unsigned int group = 0; ///< of the connector, or what else it is with
  };

  /** What happens during a run, each rank seeing its own parts: the first and
   * the largest are kept. */
  class Occurrences
  {
  public:
    explicit Occurrences(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    /** In the order of time. */
    void add(const Occurrence &occurrence);

    /** The largest of this rank. */
    const std::optional<Occurrence> &largest_here() const
    {
      return largest_one;
    }

    /** @name Of all ranks, the same on each; collective. */
    ///@{
    std::optional<Occurrence> first() const;
    std::optional<Occurrence> largest() const;
    ///@}

    /** Collective. */
    void serialize(const std::string &name, CheckpointArchive &archive);

  private:
    const MPI_Comm            communicator;
    std::optional<Occurrence> first_one, largest_one;
  };

  /**
   * What the watches of a run have found so far: all that they keep in a
   * checkpoint. Each watch has references to entries of its own, which begin
   * with its name. All but occurrences are the same on all ranks.
   */
  class RunStatistics
  {
  public:
    explicit RunStatistics(const MPI_Comm communicator)
      : communicator(communicator)
    {}

    RunStatistics(const RunStatistics &)            = delete;
    RunStatistics &operator=(const RunStatistics &) = delete;

    /** @name The entry of this name, which is made when first asked for. */
    ///@{
    double &number(const std::string &name, const double initial = 0)
    {
      return numbers.try_emplace(name, initial).first->second;
    }

    LargestInTime &largest(const std::string &name)
    {
      return maxima[name];
    }

    Occurrences &occurrences(const std::string &name)
    {
      return all_occurrences.try_emplace(name, communicator).first->second;
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
    std::map<std::string, Occurrences>         all_occurrences;
    std::map<std::string, std::vector<double>> lists;
    std::map<std::string, std::string>         texts;
  };

  /** Which steps a watch checks. Without inertia each of them checks all. */
  enum class SamplingRate
  {
    every_step,
    /** Some in a row, now and then, in linear scenes, whose steps cost little
     * more than a check of every unknown. */
    bursts,
    /** The first of each burst, in nonlinear scenes too: for checks that cost
     * as much as an evaluation. */
    single_steps
  };

  /** The steps that are sampled: a function of their number alone, so that runs
   * that are resumed sample the same ones. The last steps always are. */
  class SamplingSchedule
  {
  public:
    /**
     * Steps from one sample to the next, at most.
     * @tuned [steps] measured: samples cost a few per cent of linear steps; a
     * prime number lets no vibration hide between samples
     */
    static constexpr unsigned long longest_period = 13;

    /**
     * Smallest number of samples in a run that has more steps.
     * @tuned judgement
     */
    static constexpr unsigned long least_number = 20;

    explicit SamplingSchedule(const Equations &equations)
      : has_inertia(equations.model().plan.simulated.inertia)
      , is_linear(equations.is_linear())
      , n_steps(equations.model().plan.time.n_steps())
      , period(
          std::min(longest_period, (n_steps + least_number - 1) / least_number))
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
    /** Steps that a third difference takes. */
    static constexpr unsigned long burst = 3;

    const bool          has_inertia, is_linear;
    const unsigned long n_steps, period;
  };

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
