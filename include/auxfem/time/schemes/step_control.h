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
   * How to guess a smooth function of time from its values at some @p times (s,
   * in any order): the number of each value taken with its weight. A parabola
   * through those three values that are nearest to @p time, but whose errors it
   * does not enlarge much; less where there are fewer.
   */
  std::vector<std::pair<unsigned int, double>>
  extrapolation(const std::vector<double> &times, double time);

  struct TimeParameters;

  /**
   * Part of an allowed error that the controller aims at.
   * @tuned usual in controllers (Hairer, Norsett, Wanner, Solving Ordinary
   * Differential Equations I, II.4)
   */
  inline constexpr double safety_of_steps = 0.8;

  /** A step to be tried. */
  struct PlannedStep
  {
    double end; ///< time at its end (s)
    double dt;  ///< its length (s)
  };

  /**
   * Decides how long steps are. It is told of times that a step must end at,
   * one after the other, and goes to each in as many steps as it likes. A
   * factorization is kept for steps of exactly equal length.
   */
  class StepControl
  {
  public:
    virtual ~StepControl() = default;

    /** The step from @p time on, which ends at @p target at the latest (s). */
    virtual PlannedStep plan(double time, double target) = 0;

    /**
     * The step last planned was solved.
     * @param relative_error its error over the allowed one; 0 if it is not
     *   known.
     */
    virtual void accepted(double relative_error) = 0;

    /**
     * Whether the step last planned may be accepted with this error, or none
     * that is shorter is allowed.
     * @param relative_error as accepted()
     */
    virtual bool may_be_accepted(double relative_error) const = 0;

    /**
     * The step last planned was not solved, or not well enough. Returns false
     * if it may not be shorter.
     * @param relative_error as accepted()
     */
    virtual bool rejected(double relative_error) = 0;

    /** Length of the shortest step (s). */
    virtual double shortest() const = 0;

    /** Saves or restores what it remembers at the end of a step of the scene.
     */
    virtual void serialize(CheckpointArchive & /*archive*/)
    {}
  };

  /**
   * Steps of the length @p step (s); where one fails it is done in halves, these
   * in halves again, down to @p smallest (s), and put together again as soon as
   * they were solved. So lengths are few, and factorizations serve long.
   */
  std::unique_ptr<StepControl> make_halved_steps(double step, double smallest);

  /**
   * Steps whose length a controller takes from their errors, no longer than
   * @p step and no shorter than @p smallest (s). Each interval is divided into
   * 2^k or 3 2^k equal steps, so that factorizations can be reused. The error
   * of a step over its length is proportional to the power @p order of that.
   */
  std::unique_ptr<StepControl>
  make_error_controlled_steps(double step, double smallest, unsigned int order);

  /** What the scene asks for: the latter with a relative tolerance. */
  std::unique_ptr<StepControl>
  make_step_control(const TimeParameters &parameters);

  /** An interval of time that is passed in equal pieces, whose number may
   * change on the way. */
  class DividedInterval
  {
  public:
    /**
     * Length of the interval from @p time to @p target (s): @p step if it
     * differs from that by round-off only, as equal steps must have exactly
     * equal lengths to share a factorization.
     */
    static double length_between(double time, double target, double step);

    /** Begins one of length_between(), in @p pieces. */
    void start(double time, double target, double step, unsigned int pieces);

    /** Whether it is under way, and to @p target (s). */
    bool leads_to(const double other) const
    {
      return target == other;
    }

    /** Whether it is under way. */
    bool is_open() const
    {
      return target.has_value();
    }

    /** The next piece. */
    PlannedStep next() const;

    /** The next piece was passed. */
    void pass();

    /** Goes on in pieces of which @p pieces make the whole; returns whether it
     * can, because one of them begins here. */
    bool divide(unsigned int pieces);

    /** Pieces that make the whole. */
    unsigned int pieces() const
    {
      return number_of_pieces;
    }

    /** Of the whole (s). */
    double length() const
    {
      return whole;
    }

  private:
    std::optional<double> target; ///< if it is under way
    double                begin = 0, whole = 0;
    unsigned int          number_of_pieces = 1, number = 0;
  };
} // namespace auxfem

#endif
