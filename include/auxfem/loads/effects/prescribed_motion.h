#ifndef auxfem_loads_effects_prescribed_motion_h
#define auxfem_loads_effects_prescribed_motion_h

#include <auxfem/equations/effect.h>
#include <auxfem/equations/equations.h>
#include <auxfem/model/lattice_model.h>

namespace auxfem
{
  /** Sets displacement, and in dynamics velocity and acceleration, of the
   * prescribed unknowns of evaluation.to. */
  void prescribe_motion(const LatticeModel &model,
                        const Evaluation   &evaluation);

  /** Whether prescribe_motion() sets all prescribed unknowns. In stages, Newton
   * iterations move rotations that are prescribed about some axes only. */
  bool prescribes_all(const LatticeModel &model, const Evaluation &evaluation);

  /** Copies velocities of unmoved prescribed unknowns from @p after to
   * @p before, states at the same time, so that no impulse acts on them. */
  void copy_fixed_support_velocities(const LatticeModel &model,
                                     const State        &after,
                                     State              &before);

  /**
   * Writes the velocity jumps of prescribed unknowns from @p before to
   * @p after, states at the same time, to the owned prescribed rows of
   * @p jumps; those of large rotations in space are spatial spins. Returns the
   * largest jump over all ranks. Collective.
   */
  double find_velocity_jumps(const LatticeModel &model,
                             const State        &before,
                             const State        &after,
                             double             *jumps);

  /**
   * Writes the right-hand side of an increment at evaluation.to to
   * @p right_side (n_owned entries): minus the residual in free rows, the
   * missing displacement or rotation in prescribed rows.
   */
  void find_right_side(const LatticeModel &model,
                       const Evaluation   &evaluation,
                       double             *right_side);

  /**
   * Writes the derivative of prescribed motions by time_of_loads() at
   * evaluation.to to their owned rows of @p derivative; that of large rotations
   * in space is a spin.
   */
  void find_motion_derivative(const LatticeModel &model,
                              const Evaluation   &evaluation,
                              double             *derivative);

  /**
   * Error bound (J) of the work of supports in a dynamic step: the part that
   * mean force times displacement misses if forces are linear and positions
   * cubic in time. Collective.
   */
  double support_work_error(const LatticeModel &model, const Evaluation &step);

  /** Whether no support ever moves. */
  bool supports_are_at_rest(const LatticeModel &model);

  /** Makes the effect that accounts the work of moved supports; it has no
   * forces. nullptr if all supports are at rest. */
  std::unique_ptr<Effect> make_support_work(const LatticeModel &model);

  /** Derivative by the load factor at evaluation.to: of loads in free rows (N,
   * N m), of support motions in prescribed ones. */
  Vector load_direction(const Equations  &equations,
                        const Evaluation &evaluation);
} // namespace auxfem

#endif
