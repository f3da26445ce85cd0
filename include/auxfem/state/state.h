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
  /** Entries of State::is_massless; damped: viscous forces depend on the
   * velocity of the unknown. */
  constexpr double massless = 1, massless_and_damped = 2;

  /** Three of @p values, of a displacement or a rotation, say. */
  inline SpaceVector vector_at(const double *values, const int *unknowns)
  {
    return SpaceVector(
      {values[unknowns[0]], values[unknowns[1]], values[unknowns[2]]});
  }

  /** Where a state lies on a path of equilibria. */
  struct PathPosition
  {
    /** All loads and prescribed motions are those of this factor, see
     * proportional_loads(). */
    double load_factor = 0;
    /** Negative eigenvalues of the stiffness; nothing where they are not known.
     */
    std::optional<unsigned long> n_negative;
    /** 1 or -1: sign of the determinant of the stiffness, 1 in stable
     * equilibrium; nothing where it is not known. */
    std::optional<int> determinant_sign;
  };

  /** Which parts of the state a scene needs, as its effects ask for them. */
  struct StateLayout
  {
    /** Dynamics, or viscosity in statics. */
    bool velocity     = false;
    bool acceleration = false; ///< dynamics
    bool path         = false; ///< paths of equilibria
    /** Alpha methods other than Newmark. */
    bool algorithmic_acceleration = false;
    bool compensation             = false; ///< schemes that balance means
    /** Rotations in space kept as quaternions; none if they stay small. */
    unsigned int n_rotations = 0;
    /** Local unknowns that are large rotations in the plane; for schemes that
     * balance means. */
    std::vector<int> plane_rotations;
    /** Those of every large rotation in space; for such schemes too. */
    std::vector<std::array<int, 3>> space_rotations;
    EnergyLedger                    energies;
    RecordLayout                    history; ///< internal variables
    /** Those of them that obey differential equations: begin, end. */
    std::vector<std::pair<std::size_t, std::size_t>> integrated;
  };

  /**
   * Everything that describes the structure at one time, and all that its
   * motion from there on depends on. There is one accepted state, owned by the
   * analysis, and one trial state, owned by the time stepper. Ghosts are up to
   * date, but for residuals, which are complete in owned rows only.
   */
  struct State
  {
    /** At rest; @p n_unknowns of UnknownLayout::n_local(). */
    State(unsigned int n_unknowns, const StateLayout &layout);

    /** Makes room for ghosts that @p layout has gained, and fetches them.
     * Collective. */
    void take_ghosts(const UnknownLayout &layout);

    /** s; of a state on a path of equilibria its arc length (m). */
    double        time = 0;
    unsigned long step = 0;
    /** Only on a path of equilibria. */
    std::optional<PathPosition> path;

    /**
     * The accepted state before this one, kept by schemes without inertia:
     * velocities and work of second order look back on it. Empty at the start
     * of a run and where loads have had a kink since.
     */
    struct Before
    {
      double time_of_loads; ///< as time_of_loads()
      /** Length of the step from there (s): differences of times would be
       * rounded, and what should be the same in all steps is not. */
      double dt;
      Vector displacement, residual;
    };
    std::optional<Before> before;

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
     * Kahan's compensation: the displacement is `displacement` and this
     * together, to twice the digits. What moves far away would else deform by
     * the round-off of its positions (see relative_displacement()).
     */
    std::optional<Vector> compensation;

    /**
     * Not 0 for free unknowns with neither mass nor constraint; known from the
     * start of a run with inertia on. Schemes that would let their
     * accelerations grow keep them in equilibrium.
     */
    std::optional<Vector> is_massless;

    /**
     * Internal + inertia - applied force. Zero to the Newton tolerance in free
     * rows; in prescribed rows the force of the support on the lattice (N, N
     * m); in rows of multipliers the constraints (m).
     */
    Vector residual;

    /**
     * Large rotations in space since rest, in the order of
     * DofNumbering::rotations().
     */
    std::vector<Quaternion> rotations;

    /** StateLayout::plane_rotations. */
    std::shared_ptr<const std::vector<int>> plane_rotations;

    /** StateLayout::space_rotations. */
    std::shared_ptr<const std::vector<std::array<int, 3>>> space_rotations;

    /** Internal variables, in the order of StateLayout::history. */
    std::vector<double> history;

    /** Energies of the whole lattice, known for accepted states. */
    Energies energies;

    /**
     * What was dissipated, taken by the scheme and done as work so far (J),
     * this rank's share, by entry of the ledger.
     */
    std::vector<double> energy_sums;

    /** @name Largest so far in the run, what errors are judged by. */
    ///@{
    double largest_force = 0; ///< Newton's force scale (N)
    /** In each owned row (N, N m), what its residual is judged by. */
    Vector largest_forces;
    double largest_energy = 0; ///< mechanical or dissipated (J)
    ///@}
  };

  /** The argument of time histories: the time (s), on a path of equilibria the
   * load factor. */
  inline double time_of_loads(const State &state)
  {
    return state.path ? state.path->load_factor : state.time;
  }
} // namespace auxfem

#endif
