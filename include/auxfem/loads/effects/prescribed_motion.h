#ifndef auxfem_loads_effects_prescribed_motion_h
#define auxfem_loads_effects_prescribed_motion_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/equations.h>
#include <auxfem/model/lattice_model.h>

namespace auxfem
{
  /**
   * Displacement, and in dynamics velocity and acceleration, of prescribed
   * unknowns of evaluation.to at its time.
   */
  void prescribe_motion(const LatticeModel &model,
                        const Evaluation   &evaluation);

  /** Whether that leaves nothing to iterations: rotations about some axes alone
   * move in stages with these. */
  bool prescribes_all(const LatticeModel &model, const Evaluation &evaluation);

  /**
   * Gives unknowns that supports hold still the velocities in @p before that
   * they have in @p after, a state at the same time: nothing strikes them.
   */
  void hold_still(const LatticeModel &model, const State &after, State &before);

  /**
   * By what velocities of prescribed unknowns in @p after exceed those in
   * @p before, a state at the same time, into the owned prescribed rows of
   * @p jumps; of large rotations in space as spins. Returns the largest over
   * all ranks. Collective.
   */
  double find_velocity_jumps(const LatticeModel &model,
                             const State        &before,
                             const State        &after,
                             double             *jumps);

  /**
   * Right-hand side of an increment at evaluation.to into @p right_side
   * (n_owned entries): minus the residual in free rows, in prescribed rows what
   * is missing to the prescribed displacement or rotation.
   */
  void find_right_side(const LatticeModel &model,
                       const Evaluation   &evaluation,
                       double             *right_side);

  /**
   * Derivative of what supports prescribe at evaluation.to by time_of_loads(),
   * into their owned rows of @p derivative; of large rotations in space spins.
   */
  void find_motion_derivative(const LatticeModel &model,
                              const Evaluation   &evaluation,
                              double             *derivative);

  /**
   * How far the work of supports in a step with inertia may be off (J): what
   * the mean of forces times the way leaves out where forces change evenly over
   * the step and positions are cubic. Collective.
   */
  double support_work_error(const LatticeModel &model, const Evaluation &step);

  /** Whether nothing that supports prescribe ever moves. */
  bool supports_are_at_rest(const LatticeModel &model);

  /**
   * Keeps account of the work of supports that move; they have no forces
   * besides the residual. nullptr if all are at rest.
   */
  std::unique_ptr<Effect> make_support_work(const LatticeModel &model);

  /**
   * Loads in free rows (N, N m) and motions of supports in prescribed ones, of
   * local unknowns, by which both grow with the load factor at evaluation.to.
   */
  Vector load_direction(const Equations  &equations,
                        const Evaluation &evaluation);
} // namespace auxfem

#endif
