#ifndef auxfem_analysis_kinematic_correction_h
#define auxfem_analysis_kinematic_correction_h

#include <auxfem/analysis/small_displacement_error.h>
#include <auxfem/analysis/watch.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/scene/scene.h>

#include <optional>
#include <string>

namespace auxfem
{
  /**
   * By how much small displacements u are wrong. The difference e to exact
   * kinematics under the same loads and inertia forces is found by Newton's
   * method from
   *
   * @code
   * R_exact(u + e) = R_small(u)
   * @endcode
   *
   * where with inertia e has that of a motion over the whole run, so that
   * nothing needs supports. Sizes are root mean squares over free
   * displacements, and rotations times the mean strut length. What computes is
   * collective.
   */
  class KinematicCorrection
  {
  public:
    /** @param exact solver of the exact equations, which must outlive the
     * object; what it held is lost. */
    KinematicCorrection(const Scene &scene, TangentSolver &exact);

    /**
     * Of the static answer to the loads at some times of the run. Does nothing
     * where the linear equations cannot be solved.
     */
    void look_at_loads();

    /** Before states are looked at. @param small their equations, which must
     * outlive the object */
    void begin(const Equations &small);

    /**
     * Of a state of small displacements, which has its energies. Does nothing
     * where less than a quarter has been added to the motion and to the first
     * estimate of its error since the last look, and little error was found.
     */
    void look_at(const State &state);

    /**
     * Whether @p state, of any step, has to be looked at: the first estimate of
     * its error (SmallDisplacementEstimate) has grown so much since the last
     * look that the error may be near what is allowed. With inertia it is taken
     * in every tenth step.
     */
    bool asks_for_look(const State &state);

    /**
     * Largest so far, over the largest displacements so far; not finite if
     * there is no equilibrium near. With inertia vibrations have gone out of
     * phase: that is the static error times half the angle they have turned by.
     */
    double relative() const;

    /**
     * What asks for exact kinematics, in words: an error, or an angle less its
     * sine or cosine, above @p allowed, a stiffness that is not positive, strains or struts that a watch would
     * tell of; empty: nothing.
     */
    std::string why_exact(double allowed) const;

    /** @name For runs that are resumed. Collective. */
    ///@{
    void save(Records &records) const;
    void resume(const Records &records);
    ///@}

  private:
    /** The unloaded state, whose rates are zero. Made anew for every look:
     * looks are rare. */
    State at_rest() const;
    /** The exact state of @p motion with `error` added. */
    State exact_state(const State &motion) const;
    /**
     * Newton's method for `error`.
     * @param motion of small displacements
     * @param evaluation_of what is asked at an exact state, from one before it
     * @param left residual of the small displacements
     */
    template <class EvaluationOf>
    void find(const State        &motion,
              const EvaluationOf &evaluation_of,
              const Vector       &left);
    /** What else the exact state at the end of that tells.
     * @param is_factorized_near whether the factorization is of a stiffness not
     * far from there */
    void judge(const Evaluation        &evaluation,
               const EvaluationResults &results,
               bool                     is_factorized_near);
    /** Of its increments. */
    Vector right_side(const State &exact, const Vector &left) const;
    /** Of the exact stiffness; returns whether that succeeds. */
    bool factorize(const Evaluation        &evaluation,
                   const EvaluationResults &results);
    /** Displacements that answer the loads of @p time; nothing if none can be
     * found. */
    std::optional<Vector> linear_answer(const TimeLimit &time);
    /** Where the error last looked at is largest. */
    std::string location() const;
    /** Looks are rare: neither memory nor a checkpoint holds it till the next.
     */
    void forget_tangent();
    /** First guess of `error` from that of the look before, for a motion of
     * @p size (m). */
    void grow_error(double size);

    const Scene        &scene;
    TangentSolver      &solver;
    const NodeRotations rotations;
    const double        inertia; ///< of the error (1/s2)
    Vector              error;
    double              largest_error = 0, largest_motion = 0; ///< m
    double              largest_rotation = 0;                  ///< rad
    double              size_of_motion   = 0; ///< at the last look (m)
    double              way              = 0; ///< so far (m)
    double              time             = 0; ///< of the last look (s)
    const Equations    *small = nullptr; ///< from begin() on, with `estimate`
    std::optional<SmallDisplacementEstimate> estimate;
    double       estimated = 0; ///< at the last look
    unsigned int n_steps   = 0; ///< since the last estimate
    std::vector<std::unique_ptr<Watch>> watches;
    bool                                unstable = false, is_factorized = false;
  };
} // namespace auxfem

#endif
