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
   * Differences of a vector over the last steps, of any lengths: the difference
   * of order k is dt^k times the k-th derivative of the polynomial of degree k
   * through the last k + 1 values. The third one for equal steps is
   *
   * @code
   * x_{n+1} - 3 x_n + 3 x_{n-1} - x_{n-2}
   * @endcode
   *
   * It is at most 2^k amplitudes of an oscillation, however fast.
   */
  class BackwardDifferences
  {
  public:
    static constexpr unsigned int largest_order = 4;

    /**
     * The difference at @p now, at @p time (s), for a step of length @p dt (s).
     * Nothing if fewer than @p order values have been added. Entries that have
     * come since the oldest of the values are left out.
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

    std::deque<Sample> samples; ///< the oldest first
  };

  /** Local error of one step of displacements (m) or rotations (rad). */
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
   * Error of all steps. Local errors add up, as they do in an undamped
   * oscillation. But an oscillation of the amplitude A cannot err by more than
   * 2 A, however long it lasts: a small fast vibration, of a stiff contact for
   * instance, need not be followed to its end. Errors are therefore summed by
   * octaves of frequency, each up to that bound.
   */
  class AccumulatedError
  {
  public:
    void add(const LocalError &step);

    /** The smaller of the plain sum and the bounded one (m or rad). */
    double total() const;

    /** The largest total so far. */
    double largest_total() const
    {
      return largest;
    }

    /** @param name of its record */
    void serialize(const std::string &name, CheckpointArchive &archive);

  private:
    struct Octave
    {
      double error = 0, largest_amplitude = 0;
    };

    double                sum = 0, slow = 0, unbounded = 0, largest = 0;
    std::map<int, Octave> octaves; ///< by the binary logarithm of frequency
  };

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
