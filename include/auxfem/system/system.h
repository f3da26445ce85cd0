#ifndef auxfem_system_system_h
#define auxfem_system_system_h

#include <auxfem/parameters/scene.h>
#include <auxfem/system/effect.h>
#include <auxfem/system/effect_decisions.h>
#include <auxfem/system/effects/connector_forces.h>
#include <auxfem/system/effects/rigid_part_conditions.h>
#include <auxfem/system/effects/struts.h>
#include <auxfem/system/joint_releases.h>
#include <auxfem/system/node_rotations.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /** A support of the scene with the unknowns it prescribes on this rank. */
  struct Support
  {
    struct PrescribedUnknown
    {
      int          unknown; ///< local number
      unsigned int component;
    };
    /** A large rotation in space of which spins are prescribed. */
    struct PrescribedRotation
    {
      unsigned int        rotation; ///< of DofNumbering::spatial_rotations()
      std::array<bool, 3> fixed;    ///< about x, y, z
      /** All three, so that its rotation vector is `motion`. */
      bool is_whole() const
      {
        return fixed[0] && fixed[1] && fixed[2];
      }
    };
    std::string                    name;
    std::vector<PrescribedUnknown> unknowns;
    /** Those whose spins are among `unknowns`. */
    std::vector<PrescribedRotation> rotations;
    /** Course of each component (m, rad). */
    std::array<TimeFunction, n_motion_components> motion;

    /** Whether an unknown is moved as part of one of `rotations`. */
    bool moves_as_rotation(const PrescribedUnknown &prescribed) const
    {
      return !rotations.empty() && prescribed.component >= first_rotation;
    }
  };

  /**
   * Norms of force rows (N), moment rows (N m) and conditions (m) of a
   * residual.
   */
  struct ResidualNorm
  {
    double force     = 0;
    double moment    = 0;
    double condition = 0;
  };

  /**
   * The lattice as a system of equations: the list of effects the scene calls
   * for, the supports, and the two questions an integrator may ask: the
   * residual and the tangent at a trial state.
   */
  class System
  {
  public:
    /**
     * Builds mesh, numbering, supports and effects of @p scene. Throws
     * InputError for contradictions only the lattice can show (a moment on a
     * joint without rotation, a component prescribed twice).
     */
    System(const Scene &scene, const Lattice &lattice, MPI_Comm communicator);

    const Lattice      &lattice() const;
    const DofNumbering &numbering() const;
    const StateLayout  &layout() const;
    /** nullptr if the scene has no struts. */
    const StrutForces *struts() const;

    /** nullptr if the scene has no rigid parts. */
    const RigidPartConditions *rigid_parts() const;

    /** Whether there are conditions with multipliers: of rigid parts, of
     * revolute hinges. */
    bool has_conditions() const;

    /** dg/dt of all conditions, as Conditions::find_rates(). */
    void find_rates(const State &state, double *rates) const;

    const std::vector<const ConnectorForces *> &connectors() const;
    const std::vector<Support>                 &supports() const;
    const std::vector<EffectDecision>          &decisions() const;
    const std::vector<Section>                 &sections() const;

    /** Whether inertia is simulated. */
    bool is_dynamic() const;

    /** Whether one tangent serves all states (for a constant step). */
    bool is_linear() const;

    /**
     * Lets states carry the second acceleration of alpha methods other than
     * Newmark.
     */
    void use_algorithmic_acceleration();

    /** The state at t = 0: at rest or with the scene's initial velocities. */
    State initial_state() const;

    /** An empty tangent with the pattern of this system. */
    std::unique_ptr<TangentMatrix> make_tangent();

    /** Sets the loads' and connectors' data for a step. */
    void begin_step(const Step &step);

    /**
     * Displacement, and in dynamics velocity and acceleration, of prescribed
     * unknowns of step.to at its time, which are differences over @p dt (s).
     */
    void prescribe_motion(const Step &step, double dt) const;

    /** Large rotations in space. */
    const NodeRotations &rotations() const;

    /**
     * Right-hand side of an increment at step.to into @p right_side (n_owned
     * entries): minus the residual in free rows, in prescribed rows what is
     * missing to the prescribed displacement or rotation.
     */
    void right_side(const Step &step, double *right_side) const;

    /** Fills step.to.residual. Returns the norm of free rows over all ranks. */
    ResidualNorm residual(const Step &step);

    /**
     * Force size against which the last residual is judged (N): norm of the
     * internal forces or of internal and inertia forces, whichever is larger,
     * prescribed rows included, moments divided by length_scale().
     */
    double force_scale() const;

    /** Mean strut length (m), ties moments to forces in tests. */
    double length_scale() const;

    /** Norm (N) below which the residual at @p state is round-off. */
    double round_off_floor(const State &state) const;

    /**
     * Norm (m) up to which the conditions are met: their round-off. A looser
     * tolerance would return as forces, divided by the square of the step.
     */
    double condition_tolerance(const State &state) const;

    /** Fills @p matrix with the tangent at step.to. */
    void tangent(const Step           &step,
                 const TangentFactors &factors,
                 TangentMatrix        &matrix) const;

    /**
     * Completes step.to, the state last given to residual(), with history, work
     * and energies. The step may still be undone.
     */
    void accept(const Step &step);

    /**
     * Largest |displacement| (m) and |rotation| (rad) over all ranks in
     * @p motion, displacements or an increment of them.
     */
    std::pair<double, double> largest_motion(const Vector &motion) const;

    /** Unknown with the largest free residual, in words, over all ranks. */
    std::string worst_unknown(const State &state) const;

  private:
    /**
     * Multipliers have no inertia: their rates, by-products of the integrator,
     * must not enter its next prediction.
     */
    void hold_multipliers(State &state) const;

    /** Work of prescribed motion in a step, this rank's share (J). */
    double support_work(const Step &step) const;

    /** Energies (over all ranks) of the state last given to residual(). */
    Energies energies(const State &state) const;

    void make_numbering(const Scene               &scene,
                        std::vector<JointRelease> &releases,
                        MPI_Comm                   communicator);
    void make_supports(const Scene &scene);
    void group_rotations(Support &support) const;
    void make_conditions(const Scene                     &scene,
                         const std::vector<JointRelease> &releases,
                         const RigidBodies               &bodies);
    void make_effects(const Scene                     &scene,
                      const std::vector<JointRelease> &releases);

    const Lattice                       &graph;
    SimulatedEffects                     simulated;
    std::unique_ptr<DofNumbering>        dofs;
    std::unique_ptr<NodeRotations>       node_rotations;
    std::vector<std::unique_ptr<Effect>> effects;
    /**
     * The first n_internal effects are internal forces: their sum is the force
     * scale.
     */
    unsigned int n_internal = 0;
    /**
     * The first n_balanced effects are internal and inertia forces; the rest
     * are loads.
     */
    unsigned int                         n_balanced = 0;
    OwnedRows                            rows;
    std::vector<const ConnectorForces *> connector_groups;
    const StrutForces                   *strut_forces = nullptr;
    const RigidPartConditions           *parts        = nullptr;
    std::vector<const Conditions *>      conditions;
    std::vector<Support>                 support_list;
    std::vector<Section>                 section_list;
    StateLayout                          state_layout;
    /** Local unknown, value. */
    std::vector<std::pair<int, double>> initial_velocities;
    double                              mean_length = 1;
    double                              scale       = 0;
  };
} // namespace auxfem

#endif
