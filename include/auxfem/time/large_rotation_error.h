#ifndef auxfem_time_large_rotation_error_h
#define auxfem_time_large_rotation_error_h

#include <auxfem/equations/tangent_solver.h>

#include <optional>
#include <string>

namespace auxfem
{
  /** Error of a motion by small displacements against exact kinematics. */
  struct LargeRotationError
  {
    /**
     * Distance to the exact equilibrium over the motion, both as root mean
     * squares; not finite if there is no equilibrium nearby.
     */
    double relative = 0;
    /**
     * As `relative`, for the largest translations of joints, or of all nodes
     * if joints hardly move.
     */
    double translation = 0;
    double rotation    = 0; ///< largest one (rad)
    /** Whether the exact stiffness there has negative modes. */
    bool        is_unstable = false;
    std::string location; ///< unknown with the largest distance

    /**
     * Reason to use exact kinematics, as text; empty if there is none.
     * @param allowed relative error of the motion
     */
    std::string reason(double allowed) const;
  };

  /** `the estimated error of small displacements is 2 %` */
  std::string small_displacement_error_text(double error);

  /**
   * Estimates the error of small displacements u: the distance e to the exact
   * equilibrium under the same loads,
   *
   * @code
   * R_exact(u + e) = R_small(u)
   * @endcode
   *
   * by Newton's method, with the stiffness at rest if that converges. In
   * dynamics e has inertia over the duration of the run, which replaces
   * missing supports. Estimates are independent of each other and collective.
   */
  class LargeRotationErrorEstimator
  {
  public:
    /**
     * @param small, exact equations with the same numbering; must outlive the
     *   object
     * @param allowed relative error; motions with larger rotations than that
     *   implies are not computed
     */
    LargeRotationErrorEstimator(const Equations &small,
                                const Equations &exact,
                                double           allowed);

    /**
     * The largest linear static response to the loads of the run, with its
     * energies; empty if there is none.
     */
    std::optional<State> static_answer();

    /** The error of these displacements and small rotations. */
    LargeRotationError at(const Vector &motion);

    /**
     * Root mean square of free displacements, and of rotations times the mean
     * strut length (m).
     */
    double size(const Vector &motion) const;

    /** Effort of all estimates so far. */
    const Work &effort() const
    {
      return work;
    }

  private:
    bool factorize_at_rest(TangentSolver &solver) const;
    /** Linear response to the loads at @p time. */
    std::optional<Vector> linear_answer(const TimeLimit &time,
                                        TangentSolver   &solver) const;
    /**
     * Newton's method; returns whether it converges.
     * @param uses_rest_stiffness with the stiffness at rest, factorized in @p
     *   solver
     */
    bool find_error(const Vector  &motion,
                    bool           uses_rest_stiffness,
                    TangentSolver &solver,
                    Vector        &error) const;
    /** Exact state after @p motion and @p error. */
    State exact_state(const Vector &motion, const Vector &error) const;
    /** Whether the stiffness is positive definite, or cannot be checked. */
    bool is_positive(State exact, TangentSolver &solver) const;

    const RunPlan   &plan;
    const Equations &small, &exact;
    const double     allowed;
    const double     inertia; ///< of the error (1/s2)
    Work             work;
  };
} // namespace auxfem

#endif
