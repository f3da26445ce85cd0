#ifndef auxfem_analysis_kinematic_correction_h
#define auxfem_analysis_kinematic_correction_h

#include <auxfem/analysis/exact_stiffness.h>
#include <auxfem/analysis/stable_motions.h>
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

    /** Before states are looked at: of the loads only what is stable is
     * remembered. @param small their equations, which must outlive the object */
    void begin(const Equations &small);

    /**
     * Of a state of small displacements, which has its energies. Does nothing
     * where what was seen before tells that it is stable and its error small.
     */
    void look_at(const State &state);

    /**
     * Whether @p state, of any step, has to be looked at: the first estimate of
     * its error (SmallDisplacementEstimate) and the size of the motion have
     * grown so much since the last look that the error may be near what is
     * allowed, or that it may be unstable. With inertia they are taken in every
     * twentieth step.
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
    /** Forgets what was seen but for what is stable. */
    void begin_anew();
    /** The exact state of so many @p times @p motion, with the error that it
     * has then. */
    State exact_state(const State &motion, double times) const;
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
    /** The same from the first guess in `error`, with the stiffness at rest if
     * it is there, else with others for as long as they serve; whether that
     * converges. Looks at what it has found.
     * @param size of the motion (m) */
    template <class EvaluationOf>
    bool converge(const State        &motion,
                  double              size,
                  const EvaluationOf &evaluation_of,
                  const Vector       &left);
    /**
     * Whether the exact stiffness at the end of that is positive. It is looked
     * at ahead, unless loads follow the motion, so that it need not be known
     * for each motion.
     * @param size of the motion (m)
     * @param now of the exact state
     */
    template <class EvaluationOf>
    void judge_stability(const State                  &motion,
                         double                        size,
                         const SmallDisplacementError &now,
                         const EvaluationOf           &evaluation_of);
    /** Of its increments. */
    Vector right_side(const State &exact, const Vector &left) const;
    /** @name What the looks so far tell of a motion of @p size (m) whose first
     * estimate is @p now. */
    ///@{
    /** By what it is larger than all of them. */
    double growth(double size, const SmallDisplacementError &now) const;
    bool is_known_little(double size, const SmallDisplacementError &now) const;
    ///@}
    /** Of the motion up to @p state. */
    void add_way(const State &state);
    /** The first estimate of a state, taken once. */
    const SmallDisplacementError &estimate_at(const State &state);
    /** Displacements that answer the loads of @p time; nothing if none can be
     * found. */
    std::optional<Vector> linear_answer(const TimeLimit &time);
    /** Where the error last looked at is largest. */
    std::string location() const;
    /** First guess of `error` from that of the look before, for a motion of
     * @p size (m). */
    void grow_error(double size);

    const Scene                    &scene;
    const bool                      has_follower_loads;
    TangentSolver                  &solver;
    const NodeRotations             rotations;
    const double                    inertia; ///< of the error (1/s2)
    ExactStiffness                  stiffness;
    const SmallDisplacementEstimate of_exact; ///< compression of exact states
    Vector                          error;
    struct
    {
      double largest_error = 0, largest_motion = 0; ///< m
      double largest_rotation = 0;                  ///< rad
      bool   unstable         = false;
    } worst;                             ///< since begin_anew()
    double           size_of_motion = 0; ///< at the last look (m)
    double           way            = 0; ///< so far (m)
    double           time           = 0; ///< up to which that is (s)
    const Equations *small = nullptr;    ///< from begin() on, with `estimate`
    std::optional<SmallDisplacementEstimate> estimate;
    std::optional<std::pair<double, SmallDisplacementError>>
                 known_estimate; ///< with its time (s)
    double       estimated = 0;  ///< at the last look
    unsigned int n_steps   = 0;  ///< since the last estimate
    std::vector<std::unique_ptr<Watch>> watches;
    StableMotions                       stable;
  };
} // namespace auxfem

#endif
