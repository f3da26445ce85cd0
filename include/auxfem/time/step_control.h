#ifndef auxfem_time_step_control_h
#define auxfem_time_step_control_h

#include <auxfem/time/checkpoint_archive.h>

#include <memory>

namespace auxfem
{
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
} // namespace auxfem

#endif
