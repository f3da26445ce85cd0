#ifndef auxfem_system_effect_h
#define auxfem_system_effect_h

#include <auxfem/system/tangent_matrix.h>
#include <auxfem/time/time_scheme.h>

namespace auxfem
{
  /** A step in work: from the accepted state to the trial state. */
  struct Step
  {
    const State &from;
    State       &to;
    /**
     * S; infinity in a search for static equilibrium, 0 for forces at rest in
     * time.
     */
    double dt;
  };

  /**
   * One kind of physics: struts, inertia, a group of connectors, a load. The
   * scene makes a list of these; what is not in the list costs nothing. Called
   * once per evaluation for all elements of the kind.
   */
  class Effect
  {
  public:
    virtual ~Effect() = default;

    /** True if force is linear in displacement, velocity and acceleration. */
    virtual bool is_linear() const = 0;

    /**
     * Registers the blocks, besides those of elements, in which this effect
     * couples unknowns.
     */
    virtual void register_blocks(TangentMatrix & /*matrix*/)
    {}

    /**
     * Called once when a step to time step.to.time is begun, before any
     * evaluation.
     */
    virtual void begin_step(const Step & /*step*/)
    {}

    /** Adds internal or inertia force, or minus the applied force, at step.to to @p residual (n_local entries). */
    virtual void add_residual(const Step &step, double *residual) = 0;

    /** Adds the derivative of the residual to @p matrix. */
    virtual void add_tangent(const Step & /*step*/,
                             const TangentFactors & /*factors*/,
                             TangentMatrix & /*matrix*/) const
    {}

    /**
     * Called when the step is solved: writes history, dissipated energy and
     * work of step.to from those of step.from. The step may still be undone, so
     * nothing of it may be kept in the effect itself.
     */
    virtual void accept(const Step & /*step*/)
    {}

    /** Adds this rank's energies of @p state, the state last given to add_residual(). */
    virtual void add_energies(const State & /*state*/,
                              Energies & /*energies*/) const
    {}

    /**
     * Size of the forces (N) whose last digit is uncertain in the residual when
     * displacements (m) and rotations (rad) are this large, so that machine
     * precision times this is the residual's round-off floor in one row.
     */
    virtual double round_off_scale(const double /*largest_displacement*/,
                                   const double /*largest_rotation*/) const
    {
      return 0;
    }
  };
} // namespace auxfem

#endif
