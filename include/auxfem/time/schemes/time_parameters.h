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
    /** Error of the displacements that all steps together may have, of the
     * largest displacement; nothing: steps are as long as they are set. */
    std::optional<double> relative_tolerance;
    /** The same in m, where displacements are small yet; nothing: see
     * StepError.
     */
    std::optional<double> absolute_tolerance;
    /** In rad, where rotations are small; nothing: see StepError. */
    std::optional<double> absolute_tolerance_of_rotations;
    /** Energy a step may create, of the largest so far. */
    double energy_error = 0.5;
    /** Times (s) at which steps end besides kinks and jumps that are found. */
    std::vector<double> events;
    /** Start from the static equilibrium under the loads of t = 0. */
    bool static_start = false;
    /** One sentence per parameter of another scheme that is not at its default,
     * for the user. */
    std::vector<std::string> values_without_effect;

    /** Number of steps to the end time; the last may be shorter. */
    unsigned long n_steps() const
    {
      // A last step of a millionth of a step is round-off of the input.
      return static_cast<unsigned long>(std::ceil(end_time / step - 1e-6));
    }

    /**
     * The scheme as one that advances a State: that of every lattice, and of
     * the reduced cell unless it is one of its own. Throws std::bad_cast if it
     * is.
     */
    const ImplicitScheme &implicit_scheme() const
    {
      return dynamic_cast<const ImplicitScheme &>(*scheme);
    }

    /** Time at the end of step @p n, from the count, never accumulated (s). */
    double time_at(const unsigned long n) const
    {
      return n >= n_steps() ? end_time : n * step;
    }
  };

  /** `Time`. */
  SubsectionSchema time_schema();

  /** The values of one such subsection. Throws InputError if they contradict
   * each other. */
  TimeParameters read_time(ParameterValues &values);

  /** `Newton`: when a step counts as solved. */
  struct NewtonParameters
  {
    /** Relative to the scene's own force and moment scale. */
    double       tolerance          = 1e-8;
    bool         tolerance_is_given = false;
    unsigned int maximum_iterations = 30;
    bool         keep_factorization = true; ///< false: full Newton
    /** A kept factorization must reduce the residual so much an iteration. */
    double kept_reduction = 5;
    /** Whether residuals of stages within a step need not be computed if they
     * can be told from others. */
    bool estimates_stages = false;

    /**
     * The same for steps whose length follows their error, which may be as
     * large as @p time_tolerance: unless the tolerance is given it is a tenth of
     * that, neither below 1e-10 nor above 1e-5. The error it leaves in
     * displacements is much smaller than itself. Residuals within such a step
     * are estimated.
     */
    NewtonParameters
    for_steps_within(const std::optional<double> &time_tolerance) const;
  };

  /** `Newton`. */
  SubsectionSchema newton_schema();

  /** The values of one such subsection. */
  NewtonParameters read_newton(ParameterValues &values);
} // namespace auxfem

#endif
