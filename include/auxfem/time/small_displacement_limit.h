#ifndef auxfem_time_small_displacement_limit_h
#define auxfem_time_small_displacement_limit_h

#include <auxfem/contact/effects/strut_proximity.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/time/large_rotation_error.h>
#include <auxfem/time/small_displacement_error.h>

#include <memory>
#include <optional>
#include <stdexcept>

namespace auxfem
{
  /** Change of a linear response by axial forces. */
  struct SecondOrderChange
  {
    /**
     * Relative change of displacements or of forces, the larger one, in the
     * energy norm.
     */
    double relative = 0;
    /**
     * Whether the stiffness under axial forces has negative modes; empty if
     * the linear solver cannot tell.
     */
    std::optional<bool> is_unstable = {};
  };

  /**
   * Change of a linear response by axial forces: uses the stiffness K + K_g of
   * the undeformed structure under its forces, as in linear stability theory.
   * Beyond the critical load that stiffness is meaningless for the response,
   * and K replaces it, as if buckling were excluded. Each call costs one or
   * two factorizations.
   */
  class SecondOrderEffect
  {
  public:
    /** @param equations of small displacements, must outlive the object. */
    explicit SecondOrderEffect(const Equations &equations);
    ~SecondOrderEffect();

    /**
     * The change in @p state; empty if large rotations are not possible or the
     * structure moves freely. Collective.
     * @param state by small displacements, with its energies
     * @param forces_by_turning forces (N) by local unknown of axial forces on
     *   rotated struts
     */
    std::optional<SecondOrderChange> at(const State  &state,
                                        const Vector &forces_by_turning);

    /**
     * Equations of the same structure with large rotations; nullptr if these
     * are not possible. Collective.
     */
    const Equations *exact_equations();

    /** Effort since the last call. */
    Work collect_effort();

  private:
    /** The same structure with large rotations. */
    struct Exact;

    /** Relative change by @p forces (N) with the current factors. */
    std::optional<double> relative_change(const State  &state,
                                          const Vector &forces);

    const Equations       &equations;
    Work                   effort;
    std::unique_ptr<Exact> exact; ///< created on demand
    /** Large rotations are not possible. */
    bool is_impossible = false;
  };

  /**
   * Thrown when small displacements are no longer accurate; what() says why
   * and when.
   */
  class SmallDisplacementLimitExceeded : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * Ends a run by small displacements when their error exceeds
   * `Effects/Tolerance`, the structure becomes unstable, struts touch or yield.
   * Samples every step, with inertia every twentieth. Used by
   * run_with_chosen_kinematics(); all checks are collective.
   */
  class SmallDisplacementLimit
  {
  public:
    /**
     * @param small, exact must outlive the object, as in
     *   LargeRotationErrorEstimator
     */
    SmallDisplacementLimit(const Equations &small, const Equations &exact);

    /**
     * Error of the static response to the loads; with inertia of twice that,
     * as under sudden loads.
     */
    LargeRotationError check_static_answer();

    /** Checks an accepted step with its @p results. Throws
     * SmallDisplacementLimitExceeded. */
    void check(const Evaluation &step, const EvaluationResults &results);

    /**
     * Largest error so far over the largest displacement. With inertia adds
     * the phase error of vibrations: half the error for each radian of their
     * phase.
     */
    double error() const;

    const Work &effort() const
    {
      return estimator.effort();
    }

    void serialize(CheckpointArchive &archive);

  private:
    /**
     * Motions known to be stable and accurate: they are no larger, and
     * compress no strut more, than one for which both were computed.
     */
    struct Envelope
    {
      double              size  = 0;                  ///< m
      double              total = 0, compression = 0; ///< as in the estimate
      std::vector<double> compressions;               ///< by strut
      double              error = 0; ///< of the largest motion (m)
    };

    /** Whether the envelope contains a motion of @p size (m). */
    bool envelope_contains(double                        size,
                           const SmallDisplacementError &motion) const;
    /**
     * Replaces the envelope by @p factor times a motion, with the @p error
     * (m).
     */
    void extend(double                        factor,
                double                        size,
                const SmallDisplacementError &motion,
                double                        error);
    /** Which strut yields; empty if none does. */
    std::string yielding(const State             &state,
                         const EvaluationResults &results) const;
    /** Why the motion exceeds the limit; empty if it does not. */
    std::string reason(const State &state);
    /**
     * As reason(), for @p factor times the motion; extends the envelope to it.
     */
    std::string compute(double                        factor,
                        const State                  &state,
                        double                        size,
                        const SmallDisplacementError &motion);

    const RunPlan                  &plan;
    const Equations                &small;
    const UnknownLayout            &layout;
    const bool                      has_inertia;
    LargeRotationErrorEstimator     estimator;
    const SmallDisplacementEstimate estimate;
    Envelope                        envelope;
    /** Strains at which sections yield; empty without plasticity. */
    std::vector<StrainLimit>              yield_limits;
    std::unique_ptr<FirstContactDetector> detector; ///< nullptr without contact
    double       largest_error = 0, largest_size = 0; ///< so far (m)
    double       path_length     = 0; ///< length of the motion's path (m)
    double       sampled_time    = 0; ///< time of the last sample (s)
    double       last_error_time = 0; ///< time of the last error computed (s)
    unsigned int n_steps         = 0; ///< since the last sample
  };
} // namespace auxfem

#endif
