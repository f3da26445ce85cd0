#ifndef auxfem_time_step_error_h
#define auxfem_time_step_error_h

#include <auxfem/model/unknown_records.h>
#include <auxfem/output/verdict.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/time/stages.h>

#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /**
   * Backward differences of a vector over the last steps, which may have any
   * lengths. The difference of order k is dt^k times the k-th derivative of
   * the polynomial of degree k through the last k + 1 values. For equal steps
   * the third one is
   *
   * @code
   * x_{n+1} - 3 x_n + 3 x_{n-1} - x_{n-2}
   * @endcode
   *
   * For an oscillation it is at most 2^k amplitudes, at any frequency.
   */
  class BackwardDifferences
  {
  public:
    static constexpr unsigned int largest_order = 4;

    /**
     * The difference at @p now, at @p time (s), for a step of length @p dt
     * (s). Empty if fewer than @p order values have been added. Omits entries
     * that are newer than the oldest value.
     * @param order at most largest_order
     */
    std::optional<Vector> difference(unsigned int  order,
                                     double        time,
                                     const Vector &now,
                                     double        dt) const;

    /** Adds the next value, at @p time (s). */
    void add(double time, const Vector &value);

    bool is_empty() const
    {
      return samples.empty();
    }

    /** Time of the newest value (s); there must be one. */
    double latest_time() const
    {
      return samples.back().time;
    }

    void clear()
    {
      samples.clear();
    }

    /** Saves or restores values at unknowns.
     * @param name prefix of the records' names */
    void serialize(const std::string    &name,
                   const UnknownRecords &unknowns,
                   CheckpointArchive    &archive);

  private:
    struct Sample
    {
      double time; ///< s
      Vector value;
    };

    std::deque<Sample> samples; ///< oldest first
  };

  /** Local error of one step, of displacements (m) or rotations (rad). */
  struct LocalError
  {
    /** The oscillation that dominates the error. */
    struct Oscillation
    {
      double frequency; ///< angular, 1/s
      double amplitude; ///< m or rad
    };

    double size = 0;
    /** Part of it in motions that the scene's steps resolve; at most size. */
    double                     slow        = 0;
    std::optional<Oscillation> oscillation = {};
    /** Factor by which the scheme damps errors of earlier steps. */
    double amplification = 1;
  };

  /**
   * Accumulated error of all steps. Local errors add up as in an undamped
   * oscillation, but an oscillation of amplitude A errs by no more than 2 A.
   * Errors are therefore summed by octaves of frequency, each up to that
   * bound, and small fast vibrations, as of a stiff contact, need not be
   * resolved.
   */
  class AccumulatedError
  {
  public:
    void add(const LocalError &step);

    /** Smaller one of the plain and the bounded sum (m or rad). */
    double total() const;

    /** Largest total so far. */
    double largest_total() const
    {
      return largest;
    }

    /** @param name of its checkpoint record */
    void serialize(const std::string &name, CheckpointArchive &archive);

  private:
    struct Octave
    {
      double error = 0, largest_amplitude = 0;
    };

    double                sum = 0, slow = 0, unbounded = 0, largest = 0;
    std::map<int, Octave> octaves; ///< by binary logarithm of frequency
  };

  /**
   * Local error estimator of the step-size control, and the accumulated error
   * of all steps. The alpha family uses the change of acceleration (O. C.
   * Zienkiewicz & Y. M. Xie, Earthquake Eng. Struct. Dyn. 20 (1991) 871-887,
   * eq. 22, here for the whole family) or the third difference of
   * displacements. Runge-Kutta schemes use their embedded scheme:
   *
   * @code
   * e = pi / 2 c min(dt^2 |a_{n+1} - a_n|, |dt^3 u_ttt|)
   * e = pi / 2 r(z) |u - u_embedded|
   * z = dt |v - v_embedded| / |u - u_embedded|
   * @endcode
   *
   * with c = ImplicitScheme::error_constant() and r =
   * ImplicitScheme::error_by_difference(). The factor pi / 2 accounts for the
   * error of the velocity, which an oscillation turns into one of the
   * displacement. The third difference bounds the error of unresolved
   * oscillations. The larger one of displacements and rotations counts, each
   * as the root mean square over all free unknowns.
   *
   * A step may use a share of the remaining tolerance in proportion to its
   * length.
   */
  class StepError
  {
  public:
    /** @p equations must outlive the object. */
    explicit StepError(const Equations &equations);

    /** Local error of @p step over the allowed one. Collective. */
    double relative(const Evaluation &step);

    /** The same for a scheme with stages. */
    double relative(const Evaluation         &step,
                    const Stages::Difference &difference);

    /**
     * Accepts the last @p step of relative(); returns the value of relative().
     */
    double accept(const Evaluation &step);

    /** Accumulated error over the largest motions. */
    double total() const;

    /** Reports an accumulated error above the tolerance. */
    std::vector<Finding> findings() const;

    void serialize(CheckpointArchive &archive);

  private:
    /** Displacements (m) or rotations (rad). */
    struct Motions
    {
      std::string             name, parameter, unit;
      const std::vector<int> &rows; ///< free ones
      /**
       * Allowed error while motions are small. If empty, that of rotations is
       * the allowed error of displacements over the mean strut length.
       */
      std::optional<double> absolute_tolerance = {};
      double                largest = 0; ///< largest motion so far (m, rad)
      AccumulatedError      error   = {};
      /** Third derivative at intervals of the scene's step (m/s^3). */
      std::optional<double> slow_third_derivative = {};

      /** Estimate of the last relative(). */
      struct Estimate
      {
        AccumulatedError error    = {}; ///< including the step
        double           largest  = 0;
        double           relative = 0;
      };
      Estimate latest = {};
    };

    /** Root mean square of @p values. Collective. */
    double mean(const Motions &motions, const Vector &values) const;
    /**
     * Allowed error of all steps together (m, rad).
     * @param largest of @p motions so far (m, rad)
     */
    double allowed(const Motions &motions,
                   double         largest,
                   double         largest_displacement) const;
    /** Local error by a scheme of the alpha family. Collective. */
    LocalError local_error(const Motions    &motions,
                           const Evaluation &step) const;
    /**
     * Dominant oscillation, from the @p third difference and those of orders 2
     * and 4. Collective.
     */
    std::optional<LocalError::Oscillation>
    dominant_oscillation(const Motions    &motions,
                         const Evaluation &step,
                         double            third) const;
    /**
     * Estimate displacements first: the tolerance of rotations may depend on
     * them. Collective.
     */
    void
    estimate(Motions &motions, const Evaluation &step, const LocalError &local);
    /** Samples displacements at intervals of the scene's step. Collective. */
    void sample(const State &state);
    /** Largest motion (m, rad) that the tolerance refers to. */
    double reference(const Motions &motions) const;
    double largest_relative() const;

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
