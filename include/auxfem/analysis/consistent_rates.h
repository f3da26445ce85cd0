#ifndef auxfem_analysis_consistent_rates_h
#define auxfem_analysis_consistent_rates_h

#include <auxfem/analysis/tangent_solver.h>

namespace auxfem
{
  /**
   * Velocities and accelerations that belong to a lattice at a given position:
   * accelerations a and multipliers lambda of conditions (rigid parts, revolute
   * hinges) from
   *
   * @code
   * M a + G^T lambda = f - f_int,   G a = -(dG/dt) v
   * @endcode
   *
   * and velocities that the conditions allow, G v = 0, nearest
   * to those given in the kinetic energy: M dv + G^T mu = 0, G dv = -G v, the
   * impulses of the conditions (Bayo & Ledesma, Nonlinear Dynamics 9, 1996).
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
     * Completes the state at t = 0 of a dynamic scene. Where a free unknown has
     * no mass, M + @p dt / 2 C + @p dt^2 / 4 K stands in for M. Velocities of
     * rigid parts are freed of what these cannot have.
     *
     * Throws InputError for an unknown without mass, damping and stiffness, and
     * for velocities that are no round-off away from those of rigid parts.
     */
    void start(State &state, double dt);

    /**
     * After start(), for a scheme that keeps unknowns without mass in
     * equilibrium: makes them known to @p state and takes their accelerations
     * from it. Throws InputError, naming it, if viscous forces depend on the
     * velocity of a displacement among them.
     */
    void keep_massless(State &state);

    /**
     * Puts velocities and accelerations of @p state, solved at the end of a
     * step, right: undamped schemes carry on what is wrong in them with
     * alternating sign, and in turning parts it grows. Does nothing if a free
     * unknown has no mass. The residual and the internal variables are then
     * those of the instant: the step must be evaluated again.
     */
    void restore(State &state);

    /**
     * The same for a state at which loads jump: its rates become those that the
     * loads just after it ask for.
     */
    void renew(State &state);

  private:
    /** As restore(); false if a free unknown has no mass. */
    bool restore(const Evaluation &evaluation);
    /** M at evaluation.to; false if it is singular. */
    bool prepare_mass(const Evaluation &evaluation);
    /** M + dt / 2 C + dt^2 / 4 K, factorized. */
    void prepare_stand_in(const Evaluation &evaluation, double dt);
    /** Largest |dg/dt| (m/s) over all ranks; the rates themselves into @p rates. */
    double find_rates(const State &state, std::vector<double> &rates) const;
    void   refuse_strain(const State &state, double rate, double dt) const;
    void   project_velocities(State &state, const std::vector<double> &rates);
    void   find_accelerations(const Evaluation &evaluation);
    /** Solves for `increment`; throws ComputationError if that fails. */
    void solve();
    void refuse_empty_rows();
    /** Marks those of the massless unknowns that are damped; refuses
     * displacements among these. */
    void mark_damped(std::vector<double> &kinds, const Evaluation &now);
    /** 1 for owned rows of the matrix that are zero, else 0. */
    std::vector<double> empty_rows();
    /** Whether one of the flags is 1, over all ranks. */
    bool is_anywhere(const std::vector<double> &flags) const;

    TangentSolver      &solver;
    const LatticeModel &model;
    EvaluationResults   results;
    Vector              increment;
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
} // namespace auxfem

#endif
