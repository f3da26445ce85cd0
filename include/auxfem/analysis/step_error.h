#ifndef auxfem_analysis_step_error_h
#define auxfem_analysis_step_error_h

#include <auxfem/analysis/stages.h>
#include <auxfem/analysis/third_difference.h>
#include <auxfem/model/least_damping.h>
#include <auxfem/model/load_course.h>
#include <auxfem/output/verdict.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * The error of the motion that a step adds. Of a scheme of the alpha family
   * it follows from how much the acceleration changes in the step (O. C.
   * Zienkiewicz & Y. M. Xie, Earthquake Eng. Struct. Dyn. 20 (1991) 871-887,
   * eq. 22 for Newmark; here for the whole family) and from the third
   * difference of the last displacements, of a Runge-Kutta scheme from how much
   * its embedded scheme differs in displacement and velocity,
   *
   * @code
   * e = pi / 2 c min(dt^2 |v'_{n+1} - v'_n|, |dt^3 u_ttt|)
   * e = 1.6 pi / 2 r(z) |u - u_embedded|
   * z = dt |v - v_embedded| / |u - u_embedded|
   * @endcode
   *
   * with c = ImplicitScheme::error_constant() and r =
   * ImplicitScheme::error_by_difference(), z being the angle by which what errs
   * most turns in the step; pi / 2 stands for the error of the velocity, which
   * an oscillation turns into one of the displacement, 1.6 for oscillations
   * that slower and faster ones hide. Displacements and rotations are measured
   * apart, by root mean squares of all free ones; the worse of the two counts.
   *
   * In free oscillation the errors of all steps add up, so each may take, of
   * what the steps before it have left of the tolerance, the part that its
   * length is of the time that remains, but hardly more than if all steps erred
   * alike. While motions grow, so does what is tolerated, and a step may take
   * most of that: errors of small motions are soon small beside the large ones.
   *
   * Motions are expected to grow as loads still do (LoadsToCome), and may err
   * as those to come, up to a thousandth of what they are; if they do not grow,
   * the errors that were made are told. Not so by schemes without stages: what
   * these do not follow at the start they do not damp either, and later steps
   * would have to follow it.
   *
   * Oscillations that are too fast to be followed have small displacements, but
   * the largest accelerations; in the third difference (ThirdDifference) they
   * count by their displacements. After a jump of accelerations it is the
   * change of these that is right, and the smaller. What a Runge-Kutta scheme
   * damps of such oscillations is known: ImplicitScheme::amplification() of z
   * is left. Where the structure damps them as well (LeastDamping), most of the
   * error, which is fast, is forgotten as quickly.
   */
  class StepError
  {
  public:
    /** @p equations must outlive the object. */
    StepError(const Equations &equations, const Scene &scene);

    /**
     * Error of @p step over the one that is wanted. Collective.
     */
    double relative(const Evaluation &step);

    /** The same for a scheme with stages. */
    double relative(const Evaluation         &step,
                    const Stages::Difference &difference);

    /** The @p step that relative() was last asked of becomes the solution;
     * returns what that has said. */
    double accept(const Evaluation &step);

    /** Steps before do not count in the third difference any more. */
    void forget()
    {
      displacements.forget();
    }

    /** Of all steps together, as far as the scheme has not damped it, relative
     * to the largest motions; the largest so far. */
    double total() const;

    /** Something to tell if all steps together have a larger error than is
     * allowed by the motions that there were. */
    std::vector<Finding> findings() const;

    void save(Records &records) const;
    void resume(const Records &records);

  private:
    /** Displacements (m) or rotations (rad). */
    struct Motions
    {
      std::string             name, parameter, unit;
      const std::vector<int> &rows; ///< free ones
      /** Allowed error while motions are small; none: as much of rotations as
       * is allowed of displacements, over the length of a strut. */
      std::optional<double> absolute_tolerance = {};
      double                largest            = 0; ///< so far
      /** @name Of all steps, what is left of it in oscillations that nothing
       * but the scheme damps and in fast ones, and the largest so far. */
      ///@{
      double slow_error = 0, fast_error = 0, total_error = 0;
      ///@}

      /** Of the step that relative() was last asked of. */
      struct Estimate
      {
        double error   = 0;
        double largest = 0; ///< motion so far
        double allowed = 0; ///< error of all steps
        /** Parts of errors so far that it leaves. */
        double of_slow = 1, of_fast = 1;
        double relative = 0; ///< error over the one that is wanted
      };
      Estimate latest = {};

      double left_error() const
      {
        return slow_error + fast_error;
      }
    };

    /** Root mean square of those in @p values, or their rates. Collective. */
    double mean(const Motions &motions, const Vector &values) const;
    /**
     * Error that all steps together may make.
     * @param largest of the motions until @p time (m, rad, s)
     * @param of_displacements allowed error (m)
     */
    double allowed(const Motions &motions,
                   double         largest,
                   double         time,
                   double         of_displacements) const;
    /** The same by the motions before the step, until @p time (s). */
    double allowed_until(const Motions &motions, double time) const;
    /**
     * Of displacements first, as that of rotations may depend on them.
     * Collective.
     * @param error that the step adds to displacements (m, rad)
     * @param angle by which what errs most turns in the step; none: of this
     *   scheme it is not known
     */
    void estimate(Motions              &motions,
                  const Evaluation     &step,
                  double                error,
                  std::optional<double> angle = {});
    /** Largest motions (m, rad) that all errors are a part of. */
    double largest_of_all(const Motions &motions) const;
    /** The larger of both. */
    double worst() const;

    const Equations      &equations;
    const ImplicitScheme &scheme;
    const double          tolerance, end_time;
    /** None if motions are not expected to grow with them. */
    std::optional<LoadsToCome> loads;
    const LeastDamping         damping;
    /** Displacements, rotations. */
    std::array<Motions, 2> all;
    ThirdDifference        displacements;
  };
} // namespace auxfem

#endif
