#ifndef auxfem_analysis_consistent_rates_h
#define auxfem_analysis_consistent_rates_h

#include <auxfem/system/linear_solver.h>
#include <auxfem/system/system.h>

namespace auxfem
{
  /**
   * Velocities and accelerations that belong to a lattice at given places:
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
     * @param matrix, solver are used for the mass matrix; what they held is
     *   lost. They must outlive the object.
     */
    ConsistentRates(System        &system,
                    TangentMatrix &matrix,
                    LinearSolver  &solver);

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
     * Puts velocities and accelerations of @p state, solved at the end of a
     * step, right: undamped schemes carry on what is wrong in them with
     * alternating sign, and in turning parts it grows. Does nothing if a free
     * unknown has no mass. Effects then know the state at rest in time: the
     * step must be evaluated again.
     */
    void restore(State &state);

  private:
    /** M at step.to, factorized; false if it is singular. */
    bool factorize_mass(const Step &step);
    /** Largest |dg/dt| (m/s) over all ranks; the rates themselves into @p rates. */
    double find_rates(const State &state, std::vector<double> &rates) const;
    void   refuse_strain(const State &state, double rate, double dt) const;
    void   project_velocities(State &state, const std::vector<double> &rates);
    void   find_accelerations(const Step &step);
    /** Solves for `increment`; throws ComputationError if that fails. */
    void solve();
    bool has_empty_row() const;
    void refuse_empty_rows() const;

    System        &system;
    TangentMatrix &matrix;
    LinearSolver  &solver;
    Vector         increment;
    /** Whether M has been found singular. */
    bool is_singular = false;
  };
} // namespace auxfem

#endif
