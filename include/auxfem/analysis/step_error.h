#ifndef auxfem_analysis_step_error_h
#define auxfem_analysis_step_error_h

#include <auxfem/analysis/stages.h>
#include <auxfem/output/verdict.h>
#include <auxfem/time/time_parameters.h>

#include <vector>

namespace auxfem
{
  /**
   * The error of the displacement that a step adds. Of a scheme of the alpha
   * family it follows from how much the acceleration changes in the step (O. C.
   * Zienkiewicz & Y. M. Xie, Earthquake Eng. Struct. Dyn. 20 (1991) 871-887,
   * eq. 22 for Newmark; here for the whole family), of a Runge-Kutta scheme
   * from how much its embedded scheme differs in displacement and velocity,
   *
   * @code
   * e = pi / 2 c dt^2 |v'_{n+1} - v'_n|
   * e = pi / 2 c min(dt |v - v_embedded|, |u - u_embedded|)
   * @endcode
   *
   * with ImplicitScheme::error_constant(); pi / 2 stands for the error of the
   * velocity, which an oscillation turns into one of the displacement. The
   * minimum is the second where oscillations are too fast for the step to
   * follow. Errors and displacements are taken as root mean squares of all free
   * ones, not of rotations.
   *
   * In free oscillation the errors of all steps add up, so each may take of the
   * tolerance the part that its length is of the whole time; where damping
   * takes them away again, less is left in the end. What the scheme itself
   * damps is known: the ratio of the two differences above is the angle by
   * which what errs most turns in the step, of which
   * ImplicitScheme::amplification() is left. So errors of oscillations that no
   * step can follow, which do not last, make none shorter.
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
    double relative(const Evaluation &step);

    /** The same for a scheme with stages. */
    double relative(const Evaluation         &step,
                    const Stages::Difference &difference);

    /** The step that relative() was last asked of becomes the solution; returns
     * what that has said. */
    double accept();

    /** Of all steps together, as far as the scheme has not damped it, relative
     * to the largest displacements; the largest so far. */
    double total() const;

    /** Something to tell if all steps together have a larger error than is
     * allowed by the displacements that there were. */
    std::vector<Finding> findings() const;

    void save(Records &records) const;
    void resume(const Records &records);

  private:
    /** Root mean square of free displacements or their rates. Collective. */
    double mean(const Vector &motion) const;
    /**
     * @param difference from which the error follows (m)
     * @param damping part of errors that the step takes away
     */
    double relative(const Evaluation &step, double difference, double damping);

    const Equations      &equations;
    const ImplicitScheme &scheme;
    const double          tolerance, end_time, constant;
    /** m */
    const double absolute_tolerance;

    /** Of one step (m). */
    struct Estimate
    {
      double error    = 0;
      double motion   = 0; ///< largest so far
      double damping  = 0; ///< part of errors so far that it takes away
      double relative = 0; ///< error over the allowed one
    };

    Estimate latest;
    /** Of all steps, what is left of it and the largest so far (m). */
    double left_error = 0, total_error = 0;
    double largest_motion_so_far = 0; ///< m
  };
} // namespace auxfem

#endif
