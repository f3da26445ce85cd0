#ifndef auxfem_time_schemes_step_control_h
#define auxfem_time_schemes_step_control_h

#include <auxfem/state/checkpoint_archive.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * Extrapolates a smooth function of time from its values at some @p times
   * (s, in any order): returns indices of values and their weights. Uses a
   * parabola through the three values nearest to @p time that do not amplify
   * errors much; fewer values lower the degree.
   */
  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, double time);

  struct TimeParameters;

  /**
   * Part of the allowed error that the controller aims at.
   * @tuned usual in controllers (Hairer, Norsett, Wanner, Solving Ordinary
   *   Differential Equations I, II.4)
   */
  inline constexpr double step_safety_factor = 0.8;

  /** A planned step. */
  struct PlannedStep
  {
    double end; ///< time at its end (s)
    double dt;  ///< its length (s)
  };

  /**
   * Step-size controller: plans steps up to target times, one after the other.
   * Lengths repeat exactly, because factorizations are reused only for equal
   * lengths. Used by TimeStepper.
   */
  class StepControl
  {
  public:
    virtual ~StepControl() = default;

    /**
     * Plans the step from @p time, which ends at @p target at the latest (s).
     */
    virtual PlannedStep plan(double time, double target) = 0;

    /**
     * The last planned step was accepted.
     * @param relative_error error over the allowed one; 0 if unknown.
     */
    virtual void accepted(double relative_error) = 0;

    /**
     * Whether the last planned step may be accepted with this error. True also
     * if no shorter step is allowed.
     * @param relative_error as in accepted()
     */
    virtual bool may_be_accepted(double relative_error) const = 0;

    /**
     * The last planned step failed or was too inaccurate. Returns false if it
     * may not be shorter.
     * @param relative_error as in accepted()
     */
    virtual bool rejected(double relative_error) = 0;

    /** Length of the shortest step (s). */
    virtual double shortest() const = 0;

    /** Saves or restores its state at the end of a step of the scene. */
    virtual void serialize(CheckpointArchive & /*archive*/)
    {}
  };

  /**
   * Steps of the length @p step (s). Failed steps are halved repeatedly, down
   * to
   * @p smallest (s), and merged again once solved. So there are few different
   * lengths, and factorizations are reused often.
   */
  std::unique_ptr<StepControl> make_halved_steps(double step, double smallest);

  /**
   * Steps whose length follows from their errors, between @p smallest and
   * @p step (s). Each interval is divided into 2^k or 3 2^k equal steps, so
   * that factorizations can be reused.
   * @param order power of the length to which error over length is
   *   proportional
   */
  std::unique_ptr<StepControl>
  make_error_controlled_steps(double step, double smallest, unsigned int order);

  /**
   * The step control of the scene: error-controlled with a relative tolerance.
   */
  std::unique_ptr<StepControl>
  make_step_control(const TimeParameters &parameters);

  /**
   * A time interval that is divided into equal pieces; their number may change
   * on the way.
   */
  class DividedInterval
  {
  public:
    /**
     * Length of the interval from @p time to @p target (s). It is @p step if
     * only round-off differs, as only exactly equal steps share a
     * factorization.
     */
    static double length_between(double time, double target, double step);

    /** Begins an interval of length_between(), in @p pieces. */
    void start(double time, double target, double step, unsigned int pieces);

    /** Whether it is in progress, and to @p target (s). */
    bool leads_to(const double other) const
    {
      return target == other;
    }

    /** Whether it is in progress. */
    bool is_open() const
    {
      return target.has_value();
    }

    /** The next piece. */
    PlannedStep next() const;

    /** Completes the next piece. */
    void pass();

    /**
     * Changes to @p pieces of the whole interval; returns whether one of them
     * begins here.
     */
    bool divide(unsigned int pieces);

    /** Number of pieces of the whole interval. */
    unsigned int pieces() const
    {
      return n_pieces;
    }

    /** Length of the whole interval (s). */
    double length() const
    {
      return whole;
    }

  private:
    std::optional<double> target; ///< if in progress
    double                begin = 0, whole = 0;
    unsigned int          n_pieces = 1, number = 0;
  };
} // namespace auxfem

#endif
