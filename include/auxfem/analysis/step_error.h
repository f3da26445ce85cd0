#ifndef auxfem_analysis_step_error_h
#define auxfem_analysis_step_error_h

#include <auxfem/equations/equations.h>
#include <auxfem/output/verdict.h>
#include <auxfem/time/time_parameters.h>

#include <vector>

namespace auxfem
{
  /**
   * The error of the displacement that a step of a second-order scheme adds,
   * from how much the acceleration changes in it (O. C. Zienkiewicz & Y. M.
   * Xie, Earthquake Eng. Struct. Dyn. 20 (1991) 871-887, eq. 22 for Newmark;
   * here for the whole alpha family),
   *
   * @code
   * e = pi / 2 c dt^2 (v'_{n+1} - v'_n)
   * @endcode
   *
   * with ImplicitScheme::error_constant(); pi / 2 stands for the error of the
   * velocity, which an oscillation turns into one of the displacement. Errors
   * and displacements are taken as root mean squares of all free ones, not of
   * rotations. In free oscillation the errors of all steps add up, so each may
   * take of the tolerance the part that its length is of the whole time; where
   * damping takes them away again, less is left in the end.
   */
  class StepError
  {
  public:
    /** @p equations must outlive the object. */
    StepError(const Equations &equations, const TimeParameters &parameters);

    /**
     * Error of @p step over the one that is allowed: the tolerance times the
     * largest displacements so far, or the absolute tolerance, times its part
     * of the whole time. Collective.
     */
    double relative(const Evaluation &step, const Vector &acceleration_change);

    /** The step that relative() was last asked of becomes the solution; returns
     * what that has said. */
    double accept();

    /** Of all steps together, relative to the largest displacements. */
    double total() const;

    /** Something to tell if all steps together have a larger error than is
     * allowed by the displacements that there were. */
    std::vector<Finding> findings() const;

    void save(Records &records) const;
    void resume(const Records &records);

  private:
    const Equations &equations;
    const double     tolerance, end_time, constant;
    /** m */
    const double absolute_tolerance;

    /** Of one step (m). */
    struct Estimate
    {
      double error    = 0;
      double motion   = 0; ///< largest so far
      double relative = 0; ///< error over the allowed one
    };

    Estimate latest;
    /** Of all steps (m). */
    double total_error = 0, largest_motion_so_far = 0;
  };
} // namespace auxfem

#endif
