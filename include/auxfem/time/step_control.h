#ifndef auxfem_time_step_control_h
#define auxfem_time_step_control_h

#include <auxfem/time/records.h>

#include <memory>
#include <optional>

namespace auxfem
{
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

    /** Whether the step last planned may be done in halves. */
    virtual bool may_be_shorter() const = 0;

    /**
     * The step last planned was not solved, or not well enough. Returns false
     * if it may not be shorter.
     * @param relative_error as accepted()
     */
    virtual bool rejected(double relative_error) = 0;

    /** Length of the shortest step (s). */
    virtual double shortest() const = 0;

    /** Keeps what resume() needs. */
    virtual void save(Records &records) const = 0;

    /** Goes on from where @p records were saved by a control of the same kind. */
    virtual void resume(const Records &records) = 0;
  };

  /**
   * Steps of the length @p step (s); where one fails it is done in halves, these
   * in halves again, down to @p smallest (s). So lengths are few, and
   * factorizations serve long. With @p order_of_error halves are put together
   * again only where the error of a step is small, which over a given time goes
   * with this power of the length of steps.
   */
  std::unique_ptr<StepControl>
  make_halved_steps(double                      step,
                    double                      smallest,
                    std::optional<unsigned int> order_of_error);
} // namespace auxfem

#endif
