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
  /** The change of a linear answer by axial forces. */
  struct SecondOrderChange
  {
    /** The larger of the change of the displacements over the displacements
     * and that of the forces over the forces, in the norm of their energy. */
    double relative = 0;
    /** Whether the stiffness under the axial forces has negative modes;
     * nothing where the linear solver does not tell. */
    std::optional<bool> is_unstable = {};
  };

  /**
   * Change of displacements and forces of a linear scene by axial forces,
   * by the stiffness K + K_g of the structure as it is at rest with the forces
   * that it bears: linear stability theory. Beyond the critical load that
   * stiffness has no meaning for the answer; K takes its place, as if buckling
   * were excluded. Costs one or two factorizations each time.
   */
  class SecondOrderEffect
  {
  public:
    /** @param equations of small displacements, must outlive the object.
     */
    explicit SecondOrderEffect(const Equations &equations);
    ~SecondOrderEffect();

    /**
     * The change in @p state; nothing where there is no such structure with
     * large rotations or it moves freely. Collective.
     * @param state by small displacements, which has its energies
     * @param forces_by_turning forces (N) by local unknown that axial forces
     *   exert on turned struts
     */
    std::optional<SecondOrderChange> at(const State  &state,
                                        const Vector &forces_by_turning);

    /** The equations of the same structure with large rotations; nullptr where
     * these are not possible. Collective. */
    const Equations *exact_equations();

    /** Effort of the checks since the last call. */
    Work collect_effort();

  private:
    /** The same structure with large rotations. */
    struct Exact;

    /** The change by @p forces (N) with the factors at hand. */
    std::optional<double> relative_change(const State  &state,
                                          const Vector &forces);

    const Equations       &equations;
    Work                   effort;
    std::unique_ptr<Exact> exact; ///< made when it is needed
    /** There is no such structure. */
    bool is_impossible = false;
  };

  /** Small displacements have become wrong; what() says why and when. */
  class BeyondSmallDisplacements : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * Ends a run by small displacements where their error exceeds
   * `Effects/Tolerance`, the structure becomes unstable, or struts touch.
   * Samples the motion in every step, with inertia in every twentieth. What
   * computes is collective.
   */
  class SmallDisplacementLimit
  {
  public:
    /** @param small, exact must outlive the object, as
     *   LargeRotationErrorEstimator */
    SmallDisplacementLimit(const Equations &small, const Equations &exact);

    /** The error of the static answer to the loads; with inertia of twice that,
     * as to sudden loads. */
    LargeRotationError check_static_answer();

    /** Of each accepted step. Throws BeyondSmallDisplacements. */
    void check(const Evaluation &step);

    /**
     * Largest so far, over the largest displacements. With inertia vibrations
     * have gone out of phase: half of it for each radian they have turned by.
     */
    double error() const;

    const Work &effort() const
    {
      return estimator.effort();
    }

    void serialize(CheckpointArchive &archive);

  private:
    /** Motions that are known to be stable and to have a small error: they are
     * no larger, and press no strut more, than one for which both were
     * computed.
     */
    struct Envelope
    {
      double              size  = 0;                  ///< m
      double              total = 0, compression = 0; ///< as the estimate
      std::vector<double> compressions;               ///< by strut
      double              error = 0; ///< of the largest of them (m)
    };

    /** Whether a motion of @p size (m) is among them. */
    bool is_inside(double size, const SmallDisplacementError &motion) const;
    /** Replaces them by those up to @p factor times a motion, which has the
     * @p error (m) then. */
    void extend(double                        factor,
                double                        size,
                const SmallDisplacementError &motion,
                double                        error);
    /** Why the motion is beyond the limit; empty: it is not. */
    std::string reason(const State &state);
    /** The same of @p factor times the motion, with which the envelope is
     * extended. */
    std::string compute(double                        factor,
                        const State                  &state,
                        double                        size,
                        const SmallDisplacementError &motion);

    const RunPlan                        &plan;
    const UnknownLayout                  &layout;
    const bool                            has_inertia;
    LargeRotationErrorEstimator           estimator;
    const SmallDisplacementEstimate       estimate;
    Envelope                              envelope;
    std::unique_ptr<FirstContactDetector> detector;   ///< none: no contact
    double       largest_error = 0, largest_size = 0; ///< so far (m)
    double       way      = 0;                        ///< of the motion (m)
    double       sampled  = 0;                        ///< time (s)
    double       computed = 0; ///< time of the last error computed (s)
    unsigned int n_steps  = 0; ///< since the last sample
  };
} // namespace auxfem

#endif
