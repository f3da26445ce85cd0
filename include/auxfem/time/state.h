#ifndef auxfem_time_state_h
#define auxfem_time_state_h

#include <auxfem/elements/rotation.h>

#include <Epetra_Vector.h>

#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Values at all local unknowns (owned, then ghosts). Ghosts are up to date,
   * but for residuals, which are complete in owned rows only.
   */
  using Vector = Epetra_Vector;

  /** Three of @p values, of a displacement or a rotation, say. */
  inline SpaceVector vector_at(const double *values, const int *unknowns)
  {
    return SpaceVector(
      {values[unknowns[0]], values[unknowns[1]], values[unknowns[2]]});
  }

  /** Which parts of the state a scene needs. */
  struct StateLayout
  {
    /** Dynamics, or viscosity in statics. */
    bool velocity     = false;
    bool acceleration = false; ///< dynamics
    /** Alpha methods other than Newmark. */
    bool algorithmic_acceleration = false;
    /** Internal variables of connectors. */
    unsigned int n_history    = 0;
    unsigned int n_dissipated = 0; ///< viscous connectors
    /** Rotations in space kept as quaternions; none if they stay small. */
    unsigned int n_rotations = 0;
  };

  /** Energies at one time (J). */
  struct Energies
  {
    double kinetic    = 0;
    double strain     = 0; ///< in the struts (and rotational springs)
    double stored     = 0; ///< in the springs of connectors
    double dissipated = 0; ///< in connectors and struts, since the start
    /** Work of loads and prescribed motion since the start. */
    double external = 0;

    double total() const
    {
      return kinetic + strain + stored;
    }

    /**
     * total + dissipated - external - @p initial_total: zero but for the error of the
     * time integration (and its numerical damping, if it has any).
     */
    double balance(double initial_total) const
    {
      return total() + dissipated - external - initial_total;
    }
  };

  /**
   * Everything that describes the structure at one time. There is one accepted
   * state, owned by run(), and one trial state, owned by the time stepper.
   */
  struct State
  {
    /** At rest; @p unknowns are all local ones (DofNumbering::local_map()). */
    State(const Epetra_BlockMap &unknowns, const StateLayout &layout);

    double        time = 0; ///< s
    unsigned long step = 0;

    /** M, m, rad; the multipliers of rigid parts (N) lie here too, without
     * rates. Large rotations in space: see NodeRotations. */
    Vector displacement;

    std::optional<Vector> velocity;     ///< m/s, m/s, rad/s
    std::optional<Vector> acceleration; ///< satisfies equilibrium at `time`

    /**
     * The auxiliary acceleration of Arnold & Bruels 2007; only in alpha
     * methods with a shift.
     */
    std::optional<Vector> algorithmic_acceleration;

    /**
     * Internal + inertia - applied force. Zero to the Newton tolerance in free
     * rows; in prescribed rows the force of the support on the lattice (N, N
     * m); in rows of multipliers the conditions (m).
     */
    Vector residual;

    /**
     * Large rotations in space since rest, in the order of
     * DofNumbering::spatial_rotations().
     */
    std::vector<Quaternion> rotations;

    /**
     * Internal variables of connectors, group after group (see
     * ConnectorForces).
     */
    std::vector<double> history;

    /** Energy lost so far in each viscous connector (J). */
    std::vector<double> dissipated;

    /** By loads and prescribed motion so far, this rank's share (J). */
    double external_work = 0;
    /** Lost in the struts' own damping so far, this rank's share (J). */
    double strut_dissipation = 0;
    /** Being lost there now, this rank's share (W). */
    double strut_damping_power = 0;

    /** Energies of the whole lattice, known for accepted states. */
    Energies energies;
  };
} // namespace auxfem

#endif
