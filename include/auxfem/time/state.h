#ifndef auxfem_time_state_h
#define auxfem_time_state_h

#include <auxfem/elements/rotation.h>
#include <auxfem/time/energies.h>

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

  /**
   * A part of State::history: internal variables of the same kind. Its items
   * are named by numbers that are the same on every number of ranks, so that a
   * run can be resumed on another.
   */
  struct HistoryRecord
  {
    /** Who keeps it and what it is, e.g. `damper: internal variables`. */
    std::string name;
    /** Numbers of the items kept on this rank, in order. */
    std::vector<unsigned int> items;
    unsigned int              values_per_item = 1;
    /** Index of the first value in State::history. */
    std::size_t first = 0;
  };

  /** Which parts of the state a scene needs, as its effects ask for them. */
  class StateLayout
  {
  public:
    /** Dynamics, or viscosity in statics. */
    bool velocity     = false;
    bool acceleration = false; ///< dynamics
    /** Alpha methods other than Newmark. */
    bool algorithmic_acceleration = false;
    /** Rotations in space kept as quaternions; none if they stay small. */
    unsigned int n_rotations = 0;
    /** Local unknowns that are large rotations in the plane; for schemes that
     * balance means. */
    std::vector<int> plane_rotations;
    EnergyLedger     energies;

    /** Adds a record; returns the index of its first value. */
    std::size_t keep(const std::string               &name,
                     const std::vector<unsigned int> &items,
                     unsigned int                     values_per_item);

    const std::vector<HistoryRecord> &history() const;

    /** Values of all records. */
    std::size_t n_history() const;

  private:
    std::vector<HistoryRecord> records;
  };

  /**
   * Everything that describes the structure at one time, and all that a run
   * needs to go on from there. There is one accepted state, owned by the
   * analysis, and one trial state, owned by the time stepper.
   */
  struct State
  {
    /** At rest; @p unknowns are all local ones (DofNumbering::local_map()). */
    State(const Epetra_BlockMap &unknowns, const StateLayout &layout);

    double        time = 0; ///< s
    unsigned long step = 0;
    /** By which the loads of `time` are multiplied. */
    double load_factor = 1;

    /** M, m, rad; the multipliers of constraints (N) lie here too, without
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
     * m); in rows of multipliers the constraints (m).
     */
    Vector residual;

    /**
     * Large rotations in space since rest, in the order of
     * DofNumbering::spatial_rotations().
     */
    std::vector<Quaternion> rotations;

    /** StateLayout::plane_rotations. */
    std::shared_ptr<const std::vector<int>> plane_rotations;

    /** Internal variables, in the order of StateLayout::history(). */
    std::vector<double> history;

    /** Energies of the whole lattice, known for accepted states. */
    Energies energies;

    /** @name This rank's share, by entry of the ledger. */
    ///@{
    /** Dissipated so far, and work done so far (J). */
    std::vector<double> energy_sums;
    /** Power at `time` of what is summed up by the trapezoidal rule (W). */
    std::vector<double> powers;
    ///@}

    /** @name Largest so far in the run, what errors are judged by. */
    ///@{
    double largest_force  = 0; ///< Newton's force scale (N)
    double largest_energy = 0; ///< mechanical or dissipated (J)
    ///@}
  };
} // namespace auxfem

#endif
