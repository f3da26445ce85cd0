#ifndef auxfem_state_state_h
#define auxfem_state_state_h

#include <auxfem/algebra/unknowns.h>
#include <auxfem/mathematics/rotation.h>
#include <auxfem/state/checkpoint_archive.h>
#include <auxfem/state/energies.h>

#include <array>
#include <optional>
#include <vector>

namespace auxfem
{
  /**
   * Entries of State::is_massless. Damped: viscous forces depend on the
   * velocity of the unknown.
   */
  constexpr double massless = 1, massless_and_damped = 2;

  /** Three of @p values, for instance of a displacement or rotation. */
  inline SpaceVector vector_at(const double *values, const int *unknowns)
  {
    return SpaceVector(
      {values[unknowns[0]], values[unknowns[1]], values[unknowns[2]]});
  }

  /** Position of a state on an equilibrium path. */
  struct PathPosition
  {
    /** Factor of all loads and prescribed motions, see proportional_loads(). */
    double load_factor = 0;
    /** Number of negative eigenvalues of the stiffness; empty if unknown. */
    std::optional<unsigned long> n_negative;
    /**
     * Sign of the determinant of the stiffness, 1 in stable equilibrium; empty
     * if unknown.
     */
    std::optional<int> determinant_sign;
  };

  /** Failures of the struts of the lattice in State::history, two values each,
   * equal on all ranks. */
  struct FailureRecords
  {
    static constexpr unsigned int values_per_strut = 2;

    /** Time at which @p strut passed its limit (s); empty: it has not. */
    std::optional<double> time_of(const std::vector<double> &history,
                                  const unsigned int         strut) const
    {
      const double *values = &history[first + values_per_strut * strut];
      return values[0] > 0 ? std::optional<double>(values[1]) : std::nullopt;
    }

    void set_time(const unsigned int   strut,
                  const double         time,
                  std::vector<double> &history) const
    {
      double *values = &history[first + values_per_strut * strut];
      values[0]      = 1;
      values[1]      = time;
    }

    std::size_t first = 0; ///< position in the history
  };

  /** Parts of the state that a scene needs; effects request them. */
  struct StateLayout
  {
    /** Dynamics, or viscosity in statics. */
    bool velocity     = false;
    bool acceleration = false; ///< dynamics
    bool path         = false; ///< static paths
    /** Alpha methods except Newmark. */
    bool algorithmic_acceleration = false;
    bool compensation             = false; ///< discrete-gradient schemes
    /** Struts that lose energy: their ledger has the work of mean forces. */
    bool mean_work = false;
    /**
     * Number of rotations in space stored as quaternions; 0 if they stay
     * small.
     */
    unsigned int n_rotations = 0;
    /**
     * Local unknowns that are large rotations in the plane; for
     * discrete-gradient schemes.
     */
    std::vector<int> plane_rotations;
    /**
     * Local unknowns of every large rotation in space; for such schemes too.
     */
    std::vector<std::array<int, 3>> space_rotations;
    EnergyLedger                    energies;
    RecordLayout                    history; ///< internal variables
    /** If struts may break. */
    std::optional<FailureRecords> failures;
    /** Ranges of history that obey differential equations: begin, end. */
    std::vector<std::pair<std::size_t, std::size_t>> integrated;
  };

  /**
   * Complete description of the structure at one time; later motion depends on
   * nothing else. LatticeRun owns the accepted state, TimeStepper the trial
   * state. Ghosts are up to date, except those of residuals, which are
   * complete in owned rows only.
   */
  struct State
  {
    /** State at rest with @p n_unknowns = UnknownLayout::n_local(). */
    State(unsigned int n_unknowns, const StateLayout &layout);

    /**
     * Adds ghosts that @p layout has gained and fetches their values.
     * Collective.
     */
    void extend_ghosts(const UnknownLayout &layout);

    /** s; on an equilibrium path the arc length (m). */
    double        time = 0;
    unsigned long step = 0;
    /** Only on an equilibrium path. */
    std::optional<PathPosition> path;

    /**
     * The previous accepted state, for schemes without inertia: velocities and
     * work of second order need it. Empty at the start of a run and after a
     * kink of loads.
     */
    struct Before
    {
      double time_of_loads; ///< as in time_of_loads()
      /**
       * Length of the step from there (s). Differences of times have round-off
       * and would make equal steps unequal.
       */
      double dt;
      Vector displacement, residual;
    };
    std::optional<Before> before;

    /**
     * M, m, rad; also multipliers of constraints (N), without rates. Large
     * rotations in space: see NodeRotations.
     */
    Vector displacement;

    std::optional<Vector> velocity;     ///< m/s, m/s, rad/s
    std::optional<Vector> acceleration; ///< in equilibrium at `time`

    /**
     * Auxiliary acceleration of Arnold & Bruels (2007); only in alpha methods
     * with a shift.
     */
    std::optional<Vector> algorithmic_acceleration;

    /**
     * Kahan's compensation: the sum with `displacement` has twice the digits.
     * Otherwise the round-off of large positions would deform the structure
     * (see relative_displacement()).
     */
    std::optional<Vector> compensation;

    /**
     * Not 0 for free unknowns with neither mass nor constraint, known after
     * the start of a run with inertia. Some schemes keep them in equilibrium
     * so that their accelerations do not grow.
     */
    std::optional<Vector> is_massless;

    /**
     * Internal + inertia - applied force. Zero to Newton's tolerance in free
     * rows; in prescribed rows the support force on the lattice (N, N m); in
     * multiplier rows the constraint (m).
     */
    Vector residual;

    /**
     * Large rotations in space since rest, in the order of
     * DofNumbering::rotations().
     */
    std::vector<Quaternion> rotations;

    /** StateLayout::mean_work. */
    bool has_mean_work;

    /** StateLayout::plane_rotations. */
    std::shared_ptr<const std::vector<int>> plane_rotations;

    /** StateLayout::space_rotations. */
    std::shared_ptr<const std::vector<std::array<int, 3>>> space_rotations;

    /** Internal variables, in the order of StateLayout::history. */
    std::vector<double> history;

    /** Energies of the whole lattice; valid in accepted states. */
    Energies energies;

    /**
     * Sums of dissipation, numerical energy and work so far (J): this rank's
     * share, by entry of the ledger.
     */
    std::vector<double> energy_sums;

    /** @name Largest values so far in the run, references for errors. */
    ///@{
    double largest_force = 0; ///< Newton's force scale (N)
    /** Reference of the residual in each owned row (N, N m). */
    Vector largest_forces;
    double largest_energy = 0; ///< mechanical or dissipated (J)
    ///@}
  };

  /**
   * Argument of time histories: the time (s), on an equilibrium path the load
   * factor.
   */
  inline double time_of_loads(const State &state)
  {
    return state.path ? state.path->load_factor : state.time;
  }
} // namespace auxfem

#endif
