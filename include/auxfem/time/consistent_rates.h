#ifndef auxfem_time_consistent_rates_h
#define auxfem_time_consistent_rates_h

#include <auxfem/equations/evaluation.h>
#include <auxfem/equations/tangent_solver.h>
#include <auxfem/model/lattice_model.h>
#include <auxfem/time/schemes/time_scheme.h>

namespace auxfem
{
  /**
   * Velocities and accelerations that belong to a lattice at a given position:
   * accelerations a and multipliers lambda of constraints (rigid parts,
   * revolute hinges) from
   *
   * @code
   * M a + G^T lambda = f - f_int,   G a = -(dG/dt) v
   * @endcode
   *
   * and velocities that the constraints allow, G v = 0, nearest
   * to those given in the kinetic energy: M dv + G^T mu = 0, G dv = -G v, the
   * impulses of the constraints (Bayo & Ledesma, Nonlinear Dynamics 9, 1996).
   * Where the prescribed velocity of a support jumps, these are the equations
   * of the strike: dv is given there, and the row is the support's impulse.
   */
  class ConsistentRates
  {
  public:
    /**
     * @param solver is used for the mass matrix; what it held is lost. It must
     *   outlive the object.
     */
    explicit ConsistentRates(TangentSolver &solver);

    /**
     * Completes the state at t = 0 of a dynamic scene, which has the velocities
     * given to it. Supports that move with others strike. Where a free unknown
     * has no mass, M + @p dt / 2 C + @p dt^2 / 4 K stands in for M. Velocities
     * of rigid parts are freed of what these cannot have. Returns the state
     * just before supports struck.
     *
     * Throws InputError for an unknown without mass, damping and stiffness, and
     * for given velocities that are no round-off away from those of rigid
     * parts.
     */
    State start(State &state, double dt);

    /**
     * After start(), for a scheme that keeps unknowns without mass in
     * equilibrium: makes them known to @p state and takes their accelerations
     * from it. Throws InputError, naming it, if viscous forces depend on the
     * velocity of a displacement among them.
     */
    void keep_massless(State &state);

    /**
     * Puts velocities and accelerations of step.to, solved at the end of @p step,
     * right: undamped schemes carry on what is wrong in them with alternating
     * sign, and in turning parts it grows. Does nothing if a free unknown has
     * no mass. The residual and the internal variables are then those of the
     * instant: the step must be evaluated again.
     */
    void restore(const Evaluation &step);

    /**
     * Gives @p state the rates just after the time @p event (s), near that of
     * the state, at which loads or motions of supports jump, or their
     * derivatives. A free unknown without mass is treated as at the start.
     * Returns the state just before.
     */
    State update_after_jump(State &state, double event, double dt);

    /**
     * Impulses of supports (N s, N m s) in the last start() or
     * update_after_jump(), in their rows; nullptr if nothing was struck.
     */
    const Vector *impulses() const
    {
      return support_impulses.empty() ? nullptr : &support_impulses;
    }

  private:
    /** M at evaluation.to; false if it is singular. */
    bool prepare_mass(const Evaluation &evaluation);
    /** M + dt / 2 C + dt^2 / 4 K, factorized. */
    void prepare_substitute_mass(const Evaluation &evaluation, double dt);
    /** Largest |dg/dt| (m/s) over all ranks; the rates themselves into @p rates. */
    double find_rates(const State &state, std::vector<double> &rates) const;
    void   refuse_strain(const State &state, double rate) const;
    /**
     * Velocities of instant.to after the impulses of constraints, and of
     * supports whose velocity is not that of instant.from.
     */
    void apply_impulses(const Evaluation &instant, double dt);
    /** Those that change velocities by `increment` and its multipliers. */
    void find_impulses(const Evaluation &instant, double dt);
    void find_accelerations(const Evaluation &evaluation);
    /** Takes the accelerations of unknowns without mass, if known, away. */
    void clear_massless_accelerations(State &state) const;
    /** Makes `increment` zero for prescribed unknowns. */
    void zero_prescribed_rows();
    /** Solves for `increment`; throws ComputationError if that fails. */
    void solve();
    void refuse_empty_rows();
    /** Marks those of the massless unknowns that are damped; refuses
     * displacements among these. */
    void mark_damped(std::vector<double> &kinds, const Evaluation &now);
    /** 1 for owned rows of the matrix that are zero, else 0. */
    std::vector<double> empty_rows();
    /** Whether one of the flags is 1, over all ranks. */
    bool is_set_on_any_rank(const std::vector<double> &flags) const;

    TangentSolver      &solver;
    const LatticeModel &model;
    EvaluationResults   results;
    Vector              increment;
    /** Empty if nothing was struck. */
    Vector support_impulses;
    /** How the matrix that stands for M is solved with. */
    enum class Method
    {
      conjugate_gradients, ///< M alone, positive definite
      factorization
    };
    Method method = Method::factorization;
    /** Whether M has been found singular. */
    bool is_singular = false;
  };

  /**
   * Moves the guess for the end of @p step, which @p scheme has predicted to be
   * its start, on by unchanged accelerations, if the step is short for the
   * motion: velocities change by a small part of themselves. Else a guess ahead
   * would be further off. Collective.
   */
  void extrapolate_predictor(const ImplicitScheme &scheme,
                             const Evaluation     &step,
                             const LatticeModel   &model);

  /**
   * Moves the guess for the end of a @p step without inertia, which @p scheme
   * has predicted to be its start, on by as much as the step before has moved
   * it, if that is known: what is linear does so while loads go on as they did.
   */
  void repeat_last_increment(const ImplicitScheme &scheme,
                             const Evaluation     &step);
} // namespace auxfem

#endif
