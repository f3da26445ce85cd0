#ifndef auxfem_analysis_step_error_h
#define auxfem_analysis_step_error_h

#include <auxfem/analysis/accumulated_error.h>
#include <auxfem/analysis/backward_differences.h>
#include <auxfem/analysis/stages.h>
#include <auxfem/output/verdict.h>
#include <auxfem/time/checkpoint_archive.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Estimates the error of the motion that a step adds, for step-size control,
   * and that of all steps so far. Schemes of the alpha family take it from the
   * change of acceleration (O. C. Zienkiewicz & Y. M. Xie, Earthquake Eng.
   * Struct. Dyn. 20 (1991) 871-887, eq. 22 for Newmark; here for the whole
   * family) or from the third difference of displacements, Runge-Kutta schemes
   * from their embedded scheme:
   *
   * @code
   * e = pi / 2 c min(dt^2 |a_{n+1} - a_n|, |dt^3 u_ttt|)
   * e = pi / 2 r(z) |u - u_embedded|
   * z = dt |v - v_embedded| / |u - u_embedded|
   * @endcode
   *
   * with c = ImplicitScheme::error_constant() and r =
   * ImplicitScheme::error_by_difference(). The factor pi / 2 stands for the
   * error of the velocity, which an oscillation turns into one of the
   * displacement. The third difference bounds the error of oscillations that
   * steps do not resolve. Displacements and rotations are measured separately,
   * by root mean squares over all free unknowns; the worse of the two counts.
   *
   * A step may use the part of the remaining tolerance that its length is of
   * the remaining time. AccumulatedError sums local errors.
   */
  class StepError
  {
  public:
    /** @p equations must outlive the object. */
    explicit StepError(const Equations &equations);

    /**
     * The error that @p step adds over the one it may add. Collective.
     */
    double relative(const Evaluation &step);

    /** The same for a scheme with stages. */
    double relative(const Evaluation         &step,
                    const Stages::Difference &difference);

    /** Accepts the @p step last given to relative(), and returns the value that
     * relative() returned. */
    double accept(const Evaluation &step);

    /** Error of all steps over the largest motions. */
    double total() const;

    /** A finding if all steps together err more than the tolerance allows. */
    std::vector<Finding> findings() const;

    void serialize(CheckpointArchive &archive);

  private:
    /** Displacements (m) or rotations (rad). */
    struct Motions
    {
      std::string             name, parameter, unit;
      const std::vector<int> &rows; ///< free ones
      /** Allowed error while motions are small. If absent, rotations may err by
       * the allowed error of displacements over the length of a strut. */
      std::optional<double> absolute_tolerance = {};
      double                largest            = 0; ///< so far
      AccumulatedError      error              = {};
      /** Third derivative at intervals of the scene's step (m/s^3). */
      std::optional<double> slow_third_derivative = {};

      /** The step last given to relative(). */
      struct Estimate
      {
        AccumulatedError error    = {}; ///< with that of the step
        double           largest  = 0;
        double           relative = 0;
      };
      Estimate latest = {};
    };

    /** Root mean square of @p values. Collective. */
    double mean(const Motions &motions, const Vector &values) const;
    /** Error that all steps together may make (m, rad).
     * @param largest of @p motions so far (m, rad) */
    double allowed(const Motions &motions,
                   double         largest,
                   double         largest_displacement) const;
    /** Local error by a scheme of the alpha family. Collective. */
    LocalError local_error(const Motions    &motions,
                           const Evaluation &step) const;
    /** The oscillation that differences of order 2 to 4 show, the @p third of
     * which is known. Collective. */
    std::optional<LocalError::Oscillation>
    dominant_oscillation(const Motions    &motions,
                         const Evaluation &step,
                         double            third) const;
    /** Displacements come first, as the tolerance of rotations may depend on
     * them. Collective. */
    void
    estimate(Motions &motions, const Evaluation &step, const LocalError &local);
    /** Samples displacements at intervals of the scene's step. Collective. */
    void sample(const State &state);
    /** Largest motions (m, rad) that the tolerance is relative to. */
    double reference(const Motions &motions) const;
    double worst() const;

    const Equations      &equations;
    const ImplicitScheme &scheme;
    const double          tolerance, end_time, sampling_interval;
    /** Displacements, rotations. */
    std::array<Motions, 2> all;
    /** At the ends of all steps, and at intervals of the scene's step. */
    BackwardDifferences displacements, samples;
  };
} // namespace auxfem

#endif
