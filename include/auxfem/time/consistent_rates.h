#ifndef auxfem_time_consistent_rates_h
#define auxfem_time_consistent_rates_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/model/lattice_model.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * Velocities and accelerations consistent with a given position:
   * accelerations a and multipliers lambda of constraints (rigid parts,
   * revolute hinges) from
   *
   * @code
   * M a + G^T lambda = f - f_int,   G a = -(dG/dt) v
   * @endcode
   *
   * Velocities are projected to G v = 0, nearest in the kinetic energy: M dv +
   * G^T mu = 0, G dv = -G v, where mu are impulses of constraints (Bayo &
   * Ledesma, Nonlinear Dynamics 9, 1996). Where the velocity of a support
   * jumps, dv is prescribed and the row yields the impulse of the support.
   */
  class ConsistentRates
  {
  public:
    /**
     * @param solver factorizes the mass matrix and loses its former matrix. It
     *   must outlive the object.
     */
    explicit ConsistentRates(TangentSolver &solver);

    /**
     * Completes the state at t = 0 of a dynamic scene with given velocities.
     * Projects velocities of rigid parts and applies impulses of moving
     * supports. Where a free unknown has no mass, M + @p dt / 2 C + @p dt^2 /
     * 4 K substitutes for M. Returns the state just before the impulses.
     *
     * Throws InputError for an unknown without mass, damping and stiffness,
     * and for given velocities that violate constraints by more than
     * round-off.
     */
    State start(State &state, double dt);

    /**
     * After start(), for a scheme that keeps unknowns without mass in
     * equilibrium: marks them in @p state and clears their accelerations.
     * Throws InputError, with the name, if viscous forces depend on the
     * velocity of a displacement among them.
     */
    void keep_massless(State &state);

    /**
     * Restores consistent rates in step.to, solved at the end of @p step.
     * Undamped schemes propagate their errors with alternating sign, which
     * grow in rotating parts. Does nothing if a free unknown has no mass. The
     * step must be evaluated again to update residual and internal variables.
     */
    void restore(const Evaluation &step);

    /**
     * Sets the rates of @p state to those just after the time @p event (s),
     * where loads, support motions or their derivatives jump. Free unknowns
     * without mass are treated as in start(). Returns the state just before.
     */
    State update_after_jump(State &state, double event, double dt);

    /**
     * Impulses of supports (N s, N m s) in their rows, of the last start() or
     * update_after_jump(); nullptr if there were none.
     */
    const Vector *impulses() const
    {
      return support_impulses.empty() ? nullptr : &support_impulses;
    }

  private:
    /** Prepares M at evaluation.to; false if it is singular. */
    bool prepare_mass(const Evaluation &evaluation);
    /** Factorizes M + dt / 2 C + dt^2 / 4 K. */
    void prepare_substitute_mass(const Evaluation &evaluation, double dt);
    /** Largest |dg/dt| (m/s) over all ranks; stores all of them in @p rates. */
    double find_rates(const State &state, std::vector<double> &rates) const;
    void   refuse_strain(const State &state, double rate) const;
    /**
     * Velocities of instant.to after impulses of constraints, and of supports
     * whose velocity differs from that in instant.from.
     */
    void apply_impulses(const Evaluation &instant, double dt);
    /**
     * Finds the impulses that change velocities by `increment` and its
     * multipliers.
     */
    void find_impulses(const Evaluation &instant, double dt);
    void find_accelerations(const Evaluation &evaluation);
    /** Clears the known accelerations of unknowns without mass. */
    void clear_massless_accelerations(State &state) const;
    /** Sets `increment` to zero for prescribed unknowns. */
    void zero_prescribed_rows();
    /** Solves for `increment`; throws ComputationError if that fails. */
    void solve();
    void refuse_empty_rows();
    /**
     * Marks massless unknowns that are damped; refuses displacements among
     * them.
     */
    void mark_damped(std::vector<double> &kinds, const Evaluation &now);
    /** 1 for owned rows of the matrix that are zero, else 0. */
    std::vector<double> empty_rows();
    /** Whether any flag is 1 on any rank. */
    bool is_set_on_any_rank(const std::vector<double> &flags) const;

    TangentSolver      &solver;
    const LatticeModel &model;
    EvaluationResults   results;
    Vector              increment;
    /** Empty without impulses. */
    Vector support_impulses;
    /** Linear solver of the matrix that stands for M. */
    enum class Method
    {
      conjugate_gradients, ///< M alone, positive definite
      factorization
    };
    Method method = Method::factorization;
    /** Whether M was found singular. */
    bool is_singular = false;
  };

  /**
   * Extrapolates the predictor of @p step, which @p scheme has set to its
   * start, with constant acceleration. Does so only while velocities change by
   * a small part of themselves; otherwise extrapolation would be worse.
   * Collective.
   */
  void extrapolate_predictor(const ImplicitScheme &scheme,
                             const Evaluation     &step,
                             const LatticeModel   &model);

  /**
   * Predicts the end of @p step with constant velocity. Where struts may touch,
   * accelerations of the start are those of impacts, which do not last.
   */
  void keep_velocities(const ImplicitScheme &scheme, const Evaluation &step);

  /**
   * Extrapolates the predictor of a @p step without inertia, which @p scheme
   * has set to its start, by the last increment if that is known. Linear
   * responses repeat it under steady load growth.
   */
  void repeat_last_increment(const ImplicitScheme &scheme,
                             const Evaluation     &step);
} // namespace auxfem

#endif
