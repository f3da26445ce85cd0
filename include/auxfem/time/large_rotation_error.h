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
    /** Distance to the exact equilibrium over the motion, root mean squares;
     * not finite: there is no equilibrium near. */
    double relative = 0;
    /** As `relative`, of the largest translations of joints or, where joints
     * hardly move, of all nodes. */
    double translation = 0;
    double rotation    = 0; ///< largest (rad)
    /** Whether the exact stiffness has negative modes there. */
    bool        is_unstable = false;
    std::string location; ///< the unknown with the largest distance

    /** The reason to use exact kinematics, in words; empty: nothing.
     * @param allowed error of the motion */
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
   * by Newton's method, with the stiffness at rest where that serves. In
   * dynamics e has the inertia of a motion over the whole run, which replaces
   * supports that there may not be. Keeps nothing from one estimate to the
   * next; what computes is collective.
   */
  class LargeRotationErrorEstimator
  {
  public:
    /** @param small, exact must outlive the object; both equations are
     *   of the same numbering
     * @param allowed error, relative to the motion: larger rotations than go
     *   with it are not looked into */
    LargeRotationErrorEstimator(const Equations &small,
                                const Equations &exact,
                                double           allowed);

    /** The largest linear static answer to the loads in the run, with its
     * energies; nothing where there is none. */
    std::optional<State> static_answer();

    /** The error of these displacements and small rotations. */
    LargeRotationError at(const Vector &motion);

    /** Root mean square of free displacements, and of rotations times the mean
     * length of struts (m). */
    double size(const Vector &motion) const;

    /** Work of all estimates so far. */
    const Work &effort() const
    {
      return work;
    }

  private:
    bool factorize_at_rest(TangentSolver &solver) const;
    /** Displacements that answer the loads of @p time. */
    std::optional<Vector> linear_answer(const TimeLimit &time,
                                        TangentSolver   &solver) const;
    /** Newton's method; returns whether it converges.
     * @param uses_rest_stiffness with the stiffness at rest, which @p solver has */
    bool find_error(const Vector  &motion,
                    bool           uses_rest_stiffness,
                    TangentSolver &solver,
                    Vector        &error) const;
    /** The exact state after @p motion and @p error. */
    State exact_state(const Vector &motion, const Vector &error) const;
    /** Whether the stiffness there is positive, as far as that can be told. */
    bool is_positive(State exact, TangentSolver &solver) const;

    const RunPlan   &plan;
    const Equations &small, &exact;
    const double     allowed;
    const double     inertia; ///< of the error (1/s2)
    Work             work;
  };
} // namespace auxfem

#endif
