#ifndef auxfem_time_schemes_time_parameters_h
#define auxfem_time_schemes_time_parameters_h

#include <auxfem/time/schemes/time_scheme.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** `Time`: scheme and steps. */
  struct TimeParameters
  {
    /** Never empty; see implicit_scheme(). */
    std::shared_ptr<const TimeScheme> scheme = default_time_scheme();
    double end_time      = 1;    ///< s (pseudo time for statics)
    double step          = 0.01; ///< s
    double smallest_step = 0;    ///< s; 0: step / 1024
    /**
     * Error of displacements of all steps together, over the largest
     * displacement; empty: steps have the given length.
     */
    std::optional<double> relative_tolerance;
    /** The same in m, for small displacements; empty: see StepError. */
    std::optional<double> absolute_tolerance;
    /** The same in rad, for small rotations; empty: see StepError. */
    std::optional<double> absolute_tolerance_of_rotations;
    /** Energy that a step may create, over the largest so far. */
    double energy_error = 0.5;
    /** Times (s) at which steps end, besides detected kinks and jumps. */
    std::vector<double> events;
    /** Start from the static equilibrium under the loads of t = 0. */
    bool static_start = false;
    /**
     * One sentence for the user per parameter of another scheme that is not at
     * its default.
     */
    std::vector<std::string> values_without_effect;

    /** Number of steps to the end time; the last may be shorter. */
    unsigned long n_steps() const
    {
      // A last step below a millionth of a step is round-off of the input.
      return static_cast<unsigned long>(std::ceil(end_time / step - 1e-6));
    }

    /**
     * The scheme as one that advances a State; every lattice has one. Throws
     * std::bad_cast for schemes of the reduced cell alone.
     */
    const ImplicitScheme &implicit_scheme() const
    {
      return dynamic_cast<const ImplicitScheme &>(*scheme);
    }

    /** Time at the end of step @p n (s), computed and not accumulated. */
    double time_at(const unsigned long n) const
    {
      return n >= n_steps() ? end_time : n * step;
    }
  };

  /** `Time`. */
  SubsectionSchema time_schema();

  /**
   * Reads such a subsection. Throws InputError if values contradict each
   * other.
   */
  TimeParameters read_time(ParameterValues &values);

  /** `Newton`: convergence of a step. */
  struct NewtonParameters
  {
    /** Relative to the force and moment scale of the scene. */
    double       tolerance          = 1e-8;
    bool         tolerance_is_given = false;
    unsigned int maximum_iterations = 30;
    bool         keep_factorization = true; ///< false: full Newton
    /**
     * Smallest residual reduction by an iteration with a reused factorization.
     */
    double jacobian_reuse_threshold = 5;
    /** Whether residuals of stages may be predicted instead of computed. */
    bool estimates_stages = false;

    /**
     * Parameters for the step-size control with @p time_tolerance. Unless
     * given, the tolerance is a tenth of that, between 1e-10 and 1e-5; the
     * error it causes in displacements is much smaller. Residuals within a
     * step are predicted.
     */
    NewtonParameters
    for_steps_within(const std::optional<double> &time_tolerance) const;
  };

  /** `Newton`. */
  SubsectionSchema newton_schema();

  /** Reads such a subsection. */
  NewtonParameters read_newton(ParameterValues &values);
} // namespace auxfem

#endif
