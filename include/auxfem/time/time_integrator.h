#ifndef auxfem_time_time_integrator_h
#define auxfem_time_time_integrator_h

#include <auxfem/scene/scene.h>
#include <auxfem/system/effect.h>

#include <memory>

namespace auxfem
{
  /**
   * A rule that ties displacement, velocity and acceleration at the end of a
   * step to those at its start and one unknown increment. It knows nothing of
   * elements: it predicts, says how the increment enters the tangent, and
   * corrects.
   */
  class TimeIntegrator
  {
  public:
    virtual ~TimeIntegrator() = default;

    /** Fills step.to (all but time and residual) with a first guess. */
    virtual void predict(const Step &step) const = 0;

    /**
     * How an increment of displacement changes displacement, velocity and
     * acceleration.
     */
    virtual TangentFactors factors(double dt) const = 0;

    /** Adds the increment (values at all local unknowns) to the trial state. */
    virtual void
    correct(const Vector &increment, double dt, State &trial) const = 0;

    /** Whether motion and time are related by inertia at all. */
    virtual bool is_dynamic() const
    {
      return true;
    }

    /**
     * Whether errors of velocity and acceleration that change sign from step to
     * step are neither damped nor fed back by an algorithmic acceleration, so
     * that restoring consistent rates after a step removes them.
     */
    virtual bool carries_on_alternating_errors() const
    {
      return false;
    }

    /** Whether the state must carry the algorithmic acceleration. */
    virtual bool uses_algorithmic_acceleration() const
    {
      return false;
    }
  };

  /** One line of the table of time schemes. */
  struct TimeSchemeEntry
  {
    std::string name;
    std::unique_ptr<TimeIntegrator> (*make)(const TimeParameters &parameters);
  };

  /** All schemes the program knows (time/register.cc). */
  const std::vector<TimeSchemeEntry> &time_scheme_registry();

  /** The integrator named parameters.scheme. */
  std::unique_ptr<TimeIntegrator>
  make_integrator(const TimeParameters &parameters);
} // namespace auxfem

#endif
